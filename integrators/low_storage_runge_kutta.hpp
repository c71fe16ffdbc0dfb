// Explicit Runge-Kutta in the 2N form of Williamson: two registers beside the slope, however many stages.
#pragma once

#include "integrators/explicit_runge_kutta.hpp"

namespace odemark {

template <const auto& method, System P>
class LowStorageStepper;

/// d_i = carry_i d_(i-1) + h f(u_(i-1)), u_i = u_(i-1) + gain_i d_i, from u_0 = y; carry_0 = 0. The old state
/// is kept besides, because an attempt must leave it alone. J. H. Williamson, J. Comput. Phys. 35 (1980)
/// 48-56.
template <std::size_t Stages>
struct LowStorageRungeKutta {
  static constexpr std::string_view kind_name = "low-storage Runge-Kutta";
  static constexpr unsigned needs = 0;
  static constexpr std::size_t stages = Stages;

  std::string_view id, source, note = "", advice = "";
  int order;
  int embedded_order = 0;
  std::array<Coefficient, Stages> carry{}, gain{};

  /// The same method in Butcher's form: every coefficient of d_i in k_j is a product of carries.
  constexpr ExplicitRungeKutta<Stages> tableau() const {
    ExplicitRungeKutta<Stages> out{.id = id, .source = source, .order = order};
    for (std::size_t j = 0; j < Stages; ++j) {
      Coefficient share = 1, sum = 0;  // of k_j in d_l, and in u_(l+1)
      for (std::size_t l = j; l < Stages; ++l) {
        if (l > j) share *= carry[l];
        sum += gain[l] * share;
        (l + 1 < Stages ? out.a[l + 1][j] : out.b[j]) = sum;
      }
    }
    return out;
  }
  Theory theory() const { return tableau().theory(); }

  template <const auto& method, System P>
  using Stepper = LowStorageStepper<method, P>;
};

template <const auto& method, System P>
class LowStorageStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  LowStorageStepper(const P& system, const State& model)
      : system_(system), change_(blank_like(model)), slope_(blank_like(model)) {}

  void start() {}
  void accept() {}

  [[gnu::always_inline]] StepStatus attempt(Real t, const State& y, Real h, State& next, State&) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (evaluate_stage<I>(t, y, h, next), ...); }
    (std::make_index_sequence<method.stages>{});
    return StepStatus::ok;
  }

 private:
  template <std::size_t I>
  [[gnu::always_inline]] void evaluate_stage(Real t, const State& y, Real h, State& next) {
    constexpr Real gain = static_cast<Real>(method.gain[I]);
    constexpr Real node = static_cast<Real>(method.tableau().c(I));
    if constexpr (I == 0)
      system_.rhs(t, y, slope_);
    else
      system_.rhs(t + node * h, next, slope_);
    for_each_component(y, [&](std::size_t i) {
      if constexpr (I == 0) {
        change_.data()[i] = h * slope_.data()[i];
        next.data()[i] = y.data()[i] + gain * change_.data()[i];
      } else {
        change_.data()[i] = static_cast<Real>(method.carry[I]) * change_.data()[i] + h * slope_.data()[i];
        next.data()[i] = next.data()[i] + gain * change_.data()[i];
      }
    });
  }

  const P& system_;
  State change_, slope_;
};

}  // namespace odemark
