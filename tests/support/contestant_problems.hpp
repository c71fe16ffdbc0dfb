// Small erased problems on which third-party solvers are run: one with a known solution, others that break.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "problems/damped_spring.hpp"
#include "problems/oscillator.hpp"
#include "reference/contestants.hpp"
#include "reference/make_family.hpp"
#include "tests/support/print_method.hpp"

namespace odemark {

namespace probe {

using Erased = ErasedSystem<double>;

/// Nonlinear, velocity-dependent and driven; started at (0, 1) its solution is x = sin t.
inline Erased driven() {
  Erased s;
  s.size = 2, s.abilities = Ability::jacobian | Ability::moderate_size | Ability::second_order;
  s.acceleration_call = [](const void*, double t, const double* y, double* a) {
    const double si = std::sin(t), co = std::cos(t);
    *a = -y[0] - y[0] * y[0] * y[0] + si * si * si - 0.2 * (y[1] * y[1] - co * co);
  };
  s.rhs_call = [](const void*, double t, const double* y, double* d) {
    d[0] = y[1];
    driven().acceleration_call(nullptr, t, y, d + 1);
  };
  s.jacobian_call = [](const void*, double, const double* y, double* j) {
    j[0] = 0, j[1] = -1 - 3 * y[0] * y[0], j[2] = 1, j[3] = -0.4 * y[1];
  };
  return s;
}

/// y' = -y until t = 1, then NaN.
inline Erased nan_after_one() {
  Erased s;
  s.size = 1, s.abilities = Ability::jacobian | Ability::moderate_size;
  s.rhs_call = [](const void*, double t, const double* y, double* d) { d[0] = t > 1 ? std::nan("") : -y[0]; };
  s.jacobian_call = [](const void*, double, const double*, double* j) { j[0] = -1; };
  return s;
}

/// y' = -y until t = 1, then an exception.
inline Erased throwing_after_one() {
  Erased s = nan_after_one();
  s.rhs_call = [](const void*, double t, const double* y, double* d) {
    if (t > 1) throw std::domain_error("beyond 1");
    d[0] = -y[0];
  };
  return s;
}

/// y' = y^2 from 1 has no solution beyond t = 1.
inline Erased blowing_up() {
  Erased s = nan_after_one();
  s.rhs_call = [](const void*, double, const double* y, double* d) { d[0] = y[0] * y[0]; };
  s.jacobian_call = [](const void*, double, const double* y, double* j) { j[0] = 2 * y[0]; };
  return s;
}

inline Erased nan_jacobian() {
  Erased s = driven();
  s.jacobian_call = [](const void*, double, const double*, double* j) { std::fill(j, j + 4, std::nan("")); };
  return s;
}

inline bool can_run(const AnyMethod& m, const Erased& s) {
  return missing_ability(m.needs, s.abilities).empty();
}

struct End {
  std::vector<double> y;
  RunReport report;
  WorkCounts work;
  bool threw = false;
};

inline End solve(const AnyMethod& m, const Erased& s, const Control& control, double t1,
                 std::vector<double> y, Trace<double>* trace = nullptr) {
  End end{std::move(y), {}, {}, false};
  const CountingSystem<double> counting(s, end.work);
  const auto& runs = m.runs<double>();
  try {
    end.report = trace ? runs.solve_traced(counting.view(), s, control, 0, t1, end.y, *trace)
                       : runs.solve(counting.view(), control, 0, t1, end.y);
  } catch (const std::domain_error&) {
    end.threw = true;
  }
  return end;
}

/// Every contestant that takes this kind of control and can run the problem.
template <class F>
void for_each_contestant(const Erased& s, bool fixed, F&& f) {
  for (const auto& method : contestants()) {
    if (!(fixed ? method.takes_fixed_steps : method.takes_error_control) || !can_run(method, s)) continue;
    SCOPED_TRACE(method.id);
    f(method);
  }
}

}  // namespace probe
}  // namespace odemark
