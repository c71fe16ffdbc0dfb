#include "integrators/small_lu.hpp"

namespace odemark {

template <class Real>
SmallLu<Real, 0>::SmallLu(std::size_t size) : size_(size) {
  if (size > largest_small_lu) {
    dense_ = std::make_unique<DenseLu<Real>>(size);
    return;
  }
  jacobian_.resize(size * size), matrix_.resize(size * size), reciprocal_.resize(size), pivot_.resize(size);
}

template <class Real>
Real* SmallLu<Real, 0>::jacobian() {
  return dense_ ? dense_->jacobian() : jacobian_.data();
}

template <class Real>
bool SmallLu<Real, 0>::factorize(Real diagonal) {
  if (dense_) return dense_->factorize(diagonal);
  return detail::small_lu_factorize(size_, diagonal, jacobian_.data(), matrix_.data(), reciprocal_.data(),
                                    pivot_.data());
}

template <class Real>
void SmallLu<Real, 0>::solve_in_place(Real* rhs) {
  if (dense_)
    dense_->solve_in_place(rhs);
  else
    detail::small_lu_solve(size_, matrix_.data(), reciprocal_.data(), pivot_.data(), rhs);
}

template class SmallLu<float, 0>;
template class SmallLu<double, 0>;
template class SmallLu<long double, 0>;

}  // namespace odemark
