// odeint on std::array states with a right-hand side the compiler can inline: what users of its fast path
// write.
#pragma once

#include <array>
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/algebra/range_algebra.hpp>
#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4_classic.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <string_view>

namespace odemark {

/// Algebra is boost::numeric::odeint::array_algebra (what odeint picks for std::array) or range_algebra.
template <std::size_t N, class Algebra = boost::numeric::odeint::array_algebra>
struct OdeintStatic {
  using State = std::array<double, N>;
  using Euler = boost::numeric::odeint::euler<State, double, State, double, Algebra>;
  using RungeKutta4 = boost::numeric::odeint::runge_kutta4<State, double, State, double, Algebra>;
  using RungeKutta4Classic =
      boost::numeric::odeint::runge_kutta4_classic<State, double, State, double, Algebra>;
  using DormandPrince5 = boost::numeric::odeint::runge_kutta_dopri5<State, double, State, double, Algebra>;
};

/// `count` steps of h from t0; `rhs(y, dydt, t)` is odeint's order of arguments. A fresh stepper, so that
/// first-same-as-last starts cold.
template <class Stepper, class Rhs, class State>
void odeint_fixed_steps(const Rhs& rhs, State& y, double t0, double h, long count) {
  Stepper stepper;
  for (long n = 0; n < count; ++n) stepper.do_step(std::cref(rhs), y, t0 + double(n) * h, h);
}

}  // namespace odemark
