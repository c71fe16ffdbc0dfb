#include "integrators/lowered_order.hpp"

#include <algorithm>
#include <cmath>

#include "integrators/linear_stability_parts.hpp"

namespace odemark {

namespace {

/// What one step of h leaves of trace and determinant of the exact flow: invariants, so that it does not
/// matter which velocity a method carries along and which it reports.
Coefficient defect(const Theory& theory, Coefficient h) {
  constexpr Coefficient stiffness = 1, damping = 0.5L;
  const auto m = second_order_matrix(theory, stiffness, damping, h);
  if (m.size() != 4) return 0;
  const Coefficient rate = std::sqrt(stiffness - damping * damping / 4), left = std::exp(-damping * h / 2);
  return std::max(std::abs(m[0] + m[3] - 2 * left * std::cos(rate * h)),
                  std::abs(m[0] * m[3] - m[1] * m[2] - left * left));
}

}  // namespace

int order_with_damping(const Theory& theory, int claimed) {
  if (!detail::is_second_order(theory) || !theory.oscillator.xx.empty()) return claimed;
  constexpr Coefficient h = 1.0L / 64;
  const Coefficient coarse = defect(theory, h), fine = defect(theory, h / 2);
  if (!(fine > 1e-17L)) return claimed;  // rounding: no lower order leaves so little
  return std::clamp(static_cast<int>(std::lround(std::log2(coarse / fine))) - 1, 0, claimed);
}

bool is_weakly_stable(const Theory& theory) {
  if (!detail::is_multistep(theory)) return false;
  const auto rho = detail::characteristic_of(theory)[0];
  const auto roots = polynomial_roots({rho.begin(), rho.end()});
  return std::count_if(roots.begin(), roots.end(),
                       [](const WideComplex& w) { return std::abs(w) > 1 - 1e-6L; }) > 1;
}

}  // namespace odemark
