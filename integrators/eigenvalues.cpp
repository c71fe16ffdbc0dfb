// Eigenvalues and roots by Eigen's complex QR algorithm, compiled once for both; two by two in closed form,
// so that zeros stay zeros.
#include "integrators/eigenvalues.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace odemark {
namespace {

using Matrix = Eigen::Matrix<WideComplex, Eigen::Dynamic, Eigen::Dynamic>;
std::vector<WideComplex> eigenvalues_of(const Matrix& m) {
  const Eigen::ComplexEigenSolver<Matrix> solver(m, false);
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

}  // namespace

std::vector<WideComplex> eigenvalues(std::size_t size, const std::vector<Coefficient>& m) {
  if (size == 0) return {};
  if (size == 1) return {m[0]};
  if (size == 2) {
    const Coefficient mean = (m[0] + m[3]) / 2, half = (m[0] - m[3]) / 2;
    const Coefficient square = half * half + m[1] * m[2];
    // cancellation below the rounding of the entries means a double eigenvalue (critical damping)
    const Coefficient noise = 0x1p-51L * (half * half + std::abs(m[1] * m[2]));
    if (std::abs(square) <= noise) return {mean, mean};
    if (square < 0) return {{mean, std::sqrt(-square)}, {mean, -std::sqrt(-square)}};
    const Coefficient far = mean + std::copysign(std::sqrt(square), mean);
    const Coefficient determinant = m[0] * m[3] - m[1] * m[2];
    return {far, far == 0 ? Coefficient(0) : determinant / far};
  }
  std::vector<WideComplex> out =
      eigenvalues_of(Matrix(Eigen::Map<const Eigen::Matrix<Coefficient, Eigen::Dynamic, Eigen::Dynamic>>(
                                m.data(), Eigen::Index(size), Eigen::Index(size))
                                .cast<WideComplex>()));
  Coefficient largest = 0;
  for (const auto& l : out) largest = std::max(largest, std::abs(l));
  for (auto& l : out) {
    if (std::abs(l.real()) <= 1e-14L * largest) l.real(0);
    if (std::abs(l.imag()) <= 1e-14L * largest) l.imag(0);
  }
  return out;
}

std::vector<WideComplex> polynomial_roots(std::vector<WideComplex> c) {
  while (!c.empty() && c.back() == WideComplex(0)) c.pop_back();
  if (c.size() < 2) return {};
  if (c.size() == 2) return {-c[0] / c[1]};
  const auto n = static_cast<Eigen::Index>(c.size() - 1);
  Matrix companion = Matrix::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (i + 1 < n) companion(i + 1, i) = 1;
    companion(i, n - 1) = -c[static_cast<std::size_t>(i)] / c.back();
  }
  return eigenvalues_of(companion);
}

}  // namespace odemark
