// Explicit Nystrom methods for x'' = a(t, x): stages are positions, their slopes accelerations.
#pragma once

#include "integrators/compensated.hpp"
#include "integrators/nystrom_order.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, SecondOrderSystem P>
class NystromStepper;

/// X_i = x + c_i h v + h^2 sum_j a_ij k_j with k_i = a(t + c_i h, X_i); the new position is x + h v + h^2 sum
/// b_position k, the new velocity v + h sum b_velocity k (HNW I, II.14). What depends on velocity is not its
/// business. The estimate is the difference to the embedded weights in both.
template <std::size_t Stages>
struct Nystrom {
  static constexpr std::string_view kind_name = "Nystrom";
  static constexpr unsigned needs = Ability::second_order | Ability::separable;
  static constexpr std::size_t stages = Stages;
  using Row = std::array<Coefficient, Stages>;

  std::string_view id, source;
  int order;
  int embedded_order = 0;
  Row c{};
  std::array<Row, Stages> a{};
  Row b_position{}, b_velocity{}, b_position_embedded{}, b_velocity_embedded{};
  std::string_view note = "", advice = "";

  /// The last stage is the new position: its acceleration is the first of the next step.
  constexpr bool first_same_as_last() const {
    return Stages > 1 && c[Stages - 1] == 1 && a[Stages - 1] == b_position && c[0] == 0;
  }
  Theory theory() const {
    NystromTableau t{.stages = Stages,
                     .c = as_data(c),
                     .a = as_data(a),
                     .b_position = as_data(b_position),
                     .b_velocity = as_data(b_velocity),
                     .b_position_embedded{},
                     .b_velocity_embedded{}};
    if (embedded_order > 0) {
      t.b_position_embedded = as_data(b_position_embedded);
      t.b_velocity_embedded = as_data(b_velocity_embedded);
    }
    Theory theory = nystrom_theory(std::move(t));
    theory.proof = [m = *this] { return proved_orders(m); };
    return theory;
  }

  template <const auto& method, SecondOrderSystem P>
  using Stepper = NystromStepper<method, P>;
};

template <const auto& method, SecondOrderSystem P>
class NystromStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  NystromStepper(const P& system, const State& model)
      : system_(system), half_(size_of(model) / 2), stage_(model), increment_(zeros_like(model)) {
    accelerations_.fill(zeros_like(model));
  }

  void start() { known_ = false; }
  void accept() {
    if constexpr (method.first_same_as_last()) {
      std::swap(accelerations_[0], accelerations_[method.stages - 1]);
      known_ = true;
    }
  }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    find_accelerations(t, y, h);
    for (std::size_t i = 0; i < half_; ++i) {
      const Real v = y.data()[half_ + i];
      next.data()[i] = y.data()[i] + h * (v + h * weighted<Position>(i));
      next.data()[half_ + i] = v + h * weighted<Velocity>(i);
    }
    if constexpr (method.embedded_order > 0)
      for (std::size_t i = 0; i < half_; ++i) {
        error.data()[i] = h * (h * weighted<PositionError>(i));
        error.data()[half_ + i] = h * weighted<VelocityError>(i);
      }
    return StepStatus::ok;
  }

  StepStatus attempt_compensated(Real t, const State& y, const State& carry, Real h, State& next,
                                 State& next_carry) {
    find_accelerations(t, y, h);
    for (std::size_t i = 0; i < half_; ++i) {
      // the velocity that moves the position includes what it could not hold
      const Real v = y.data()[half_ + i];
      increment_.data()[i] = h * (v + (carry.data()[half_ + i] + h * weighted<Position>(i)));
      increment_.data()[half_ + i] = h * weighted<Velocity>(i);
    }
    add_compensated(y, carry, increment_, next, next_carry);
    return StepStatus::ok;
  }

 private:
  template <std::size_t I>
  struct Row {
    static constexpr Coefficient value(std::size_t j) { return method.a[I][j]; }
  };
  struct Position {
    static constexpr Coefficient value(std::size_t j) { return method.b_position[j]; }
  };
  struct Velocity {
    static constexpr Coefficient value(std::size_t j) { return method.b_velocity[j]; }
  };
  struct PositionError {
    static constexpr Coefficient value(std::size_t j) {
      return method.b_position[j] - method.b_position_embedded[j];
    }
  };
  struct VelocityError {
    static constexpr Coefficient value(std::size_t j) {
      return method.b_velocity[j] - method.b_velocity_embedded[j];
    }
  };

  template <class Weights>
  [[gnu::always_inline]] Real weighted(std::size_t i) const {
    constexpr auto used = nonzero_weights<Weights, method.stages>();
    Real sum = 0;
    [&]<std::size_t... N>(std::index_sequence<N...>) {
      ((sum += static_cast<Real>(Weights::value(used[N])) * accelerations_[used[N]].data()[i]), ...);
    }
    (std::make_index_sequence<used.size()>{});
    return sum;
  }

  void find_accelerations(Real t, const State& y, Real h) {
    stage_ = y;
    [&]<std::size_t... I>(std::index_sequence<I...>) { (find_acceleration<I>(t, y, h), ...); }
    (std::make_index_sequence<method.stages>{});
  }

  template <std::size_t I>
  [[gnu::always_inline]] void find_acceleration(Real t, const State& y, Real h) {
    if constexpr (I == 0 && method.first_same_as_last())
      if (known_) return;
    constexpr Real node = static_cast<Real>(method.c[I]);
    if constexpr (I > 0 || method.c[0] != 0)
      for (std::size_t i = 0; i < half_; ++i) {
        // written as in attempt(), so that a last stage that is the new position is it to the last bit
        stage_.data()[i] = y.data()[i] + h * (node * y.data()[half_ + i] + h * weighted<Row<I>>(i));
      }
    system_.acceleration(t + node * h, stage_, accelerations_[I].data());
    if constexpr (I == 0 && method.first_same_as_last()) known_ = true;
  }

  const P& system_;
  std::size_t half_;
  State stage_, increment_;  // stage_ keeps the velocity of the start, which no acceleration looks at
  std::array<State, method.stages> accelerations_;
  bool known_ = false;  // accelerations_[0] is that of (t, y)
};

}  // namespace odemark
