// The formulas of a BDF in backward differences on equal steps, and how differences change with the step.
#pragma once

#include "integrators/stepper.hpp"

namespace odemark {

/// L. F. Shampine, M. W. Reichelt, SIAM J. Sci. Comput. 18 (1997) 1-22, section 2; Hairer & Wanner, Solving
/// ODEs II, V.1. With D_j the j-th backward difference of y_n and d = y_{n+1} - sum_{j<=k} D_j:
/// (1 - kappa) gamma_k d + sum_{j=1}^k gamma_j D_j = h f_{n+1}, gamma_j = 1 + 1/2 + ... + 1/j.
struct BdfFormulas {
  static constexpr std::size_t highest_order = 5;
  std::array<Coefficient, highest_order + 1> kappa{};

  static constexpr Coefficient gamma(std::size_t order) {
    Coefficient sum = 0;
    for (std::size_t j = 1; j <= order; ++j) sum += 1 / Coefficient(j);
    return sum;
  }
  constexpr Coefficient leading(std::size_t order) const { return (1 - kappa[order]) * gamma(order); }
  /// The local error is this times d, the difference of order + 1.
  constexpr Coefficient error_constant(std::size_t order) const {
    return kappa[order] * gamma(order) + 1 / Coefficient(order + 1);
  }

  /// The most by which the step may grow at once. Steps growing for ever by a factor beyond the
  /// zero-stability limit amplify every error, whatever the problem (Hairer, Norsett & Wanner, Solving ODEs
  /// I, III.5). The limits of this scheme, which holds a step for order + 1 steps before it grows, are
  /// computed in bdf_test; these caps stay below them.
  static constexpr std::array<double, highest_order + 1> step_ratio_cap{10, 10, 5, 2.9, 2.3, 1.7};

  /// differences' = W^T differences, rows and columns 0 to `order`, for a step `ratio` times as long: the
  /// interpolation polynomial on the new grid, differenced again.
  template <class Real>
  using Rescaling = std::array<std::array<Real, highest_order + 1>, highest_order + 1>;
  template <class Real>
  static constexpr Rescaling<Real> rescaling(std::size_t order, Real ratio) {
    // column j: the coefficients of the differences in the value j steps of x ago
    const auto values = [order](Real x) {
      Rescaling<Real> out{};
      for (std::size_t j = 0; j <= order; ++j) {
        Real product = 1;
        for (std::size_t i = 0; i <= order; ++i) {
          out[i][j] = product;
          product *= (Real(i) - x * Real(j)) / Real(i + 1);
        }
      }
      return out;
    };
    const auto stretched = values(ratio), unit = values(Real(1));
    Rescaling<Real> out{};
    for (std::size_t i = 0; i <= order; ++i)
      for (std::size_t j = 0; j <= order; ++j)
        for (std::size_t m = 0; m <= order; ++m) out[i][j] += stretched[i][m] * unit[m][j];
    return out;
  }
};

}  // namespace odemark
