#include "integrators/dense_lu.hpp"

#include <Eigen/LU>

namespace odemark {

template <class Real>
struct DenseLu<Real>::Impl {
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

  explicit Impl(Eigen::Index n) : jacobian(Matrix::Zero(n, n)), matrix(n, n), lu(n), scratch(n) {}
  Matrix jacobian, matrix;
  Eigen::PartialPivLU<Matrix> lu;
  Vector scratch;
};

template <class Real>
DenseLu<Real>::DenseLu(std::size_t size) : impl_(std::make_unique<Impl>(static_cast<Eigen::Index>(size))) {}
template <class Real>
DenseLu<Real>::~DenseLu() = default;

template <class Real>
Real* DenseLu<Real>::jacobian() {
  return impl_->jacobian.data();
}

template <class Real>
bool DenseLu<Real>::factorize(Real diagonal) {
  impl_->matrix.noalias() = -diagonal * impl_->jacobian;
  impl_->matrix.diagonal().array() += Real(1);
  impl_->lu.compute(impl_->matrix);
  const auto pivots = impl_->lu.matrixLU().diagonal();
  const auto& row = impl_->lu.permutationP().indices();
  bool positive = true;  // by counting inversions: Eigen's determinant of a permutation takes memory
  for (Eigen::Index i = 0; i < row.size(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) positive = positive != (row[j] > row[i]);
  for (Eigen::Index i = 0; i < pivots.size(); ++i) positive = positive != (pivots[i] < 0);
  return positive;
}

template <class Real>
void DenseLu<Real>::solve_in_place(Real* rhs) {
  Eigen::Map<typename Impl::Vector> b(rhs, impl_->scratch.size());
  impl_->scratch.noalias() = impl_->lu.permutationP() * b;
  impl_->lu.matrixLU().template triangularView<Eigen::UnitLower>().solveInPlace(impl_->scratch);
  impl_->lu.matrixLU().template triangularView<Eigen::Upper>().solveInPlace(impl_->scratch);
  b = impl_->scratch;
}

template class DenseLu<float>;
template class DenseLu<double>;
template class DenseLu<long double>;

}  // namespace odemark
