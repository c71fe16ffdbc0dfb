// Reads the stability function R(z) off a solver itself, by one step of a problem whose Jacobian is
// nilpotent.
#pragma once

#include "reference/contestants/adapter.hpp"

namespace odemark::contestant {

/// y_i' = y_{i+1}: the Jacobian N shifts. One step h = 1 from the last unit vector gives R(N) e_n, whose
/// components are the Taylor coefficients of R, highest power first.
inline ErasedSystem<double> shift_system(std::size_t size, const std::size_t* stored_size) {
  ErasedSystem<double> system;
  system.self = stored_size;
  system.size = size;
  system.abilities = Ability::jacobian | Ability::moderate_size;
  system.rhs_call = [](const void* p, double, const double* y, double* dydt) {
    const std::size_t n = *static_cast<const std::size_t*>(p);
    for (std::size_t i = 0; i + 1 < n; ++i) dydt[i] = y[i + 1];
    dydt[n - 1] = 0;
  };
  system.jacobian_call = [](const void* p, double, const double*, double* j) {
    const std::size_t n = *static_cast<const std::size_t*>(p);
    std::fill(j, j + n * n, 0.0);
    for (std::size_t i = 0; i + 1 < n; ++i) j[(i + 1) * n + i] = 1;
  };
  return system;
}

using Polynomial = std::vector<Coefficient>;

inline Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial out(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) out[i + j] += a[i] * b[j];
  return out;
}

inline Polynomial power(const Polynomial& a, int exponent) {
  Polynomial out{1};
  for (int k = 0; k < exponent; ++k) out = product(out, a);
  return out;
}

/// R = numerator / denominator where the denominator is known (1 for an explicit method) and the numerator
/// has at most `degree`. Exact to rounding: what is plotted is what the library steps with.
template <RunReport (*run)(const Job&)>
Theory probed_theory(std::size_t degree, const Polynomial& denominator = {1}) {
  const std::size_t size = degree + 1;
  const auto system = shift_system(size, &size);
  std::vector<double> y(size, 0.0);
  y.back() = 1;
  const Control one_step = FixedSteps{1};
  const auto report = run(Job{system, nullptr, one_step, 0, 1, y, nullptr});
  if (report.status != RunStatus::reached_end) return no_theory("its step could not be probed");
  Polynomial series(y.rbegin(), y.rend());
  Theory theory;
  theory.numerator = product(series, denominator);
  theory.numerator.resize(size);
  theory.denominator = denominator;
  while (theory.numerator.size() > 1 && std::abs(theory.numerator.back()) < 1e-15L)
    theory.numerator.pop_back();
  return theory;
}

}  // namespace odemark::contestant
