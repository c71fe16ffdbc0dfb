// Splitting of x'' = a(t, x, v): a row of drifts and kicks, one engine. Symplectic where a does not depend on
// v.
#pragma once

#include "integrators/compensated.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, SecondOrderSystem P>
class SplittingStepper;

/// One step is drift[0], kick[0], drift[1], kick[1], ... in units of h; zeros are skipped. A kick uses the
/// velocity of the moment, so where a force depends on velocity this is no composition of exact flows (game
/// code does just this); the id or note then says which velocity that is.
template <std::size_t Length>
struct Splitting {
  static constexpr std::string_view kind_name = "splitting";
  static constexpr unsigned needs = Ability::second_order;
  static constexpr std::size_t length = Length;

  std::string_view id, source;
  int order;
  int embedded_order = 0;
  std::array<Coefficient, Length> drift{}, kick{};
  std::string_view note = "", advice = "";

  constexpr bool consistent() const {
    Coefficient drifts = 0, kicks = 0;
    for (std::size_t i = 0; i < Length; ++i) drifts += drift[i], kicks += kick[i];
    auto is_one = [](Coefficient x) { return x - 1 <= 1e-18L && x - 1 >= -1e-18L; };
    return is_one(drifts) && is_one(kicks);
  }
  /// The step ends with a kick and the next begins with one at the same place: one evaluation serves both.
  constexpr bool last_kick_is_next_first() const {
    return drift[0] == 0 && kick[0] != 0 && kick[Length - 1] != 0 && Length > 1;
  }
  Theory theory() const {
    Theory theory;
    for (std::size_t i = 0; i < Length; ++i) {
      if (drift[i] != 0) theory.moves.push_back({SecondOrderMove::What::drift, drift[i]});
      if (kick[i] != 0) theory.moves.push_back({SecondOrderMove::What::kick, kick[i]});
    }
    theory.proof = [m = *this] {
      return ProvedOrders{splitting_order(m, m.order + 1), 0, separable_order(m, m.order + 1)};
    };
    return theory;
  }

  template <const auto& method, SecondOrderSystem P>
  using Stepper = SplittingStepper<method, P>;
};

template <const auto& method, SecondOrderSystem P>
class SplittingStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  SplittingStepper(const P& system, const State& model)
      : system_(system),
        half_(size_of(model) / 2),
        a_(zeros_like(model)),
        first_(zeros_like(model)),
        moving_carry_(zeros_like(model)) {}

  void start() { known_ = false, ends_known_ = false; }
  void accept() {
    known_ = ends_known_;
    if constexpr (method.last_kick_is_next_first()) std::swap(first_, a_);
  }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State&) {
    next = y;
    run(t, h, next, [](State& s, std::size_t i, Real increment) { s.data()[i] += increment; });
    return StepStatus::ok;
  }

  StepStatus attempt_compensated(Real t, const State& y, const State& carry, Real h, State& next,
                                 State& next_carry) {
    next = y;
    moving_carry_ = carry;
    run(t, h, next, [&](State& s, std::size_t i, Real increment) {
      const Real addend = increment + moving_carry_.data()[i], sum = s.data()[i] + addend;
      const Real rounded = sum - s.data()[i];
      moving_carry_.data()[i] = (s.data()[i] - (sum - rounded)) + (addend - rounded);
      s.data()[i] = sum;
    });
    next_carry = moving_carry_;
    return StepStatus::ok;
  }

 private:
  template <class Add>
  [[gnu::always_inline]] void run(Real t, Real h, State& y, Add&& add) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (substep<I>(t, h, y, add), ...); }
    (std::make_index_sequence<method.length>{});
    if constexpr (method.last_kick_is_next_first()) ends_known_ = !system_.force_depends_on_velocity();
  }

  template <std::size_t I, class Add>
  [[gnu::always_inline]] void substep(Real& t, Real h, State& y, Add& add) {
    constexpr Real drift = static_cast<Real>(method.drift[I]), kick = static_cast<Real>(method.kick[I]);
    if constexpr (method.drift[I] != 0) {
      const Real w = drift * h;
      for_half([&](std::size_t i) { add(y, i, w * y.data()[half() + i]); });
      t += w;
    }
    if constexpr (method.kick[I] != 0) {
      // the force at the start outlives the step's own: a rejected attempt must not take it away
      constexpr bool is_first = I == 0 && method.last_kick_is_next_first();
      State& a = is_first ? first_ : a_;
      if (!(is_first && known_)) system_.acceleration(t, y, a.data());
      if constexpr (is_first) known_ = true;
      const Real w = kick * h;
      for_half([&](std::size_t i) { add(y, half() + i, w * a.data()[i]); });
    }
  }

  std::size_t half() const {
    if constexpr (fixed_size < State >> 0)
      return fixed_size<State> / 2;
    else
      return half_;
  }
  template <class F>
  [[gnu::always_inline]] void for_half(F&& f) const {
    if constexpr (fixed_size < State >> 0 && fixed_size<State> <= 16) {
      [&]<std::size_t... I>(std::index_sequence<I...>) { (f(I), ...); }
      (std::make_index_sequence<fixed_size<State> / 2>{});
    } else {
      for (std::size_t i = 0; i < half_; ++i) f(i);
    }
  }

  const P& system_;
  std::size_t half_;
  State a_, first_, moving_carry_;  // acceleration of this kick; at the start of the step, where known_
  bool known_ = false, ends_known_ = false;
};

}  // namespace odemark

#include "integrators/splitting_order.hpp"
