// The one linear solver of all implicit methods: whole and banded, real and complex, of sizes known early and
// late.
#include <gtest/gtest.h>

#include <random>

#include "integrators/shifted_lu.hpp"

namespace odemark::linear_solver_test {
namespace {

TEST(ShiftedLu, SolvesWithPivotsInEitherForm) {
  constexpr std::size_t n = 3;
  const double jacobian[9] = {2, 1, -4, 5, 2, 1, -3, 7, 0.25};  // 1 - 0.5 * 2 = 0: the first pivot must move
  JacobianMatrix<double, n> fixed_matrix(MatrixShape::dense(n));
  JacobianMatrix<double> matrix(MatrixShape::dense(n));
  for (std::size_t i = 0; i < n * n; ++i) fixed_matrix.view().data[i] = matrix.view().data[i] = jacobian[i];
  std::array<double, n> x{1, -2, 3}, rhs{};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) rhs[i] += ((i == j ? 1 : 0) - 0.5 * jacobian[j * n + i]) * x[j];
  auto other = rhs;
  ShiftedLu<double, double, n> fixed(matrix.shape());
  ShiftedLu<double> dynamic(matrix.shape());
  fixed.factorize_step(fixed_matrix, 0.5), dynamic.factorize_step(matrix, 0.5);
  fixed.solve_in_place(rhs.data()), dynamic.solve_in_place(other.data());
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(rhs[i], x[i], 1e-14);
  EXPECT_EQ(rhs, other);
  // (2 I - J) x = 2 (I - J/2) x
  for (std::size_t i = 0; i < n; ++i) rhs[i] = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) rhs[i] += ((i == j ? 2 : 0) - jacobian[j * n + i]) * x[j];
  other = rhs;
  fixed.factorize(fixed_matrix, 2), dynamic.factorize(matrix, 2);
  fixed.solve_in_place(rhs.data()), dynamic.solve_in_place(other.data());
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(rhs[i], x[i], 1e-14);
  EXPECT_EQ(rhs, other);
}

TEST(ShiftedLu, TellsTheSignOfTheDeterminant) {
  // det(I - d J) is the product of 1 - d lambda: one eigenvalue, 3, lies beyond 1/d for d = 1/2
  for (const bool banded : {false, true})
    for (const std::size_t blocks : {1u, 3u, 4u}) {
      const std::size_t n = 3 * blocks;
      JacobianMatrix<double> matrix(banded ? MatrixShape::band(n, 1, 1, false) : MatrixShape::dense(n));
      EXPECT_EQ(matrix.shape().is_dense(), !banded || blocks == 1);
      for (std::size_t b = 0; b < blocks; ++b)
        for (std::size_t i = 0; i < 3; ++i) {
          const double lambda[3] = {b == 0 ? 3.0 : 0.125, -2, 0.25};
          // large entries below the diagonal leave the eigenvalues alone and make the pivots move
          matrix.view()(3 * b + i, 3 * b + i) = lambda[i];
          if (i > 0) matrix.view()(3 * b + i, 3 * b + i - 1) = 100;
        }
      ShiftedLu<double> lu(matrix.shape());
      lu.factorize_step(matrix, 0.25);
      EXPECT_TRUE(lu.has_positive_determinant()) << n;
      lu.factorize_step(matrix, 0.5);
      EXPECT_FALSE(lu.has_positive_determinant()) << n;
    }
}

/// Random entries within a band; small ones on the diagonal, so that pivots move. Of a second-order system
/// where the shape is interleaved.
template <class Real>
JacobianMatrix<Real> random_matrix(const MatrixShape& shape, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  JacobianMatrix<Real> matrix(shape);
  const std::size_t n = shape.size;
  const auto inside = [&](std::size_t r, std::size_t c) {
    const std::size_t row = shape.place(r), column = shape.place(c);
    return row <= column + shape.lower && column <= row + shape.upper;
  };
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t r = 0; r < n; ++r)
      if (inside(r, c)) {
        const Real entry = static_cast<Real>(unit(random) * (r == c ? 0.0625 : 1));
        if (shape.interleaved)
          matrix.interleaved_view()(r, c) = entry;
        else
          matrix.view()(r, c) = entry;
      }
  return matrix;
}

template <class Real>
JacobianMatrix<Real> whole(const JacobianMatrix<Real>& band) {
  JacobianMatrix<Real> matrix(MatrixShape::dense(band.shape().size));
  for (std::size_t c = 0; c < band.shape().size; ++c)
    for (std::size_t r = 0; r < band.shape().size; ++r) matrix.view()(r, c) = band.at(r, c);
  return matrix;
}

constexpr MatrixShape shapes[] = {MatrixShape::band(9, 1, 1, false),  MatrixShape::band(40, 1, 1, false),
                                  MatrixShape::band(17, 0, 2, false), MatrixShape::band(17, 3, 0, false),
                                  MatrixShape::band(31, 4, 2, false), MatrixShape::band(31, 2, 5, false),
                                  MatrixShape::band(20, 3, 1, true),  MatrixShape::band(64, 3, 2, true),
                                  MatrixShape::band(30, 5, 4, true)};

template <class Real>
void expect_band_solves_as_whole_matrix(const MatrixShape& shape, std::mt19937& random) {
  ASSERT_FALSE(shape.is_dense());
  const std::size_t n = shape.size;
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto band = random_matrix<Real>(shape, random);
  const auto matrix = whole(band);
  std::vector<Real> b(n);
  for (Real& each : b) each = static_cast<Real>(unit(random));
  // backward error: the residual in units of what rounding makes of the matrix and the solution
  const auto residual = [&](const auto& x, auto shift, auto scale, auto zero) {
    using Scalar = decltype(zero);
    Real worst = 0, entries = 0, largest = 0;
    for (const auto& each : x) largest = std::max(largest, magnitude_of(each));
    for (std::size_t r = 0; r < n; ++r) {
      Scalar sum = zero - Scalar{b[r]};
      Real row = 0;
      for (std::size_t c = 0; c < n; ++c) {
        const Scalar entry = (r == c ? shift : zero) - scale * Scalar{matrix.at(r, c)};
        sum = sum + entry * x[c];
        row += magnitude_of(entry);
      }
      worst = std::max(worst, magnitude_of(sum)), entries = std::max(entries, row);
    }
    return double(worst / (std::numeric_limits<Real>::epsilon() * entries * largest));
  };
  ShiftedLu<Real> narrow(shape), wide(matrix.shape());
  for (const Real shift : {Real(0.03125), Real(-0.5), Real(3)}) {
    auto x = b, y = b;
    narrow.factorize(band, shift), wide.factorize(matrix, shift);
    narrow.solve_in_place(x.data()), wide.solve_in_place(y.data());
    EXPECT_EQ(narrow.has_positive_determinant(), wide.has_positive_determinant());
    EXPECT_LT(residual(x, shift, Real(1), Real(0)), 100) << n << " " << shift;
    EXPECT_LT(residual(y, shift, Real(1), Real(0)), 100) << n << " " << shift;
    x = b, y = b;
    narrow.factorize_step(band, shift), narrow.solve_in_place(x.data());
    EXPECT_LT(residual(x, Real(1), shift, Real(0)), 100) << n << " " << shift;
  }
  using Complex = PlainComplex<Real>;
  ShiftedLu<Real, Complex> narrow_complex(shape);
  std::vector<Complex> z(n);
  for (std::size_t i = 0; i < n; ++i) z[i] = {b[i], 0};
  const Complex shift{Real(0.25), Real(0.75)};
  narrow_complex.factorize(band, shift);
  narrow_complex.solve_in_place(z.data());
  EXPECT_LT(residual(z, shift, Complex{1, 0}, Complex{0, 0}), 200) << n;
  std::vector<Real> by_band(n), by_whole(n);
  band.multiply(b.data(), by_band.data()), matrix.multiply(b.data(), by_whole.data());
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(double(by_band[i] - by_whole[i]), 0, 1e-5);
  // a wrong entry is felt: the solution of another matrix does not pass as that of this one
  auto other = band;
  other.add(Real(0.0625), band);
  auto x = b;
  narrow.factorize(other, Real(3)), narrow.solve_in_place(x.data());
  EXPECT_GT(residual(x, Real(3), Real(1), Real(0)), 1e4);
}

TEST(ShiftedLu, ABandSolvesAsTheWholeMatrixDoes) {
  std::mt19937 random(7);
  for (const MatrixShape& shape : shapes)
    for (int trial = 0; trial < 8; ++trial) {
      expect_band_solves_as_whole_matrix<float>(shape, random);
      expect_band_solves_as_whole_matrix<double>(shape, random);
      expect_band_solves_as_whole_matrix<long double>(shape, random);
    }
}

TEST(ShiftedLu, AZeroColumnGivesNoNumber) {
  JacobianMatrix<double> matrix(MatrixShape::band(12, 1, 1, false));
  ShiftedLu<double> lu(matrix.shape());
  lu.factorize(matrix, 0);
  std::vector<double> b(12, 1);
  lu.solve_in_place(b.data());
  for (const double x : b) EXPECT_FALSE(std::isfinite(x));
}

TEST(MatrixShape, ABlockOfASecondOrderBandIsTheBandOfItsForce) {
  const MatrixShape chain = MatrixShape::band(20, 3, 1, true), damped = MatrixShape::band(40, 5, 4, true);
  EXPECT_EQ(chain.block().lower, 1u);
  EXPECT_EQ(chain.block().upper, 1u);
  EXPECT_EQ(damped.block().lower, 2u);
  EXPECT_EQ(damped.block().upper, 2u);
  EXPECT_EQ(damped.block().size, 20u);
  EXPECT_TRUE(MatrixShape::band(4, 3, 1, true).is_dense());
  EXPECT_FALSE(MatrixShape::band(4, 3, 1, true).interleaved);
}

}  // namespace
}  // namespace odemark::linear_solver_test
