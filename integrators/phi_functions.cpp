#include "integrators/phi_functions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace odemark {

namespace {

using Wide = long double;
using WideMatrix = std::vector<Wide>;  // column-major, n x n

void multiply(std::size_t n, const WideMatrix& a, const WideMatrix& b, WideMatrix& out) {
  std::fill(out.begin(), out.end(), Wide(0));
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t k = 0; k < n; ++k) {
      const Wide factor = b[j * n + k];
      if (factor == 0) continue;
      for (std::size_t i = 0; i < n; ++i) out[j * n + i] += a[k * n + i] * factor;
    }
}

void add_identity(std::size_t n, Wide factor, WideMatrix& m) {
  for (std::size_t i = 0; i < n; ++i) m[i * n + i] += factor;
}

Wide reciprocal_factorial(int k) {
  Wide product = 1;
  for (int i = 2; i <= k; ++i) product *= Wide(i);
  return 1 / product;
}

}  // namespace

template <class Real>
struct PhiWeights<Real>::Impl {
  std::size_t size, count;
  const PhiSum* sums;
  std::vector<Real> linear, weights;  // weights: one matrix for every sum
  std::vector<Wide> scales;           // every scale that occurs, once
  int highest = 0;
  WideMatrix z, product;
  std::vector<WideMatrix> phi;  // phi_0 .. phi_highest
  std::vector<Wide> sum;        // a matrix for every sum

  /// phi_k(z) for all k, at scale * h L.
  void evaluate(Wide h, Wide scale) {
    const std::size_t n = size;
    Wide norm = 0;
    for (std::size_t i = 0; i < n; ++i) {
      Wide row = 0;
      for (std::size_t j = 0; j < n; ++j) row += std::abs(static_cast<Wide>(linear[j * n + i]) * h * scale);
      if (!(row <= norm)) norm = row;
    }
    if (!std::isfinite(norm)) {
      for (auto& p : phi) std::fill(p.begin(), p.end(), std::numeric_limits<Wide>::quiet_NaN());
      return;
    }
    const int doublings = norm > 0.5L ? static_cast<int>(std::ceil(std::log2(norm))) + 1 : 0;
    const Wide factor = std::ldexp(h * scale, -doublings);
    for (std::size_t i = 0; i < n * n; ++i) z[i] = static_cast<Wide>(linear[i]) * factor;
    auto& top = phi[std::size_t(highest)];
    constexpr int terms = 18;  // (1/2)^18 / 18! is below the unit roundoff
    std::fill(top.begin(), top.end(), Wide(0));
    for (int j = terms; j >= 0; --j) {
      multiply(n, z, top, product);
      add_identity(n, reciprocal_factorial(j + highest), product);
      std::swap(top, product);
    }
    for (int k = highest; k > 0; --k) {
      multiply(n, z, phi[std::size_t(k)], phi[std::size_t(k - 1)]);
      add_identity(n, reciprocal_factorial(k - 1), phi[std::size_t(k - 1)]);
    }
    for (int d = 0; d < doublings; ++d) {
      for (int k = highest; k >= 0; --k) {  // from above: each needs the ones below as they were
        multiply(n, phi[0], phi[std::size_t(k)], product);
        for (int j = 1; j <= k; ++j) {
          const Wide weight = reciprocal_factorial(k - j);
          for (std::size_t i = 0; i < n * n; ++i) product[i] += weight * phi[std::size_t(j)][i];
        }
        const Wide half = std::ldexp(Wide(1), -k);
        for (std::size_t i = 0; i < n * n; ++i) product[i] *= half;
        std::swap(phi[std::size_t(k)], product);
      }
    }
  }
};

template <class Real>
PhiWeights<Real>::PhiWeights(std::size_t size, const PhiSum* sums, std::size_t count)
    : impl_(std::make_unique<Impl>()) {
  auto& me = *impl_;
  me.size = size, me.count = count, me.sums = sums;
  for (std::size_t s = 0; s < count; ++s)
    for (std::size_t t = 0; t < sums[s].count; ++t) {
      const auto& term = sums[s].terms[t];
      me.highest = std::max(me.highest, term.function);
      if (std::find(me.scales.begin(), me.scales.end(), term.scale) == me.scales.end())
        me.scales.push_back(term.scale);
    }
  me.linear.assign(size * size, Real(0));
  me.weights.assign(count * size * size, Real(0));
  me.sum.assign(count * size * size, Wide(0));
  me.z.assign(size * size, Wide(0));
  me.product = me.z;
  me.phi.assign(std::size_t(me.highest) + 1, me.z);
}
template <class Real>
PhiWeights<Real>::~PhiWeights() = default;

template <class Real>
Real* PhiWeights<Real>::matrix() {
  return impl_->linear.data();
}

template <class Real>
void PhiWeights<Real>::prepare(Real h) {
  auto& me = *impl_;
  const std::size_t entries = me.size * me.size;
  std::fill(me.sum.begin(), me.sum.end(), Wide(0));
  for (const Wide scale : me.scales) {
    me.evaluate(static_cast<Wide>(h), scale);
    for (std::size_t s = 0; s < me.count; ++s)
      for (std::size_t t = 0; t < me.sums[s].count; ++t) {
        const auto& term = me.sums[s].terms[t];
        if (term.scale != scale) continue;
        const auto& matrix = me.phi[std::size_t(term.function)];
        for (std::size_t i = 0; i < entries; ++i) me.sum[s * entries + i] += term.weight * matrix[i];
      }
  }
  for (std::size_t i = 0; i < me.sum.size(); ++i)
    me.weights[i] = static_cast<Real>(me.sum[i] * static_cast<Wide>(h));
}

template <class Real>
void PhiWeights<Real>::add_product(std::size_t which, const Real* in, Real* out) const {
  const auto& me = *impl_;
  if (me.sums[which].is_zero()) return;
  const std::size_t n = me.size;
  const Real* weight = me.weights.data() + which * n * n;
  for (std::size_t i = 0; i < n; ++i) {
    Real sum = 0;
    for (std::size_t j = 0; j < n; ++j) sum += weight[j * n + i] * in[j];
    out[i] += sum;
  }
}

template <class Real>
void PhiWeights<Real>::subtract_linear(const Real* in, Real* out) const {
  const auto& me = *impl_;
  const std::size_t n = me.size;
  for (std::size_t i = 0; i < n; ++i) {
    Real sum = 0;
    for (std::size_t j = 0; j < n; ++j) sum += me.linear[j * n + i] * in[j];
    out[i] -= sum;
  }
}

template class PhiWeights<float>;
template class PhiWeights<double>;
template class PhiWeights<long double>;

}  // namespace odemark
