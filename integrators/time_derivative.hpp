// df/dt at (t, y): the system's own, or a forward difference where it has none.
#pragma once

#include <cmath>
#include <limits>

#include "integrators/system.hpp"

namespace odemark {

template <class P>
concept HasTimeDerivative = System<P> &&
    requires(const P& p, RealOf<typename P::State> t, const typename P::State& y, typename P::State& out) {
  p.time_derivative(t, y, out);
};

/// True where the system says that f does not depend on t: its derivative is then not asked for.
template <System P>
constexpr bool is_autonomous(const P& system) {
  if constexpr (requires { static_cast<bool>(system.autonomous); })
    return static_cast<bool>(system.autonomous);
  else
    return false;
}

/// `slope` is f(t, y), which the caller has anyway; `h` says what is a small change of time where t is 0. One
/// evaluation. The difference leaves an error of the square root of the unit roundoff, times h in the
/// solution.
template <System P>
[[gnu::always_inline]] inline void evaluate_time_derivative(const P& system, RealOf<typename P::State> t,
                                                            RealOf<typename P::State> h,
                                                            const typename P::State& y,
                                                            const typename P::State& slope,
                                                            typename P::State& out) {
  using Real = RealOf<typename P::State>;
  if constexpr (HasTimeDerivative<P>) {
    system.time_derivative(t, y, out);
  } else {
    const Real wished = std::sqrt(std::numeric_limits<Real>::epsilon()) * (std::abs(t) > h ? std::abs(t) : h);
    const Real later = t + wished, step = later - t;  // the step that was representable
    system.rhs(later, y, out);
    for_each_component(y, [&](std::size_t i) { out.data()[i] = (out.data()[i] - slope.data()[i]) / step; });
  }
}

}  // namespace odemark
