#include "integrators/matrix_exponential.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace odemark {

template <class Real>
struct MatrixExponential<Real>::Impl {
  using Wide = long double;
  explicit Impl(std::size_t n)
      : size(n), matrix(n * n, Real(0)), scaled(n * n), term(n * n), spare(n * n), sum(n * n) {}

  void multiply_into_spare(const std::vector<Wide>& a, const std::vector<Wide>& b) {
    for (std::size_t c = 0; c < size; ++c)
      for (std::size_t r = 0; r < size; ++r) {
        Wide entry = 0;
        for (std::size_t k = 0; k < size; ++k) entry += a[k * size + r] * b[c * size + k];
        spare[c * size + r] = entry;
      }
  }

  std::size_t size;
  std::vector<Real> matrix;
  std::vector<Wide> scaled, term, spare, sum;
};

template <class Real>
MatrixExponential<Real>::MatrixExponential(std::size_t size) : impl_(std::make_unique<Impl>(size)) {}
template <class Real>
MatrixExponential<Real>::~MatrixExponential() = default;

template <class Real>
Real* MatrixExponential<Real>::matrix() {
  return impl_->matrix.data();
}

template <class Real>
void MatrixExponential<Real>::prepare(Real h) {
  using Wide = long double;
  Impl& m = *impl_;
  const std::size_t n = m.size;
  if (n == 1) {
    m.sum[0] = std::exp(Wide(m.matrix[0]) * Wide(h));
    return;
  }
  Wide norm = 0;  // a sum, because std::max would swallow a NaN
  for (const Real entry : m.matrix) norm += std::abs(Wide(entry) * Wide(h));
  if (!std::isfinite(norm)) {
    std::fill(m.sum.begin(), m.sum.end(), std::numeric_limits<Wide>::quiet_NaN());
    return;
  }
  const int squarings = norm > 0.5L ? std::ilogb(norm) + 2 : 0;
  const Wide scale = std::ldexp(Wide(h), -squarings);
  for (std::size_t i = 0; i < n * n; ++i) m.scaled[i] = Wide(m.matrix[i]) * scale;
  std::fill(m.sum.begin(), m.sum.end(), Wide(0));
  for (std::size_t i = 0; i < n; ++i) m.sum[i * n + i] = 1;
  m.term = m.sum;
  for (int k = 1; k <= 20; ++k) {  // 0.5^20 / 20! is far below the rounding of Wide
    m.multiply_into_spare(m.scaled, m.term);
    for (std::size_t i = 0; i < n * n; ++i) m.term[i] = m.spare[i] / Wide(k), m.sum[i] += m.term[i];
  }
  for (int i = 0; i < squarings; ++i) {
    m.multiply_into_spare(m.sum, m.sum);
    std::swap(m.sum, m.spare);
  }
}

template <class Real>
void MatrixExponential<Real>::multiply(const Real* in, Real* out) const {
  const std::size_t n = impl_->size;
  for (std::size_t r = 0; r < n; ++r) {
    Real entry = 0;
    for (std::size_t c = 0; c < n; ++c) entry += static_cast<Real>(impl_->sum[c * n + r]) * in[c];
    out[r] = entry;
  }
}

template class MatrixExponential<float>;
template class MatrixExponential<double>;
template class MatrixExponential<long double>;

}  // namespace odemark
