// exp(h D) of a matrix that changes from step to step. Compiled once per number type.
#pragma once

#include <cstddef>
#include <memory>

namespace odemark {

/// Scaling and squaring of the Taylor series in long double (C. Moler, C. Van Loan, SIAM Review 45 (2003)
/// 3-49, method 3); one by one is the library's exp. Takes its memory at construction.
template <class Real>
class MatrixExponential {
 public:
  explicit MatrixExponential(std::size_t size);
  ~MatrixExponential();

  /// Column-major storage for D.
  Real* matrix();
  void prepare(Real h);
  /// out = exp(h D) in; the two must not overlap.
  void multiply(const Real* in, Real* out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

extern template class MatrixExponential<float>;
extern template class MatrixExponential<double>;
extern template class MatrixExponential<long double>;

}  // namespace odemark
