// h phi_1(h L) as a matrix, computed once per step size. Compiled once per number type.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>

namespace odemark {

/// phi_1(z) = (e^z - 1)/z = sum z^k / (k+1)!, accurate to round-off for all arguments: Taylor series on a
/// scaled matrix, then doubling with phi_1(2z) = phi_1(z) (e^z + 1) / 2, so nothing is ever divided by z.
template <class Real>
class PhiMatrix {
 public:
  explicit PhiMatrix(std::size_t size);
  ~PhiMatrix();

  /// Column-major storage for L.
  Real* linear_part();
  void prepare(Real h);
  /// out = h phi_1(h L) in. No allocation.
  void multiply(const Real* in, Real* out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

extern template class PhiMatrix<float>;
extern template class PhiMatrix<double>;
extern template class PhiMatrix<long double>;

}  // namespace odemark
