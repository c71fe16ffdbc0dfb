// What a benchmark problem tells the suite about itself. Mathematics first, nothing about integrators.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace odemark {

/// Where a parameter may lie. Bounds are inclusive unless they are `open`.
struct Range {
  double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();
  bool open_below = false, open_above = false;
  bool whole = false;  // a count
};
inline constexpr Range any_number{};
inline constexpr Range positive{.lowest = 0, .open_below = true};
inline constexpr Range not_negative{.lowest = 0};

template <class Family, class Real>
struct Parameter {
  std::string_view name, unit, meaning;
  Real Family::*member;
  Range range = any_number;
};

/// A convenient way to say a parameter in other words: zeta for c. Applied after all parameters, in order.
template <class Family, class Real>
struct Shorthand {
  std::string_view name, unit, meaning;
  void (*apply)(Family&, const Real& value);
  Range range = any_number;
};

/// One component of the state.
struct Component {
  std::string_view name, unit;
};

/// A named set of parameters, written as a user would set them: "e=0.6,t_end=20".
struct Preset {
  std::string_view id, settings, about;
};

/// How far from the diagonal a Jacobian has entries; of a second-order problem: how far apart masses feel
/// each other's position and velocity. What lies outside is never written.
struct Bandwidth {
  std::size_t lower, upper;
};

/// Amplitude and phase angle (radians, growing with time) of a state on an oscillation.
struct Oscillation {
  double amplitude, phase;
  double rate = 0;  // of the exact solution, rad/s
};

/// `before` until the instant `at`, `after` from then on: a force that is switched by the clock. Fixed steps
/// walk over the instant, so this reads the time it is given. A number without an order (a recording, a pack
/// of lanes) may overload it in its own namespace; otherwise it can only be asked about a switch that lies
/// infinitely far away, which is what a family's `during(phase)` makes of it.
template <class T, class Real>
T step_at(const T& t, const Real& at, const Real& before, const Real& after) {
  if constexpr (requires { bool(t < T(at)); }) {
    return t < T(at) ? T(before) : T(after);
  } else {
    if (at - at == 0)
      throw std::logic_error("a switch in time cannot be recorded: stop there and use during(phase)");
    return T(at > 0 ? before : after);
  }
}

}  // namespace odemark
