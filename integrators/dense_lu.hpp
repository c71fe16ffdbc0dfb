// I - diagonal * J, factored. Compiled once per number type, so that implicit methods do not instantiate
// Eigen.
#pragma once

#include <cstddef>
#include <memory>

namespace odemark {

/// Real is float, double or long double.
template <class Real>
class DenseLu {
 public:
  explicit DenseLu(std::size_t size);
  ~DenseLu();

  /// Column-major size x size storage for the problem to write its Jacobian into.
  Real* jacobian();
  /// Says whether the determinant is positive, as it is for short steps.
  bool factorize(Real diagonal);
  /// Overwrites `rhs` with the solution. No allocation.
  void solve_in_place(Real* rhs);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

extern template class DenseLu<float>;
extern template class DenseLu<double>;
extern template class DenseLu<long double>;

}  // namespace odemark
