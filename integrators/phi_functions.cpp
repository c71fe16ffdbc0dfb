#include "integrators/phi_functions.hpp"

#include <Eigen/Core>
#include <cmath>

namespace odemark {

template <class Real>
struct PhiMatrix<Real>::Impl {
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix linear, h_phi;
};

template <class Real>
PhiMatrix<Real>::PhiMatrix(std::size_t size) : impl_(std::make_unique<Impl>()) {
  const auto n = static_cast<Eigen::Index>(size);
  impl_->linear.setZero(n, n);
  impl_->h_phi.setZero(n, n);
}
template <class Real>
PhiMatrix<Real>::~PhiMatrix() = default;

template <class Real>
Real* PhiMatrix<Real>::linear_part() {
  return impl_->linear.data();
}

template <class Real>
void PhiMatrix<Real>::prepare(Real h) {
  using Matrix = typename Impl::Matrix;
  // in long double whatever Real is: a stiff L is scaled down and doubled back many times
  using WideMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  WideMatrix z = impl_->linear.template cast<long double>() * static_cast<long double>(h);
  const long double norm = z.cwiseAbs().rowwise().sum().maxCoeff();
  const int doublings = norm > 0.5L ? static_cast<int>(std::ceil(std::log2(norm))) + 1 : 0;
  z *= std::ldexp(1.0L, -doublings);
  const auto n = z.rows();
  const WideMatrix one = WideMatrix::Identity(n, n);
  WideMatrix phi = one, term = one;
  for (int k = 1; k <= 24; ++k) {
    term = (term * z / static_cast<long double>(k + 1)).eval();
    phi += term;
  }
  // the exponential from its own series: e^z = 1 + z phi_1(z)
  WideMatrix exponential = one + z * phi;
  for (int i = 0; i < doublings; ++i) {
    phi = (phi * (exponential + one) / 2.0L).eval();
    exponential = (exponential * exponential).eval();
  }
  impl_->h_phi = Matrix((phi * static_cast<long double>(h)).template cast<Real>());
}

template <class Real>
void PhiMatrix<Real>::multiply(const Real* in, Real* out) const {
  const auto n = impl_->h_phi.rows();
  for (Eigen::Index i = 0; i < n; ++i) {
    Real sum = 0;
    for (Eigen::Index j = 0; j < n; ++j) sum += impl_->h_phi(i, j) * in[j];
    out[i] = sum;
  }
}

template class PhiMatrix<float>;
template class PhiMatrix<double>;
template class PhiMatrix<long double>;

}  // namespace odemark
