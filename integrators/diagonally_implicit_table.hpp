// The coefficients of a diagonally implicit method as its step uses them.
#pragma once

#include "integrators/diagonally_implicit_runge_kutta.hpp"

namespace odemark {

/// The coefficients in the number type of the step.
template <const auto& method, class Real>
struct DirkTable {
  static constexpr std::size_t S = method.stages;
  using Row = std::array<Real, S>;
  std::array<Row, S> a{}, guess{};
  Row b{}, error{}, c{};

  /// guess: the slope of stage i from those before it, on the line through the two latest that are apart.
  constexpr DirkTable() {
    for (std::size_t i = 0; i < S; ++i) {
      b[i] = static_cast<Real>(method.b[i]), error[i] = static_cast<Real>(method.b[i] - method.b_embedded[i]);
      c[i] = static_cast<Real>(method.c(i));
      for (std::size_t j = 0; j < S; ++j) a[i][j] = static_cast<Real>(method.a[i][j]);
      if (i == 0) continue;
      const Coefficient at = method.c(i), near = method.c(i - 1);
      guess[i][i - 1] = 1;
      for (std::size_t j = i - 1; j-- > 0;)
        if (const Coefficient gap = method.c(j) - near; gap > 0.1L || gap < -0.1L) {
          const Coefficient slope = (at - near) / gap;
          if (slope > 2 || slope < -2) continue;
          guess[i][j] = static_cast<Real>(slope), guess[i][i - 1] = static_cast<Real>(1 - slope);
          break;
        }
    }
  }
};

/// What an iteration may leave of the tolerance. Where f is stiff the rest of one stage goes, times a_ij /
/// a_jj, into those after it: e_i = 1 + sum_j |a_ij / a_jj| e_j of the last stage must stay below the
/// tolerance.
template <const auto& method>
constexpr double newton_share() {
  constexpr std::size_t S = method.stages;
  std::array<double, S> rest{};
  for (std::size_t i = 0; i < S; ++i) {
    if (method.a[i][i] == 0) continue;
    rest[i] = 1;
    for (std::size_t j = 0; j < i; ++j) {
      if (method.a[j][j] == 0) continue;
      const double ratio = double(method.a[i][j] / method.a[j][j]);
      rest[i] += (ratio < 0 ? -ratio : ratio) * rest[j];
    }
  }
  const double allowed = 0.5 / (rest[S - 1] + 1);
  return allowed < 0.02 ? allowed : 0.02;
}

}  // namespace odemark
