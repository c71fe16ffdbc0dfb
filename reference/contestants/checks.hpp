// What the checks of the libraries share: a problem that shows orders, and where each provider adds its
// checks.
#pragma once

#include "reference/contestants/adapter.hpp"
#include "reference/library_checks.hpp"

namespace odemark::contestant {

void add_sundials_checks(std::vector<LibraryCheck>& checks);
void add_odeint_checks(std::vector<LibraryCheck>& checks);

/// Debian's N_VLinearSum against the same loop in this binary; 0 where this binary is not optimised itself.
double sundials_slowdown();

/// x'' = -sin x - 0.2 x'^2 + forcing cos 1.3 t: nonlinear, and time-dependent where forced.
inline ErasedSystem<double> forced_pendulum(const double* forcing) {
  ErasedSystem<double> system;
  system.self = forcing;
  system.size = 2;
  system.abilities = Ability::jacobian | Ability::moderate_size | Ability::second_order;
  system.rhs_call = [](const void* p, double t, const double* y, double* dydt) {
    dydt[0] = y[1];
    dydt[1] = -std::sin(y[0]) - 0.2 * y[1] * y[1] + *static_cast<const double*>(p) * std::cos(1.3 * t);
  };
  system.acceleration_call = [](const void* p, double t, const double* y, double* a) {
    *a = -std::sin(y[0]) - 0.2 * y[1] * y[1] + *static_cast<const double*>(p) * std::cos(1.3 * t);
  };
  system.jacobian_call = [](const void*, double, const double* y, double* j) {
    j[0] = 0, j[1] = -std::cos(y[0]), j[2] = 1, j[3] = -0.4 * y[1];
  };
  return system;
}

/// Order seen between `steps` and 2 `steps` fixed steps to t = 3, against `reference` with many more.
inline double observed_order(const AnyMethod& method, const AnyMethod& reference, double forcing,
                             long steps) {
  const auto system = forced_pendulum(&forcing);
  const auto end = [&](const AnyMethod& m, long count) {
    std::vector<double> y{1, 0};
    m.runs<double>().solve(system, FixedSteps{count}, 0, 3, y);
    return y;
  };
  const auto truth = end(reference, 4000);
  const auto error = [&](long count) {
    const auto y = end(method, count);
    return std::hypot(y[0] - truth[0], y[1] - truth[1]);
  };
  return std::log2(error(steps) / error(2 * steps));
}

inline std::string two_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

}  // namespace odemark::contestant
