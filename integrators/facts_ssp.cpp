// Strong stability preservation, and how stages amplify what is put into them.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "integrators/facts_parts.hpp"

namespace odemark::detail {

namespace {

using Matrix = Eigen::Matrix<Coefficient, Eigen::Dynamic, Eigen::Dynamic>;

/// A with b as one more row.
Matrix with_weights(std::size_t s, const std::vector<Coefficient>& a, const std::vector<Coefficient>& b) {
  const auto n = static_cast<Eigen::Index>(s);
  Matrix k = Matrix::Zero(n + 1, n + 1);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) k(i, j) = a[static_cast<std::size_t>(i * n + j)];
  for (Eigen::Index j = 0; j < n; ++j) k(n, j) = b[static_cast<std::size_t>(j)];
  return k;
}

bool absolutely_monotonic(const Matrix& k, Coefficient r) {
  const Matrix inverse = (Matrix::Identity(k.rows(), k.cols()) + r * k).fullPivLu().inverse();
  if (!inverse.allFinite()) return false;
  const Matrix weights = r * k * inverse;
  const Coefficient slack = 1e-15L;
  return weights.minCoeff() >= -slack && weights.rowwise().sum().maxCoeff() <= 1 + slack;
}

}  // namespace

/// sup{r: (I + rK)^-1 exists, rK (I + rK)^-1 >= 0 and its row sums are at most 1} (J. F. B. M. Kraaijevanger,
/// BIT 31 (1991) 482-528). What holds for r holds for every smaller one.
Fact<Coefficient> ssp_coefficient(std::size_t s, const std::vector<Coefficient>& a,
                                  const std::vector<Coefficient>& b) {
  const Matrix k = with_weights(s, a, b);
  // signs that appear as a power of r drown in rounding for tiny r; no known coefficient is so small
  if (!absolutely_monotonic(k, 0.01L)) return Coefficient(0);
  Coefficient low = 0.01L, high = 1;
  while (absolutely_monotonic(k, high)) {
    low = high, high *= 2;
    if (high > 1e6L) return infinity;
  }
  for (int i = 0; i < 70; ++i) {
    const Coefficient middle = (low + high) / 2;
    (absolutely_monotonic(k, middle) ? low : high) = middle;
  }
  return low;
}

/// Largest |z b'(I - zA)^-1 e_j| over rays through the region |R| <= 1 that hangs together with 0: what a
/// rounding in stage j becomes at the end of the step (J. G. Verwer, W. H. Hundsdorfer, B. P. Sommeijer,
/// Numer. Math. 57 (1990) 157-178).
Fact<Coefficient> internal_amplification(const Tableau& t, const Theory& function) {
  if (!is_explicit(t))
    return Fact<Coefficient>::none("its region is not bounded, and its stages are solved for");
  const auto response = [&](WideComplex z) {  // the transposed system, from the last stage back
    std::vector<WideComplex> theta(t.stages);
    Coefficient largest = 0;
    for (std::size_t j = t.stages; j-- > 0;) {
      theta[j] = t.b[j];
      for (std::size_t i = j + 1; i < t.stages; ++i) theta[j] += z * t.a[i * t.stages + j] * theta[i];
      largest = std::max(largest, std::abs(z * theta[j]));
    }
    return largest;
  };
  constexpr int rays = 45;
  Coefficient largest = 0;
  const Coefficient step = 0.02L;
  for (int i = 0; i <= rays; ++i) {
    const Coefficient angle = std::numbers::pi_v<Coefficient> * (Coefficient(i) / rays + 1) / 2;
    const WideComplex direction = std::polar(Coefficient(1), angle);
    const auto inside = [&](Coefficient r) { return amplification(function, r * direction) <= 1 + 1e-9L; };
    Coefficient low = 0;
    for (; low < 1000 && inside(low + step); low += step)
      largest = std::max(largest, response(low * direction));
    Coefficient high = low + step;
    for (int k = 0; k < 40; ++k) (inside((low + high) / 2) ? low : high) = (low + high) / 2;
    largest = std::max(largest, response(low * direction));
  }
  return {largest, "on rays in the left half-plane, two degrees apart"};
}

}  // namespace odemark::detail
