// What multistep steppers share: rings of past slopes and states, and the starter that fills them.
#pragma once

#include "integrators/multistep.hpp"

namespace odemark {

/// Holds f_n, f_{n-1}, ... and y_n, y_{n-1}, ..., as many as the method looks at. The places of n are written
/// by every attempt and become history when it is accepted, so that a rejected attempt leaves no trace.
template <const auto& method, System P>
class MultistepHistory {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;
  using Starter = typename KindOf<method>::template Starter<P>;

  MultistepHistory(const P& system, const State& model) : system_(system), starter_(system, model) {
    slopes_.fill(zeros_like(model));
    states_.fill(zeros_like(model));
  }

  void start() { known_ = 0, slope_now_ = 0, state_now_ = 0, starter_.start(); }
  void accept() {
    if (starting()) ++known_, starter_.start();
    if constexpr (slope_places > 0) slope_now_ = (slope_now_ + 1) % slope_places;
    if constexpr (past_states > 0) state_now_ = (state_now_ + 1) % (past_states + 1);
  }

  std::size_t history_length() const { return past_slopes + past_states; }
  State& history(std::size_t k) {
    if constexpr (past_slopes > 0)
      if (k < past_slopes) return slope(k + 1);
    return state(k - past_slopes + 1);
  }
  void assume_history() { known_ = std::max(past_slopes, past_states); }

 protected:
  static constexpr std::size_t past_states = method.past_states();
  static constexpr std::size_t slope_places = method.slope_count();
  static constexpr std::size_t past_slopes = slope_places > 0 ? slope_places - 1 : 0;

  bool starting() const { return known_ < std::max(past_slopes, past_states); }
  State& slope(std::size_t j) { return slopes_[(slope_now_ + slope_places - j) % slope_places]; }
  State& state(std::size_t j) { return states_[(state_now_ + past_states + 1 - j) % (past_states + 1)]; }

  void look(Real t, const State& y) {
    if constexpr (slope_places > 0) system_.rhs(t, y, slope(0));
    if constexpr (past_states > 0) state(0) = y;
  }

  /// out = base + the weighted slopes of a formula, the newest last: only the last addition waits for it.
  /// `Formula` is a type with a constexpr member `formula`.
  template <class Formula, class Base>
  void add_slopes(const State& y, Real h, State& out, const Base& base) {
    constexpr auto used = nonzero_weights<SlopeWeights<Formula>, slope_places>();
    [&]<std::size_t... U>(std::index_sequence<U...>) {
      constexpr std::size_t last = used.size() - 1;
      const std::array<Real, used.size()> scaled{
          h * static_cast<Real>(Formula::formula.slopes[used[last - U]])...};
      const std::array<const State*, used.size()> slopes{&slope(used[last - U])...};
      for_each_component(y, [&](std::size_t i) {
        auto sum = base(i);
        ((sum = sum + scaled[U] * slopes[U]->data()[i]), ...);
        out.data()[i] = sum;
      });
    }
    (std::make_index_sequence<used.size()>{});
  }

  /// What a formula makes of the past: everything but its term in f_{n+1}.
  template <class Formula>
  void combine_past(const State& y, Real h, State& out) {
    constexpr auto used = nonzero_weights<StateWeights<Formula>, past_states + 1>();
    static_assert(used.size() > 0);
    if constexpr (used.size() == 1 && Formula::formula.states[used[0]] == 1) {
      const State& from = used[0] == 0 ? y : state(used[0]);
      add_slopes<Formula>(y, h, out, [&](std::size_t i) { return from.data()[i]; });
    } else {
      [&]<std::size_t... U>(std::index_sequence<U...>) {
        constexpr std::size_t last = used.size() - 1;
        const std::array<const State*, used.size()> states{&state(used[last - U])...};
        add_slopes<Formula>(y, h, out, [&](std::size_t i) {
          return (... + (static_cast<Real>(Formula::formula.states[used[last - U]]) * states[U]->data()[i]));
        });
      }
      (std::make_index_sequence<used.size()>{});
    }
  }

  const P& system_;
  Starter starter_;

 private:
  template <class Formula>
  struct SlopeWeights {
    static constexpr Coefficient value(std::size_t j) { return Formula::formula.slopes[j]; }
  };
  template <class Formula>
  struct StateWeights {
    static constexpr Coefficient value(std::size_t j) { return Formula::formula.states[j]; }
  };

  std::array<State, slope_places> slopes_;
  std::array<State, past_states + 1> states_;
  std::size_t known_ = 0, slope_now_ = 0, state_now_ = 0;
};

}  // namespace odemark
