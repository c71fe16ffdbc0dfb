#include "integrators/stage_modes.hpp"

#include <cmath>
#include <limits>

#include "integrators/shifted_lu.hpp"

namespace odemark {
namespace {

using Complex = StageModes::Complex;
using Vector = StageModes::Vector;
constexpr std::size_t most = StageModes::most;

Complex scaled(const Complex& x, Coefficient factor) { return {x.re * factor, x.im * factor}; }

/// det(x I - A), ascending powers, by the recursion of Faddeev and Le Verrier.
std::array<Coefficient, most + 1> characteristic(std::size_t n, const Coefficient* a) {
  std::array<Coefficient, most + 1> c{};
  std::array<Coefficient, most * most> power{}, product{};
  for (std::size_t i = 0; i < n; ++i) power[i * n + i] = 1;
  c[n] = 1;
  for (std::size_t k = 1; k <= n; ++k) {
    product.fill(0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t l = 0; l < n; ++l) product[i * n + j] += a[i * n + l] * power[l * n + j];
    Coefficient trace = 0;
    for (std::size_t i = 0; i < n; ++i) trace += product[i * n + i];
    c[n - k] = -trace / Coefficient(k);
    power = product;
    for (std::size_t i = 0; i < n; ++i) power[i * n + i] += c[n - k];
  }
  return c;
}

/// All roots at once (L. W. Ehrlich, Comm. ACM 10 (1967) 107-108).
Vector roots(std::size_t n, const std::array<Coefficient, most + 1>& c) {
  Vector x{};
  Complex start{0.4L, 0};
  for (std::size_t i = 0; i < n; ++i) x[i] = start = start * Complex{0.4L, 0.9L};
  for (int sweep = 0; sweep < 200; ++sweep)
    for (std::size_t i = 0; i < n; ++i) {
      Complex value{c[n], 0}, slope{};
      for (std::size_t k = n; k-- > 0;) {
        slope = slope * x[i] + value;
        value = value * x[i] + Complex{c[k], 0};
      }
      if (magnitude_of(value) == 0 || magnitude_of(slope) == 0) continue;
      const Complex newton = value * reciprocal_of(slope);
      Complex others{};
      for (std::size_t j = 0; j < n; ++j)
        if (j != i && magnitude_of(x[i] - x[j]) > 0) others = others + reciprocal_of(x[i] - x[j]);
      const Complex damping = Complex{1, 0} - newton * others;
      x[i] = x[i] - newton * reciprocal_of(damping);
    }
  return x;
}

/// The eigenvector of A, or of its transpose, for a value known to nearly all digits: two inverse iterations.
Vector eigenvector(std::size_t n, const Coefficient* a, const Complex& value, bool transposed) {
  std::array<Complex, most * most> matrix{};
  std::array<Complex, most> reciprocal{};
  std::array<std::size_t, most> row{};
  const Coefficient off = 64 * std::numeric_limits<Coefficient>::epsilon();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      matrix[j * n + i] = Complex{transposed ? a[j * n + i] : a[i * n + j], 0} -
                          (i == j ? value + Complex{off, off} : Complex{});
  lu_factorize(matrix.data(), reciprocal.data(), row.data(), n);
  Vector x{};
  for (std::size_t i = 0; i < n; ++i) x[i] = {1 + Coefficient(i) / 8, 0};
  for (int iteration = 0; iteration < 3; ++iteration) {
    lu_solve(matrix.data(), reciprocal.data(), row.data(), x.data(), n);
    std::size_t largest = 0;
    for (std::size_t i = 1; i < n; ++i)
      if (magnitude_of(x[i]) > magnitude_of(x[largest])) largest = i;
    const Complex unit = reciprocal_of(x[largest]);
    for (std::size_t i = 0; i < n; ++i) x[i] = x[i] * unit;
  }
  return x;
}

}  // namespace

StageModes stage_modes(std::size_t size, const Coefficient* a) {
  StageModes modes;
  const Vector found = roots(size, characteristic(size, a));
  const auto is_real = [](const Complex& x) { return std::abs(x.im) < 1e-9L; };
  Vector values{};  // the real ones first; std::stable_partition would take memory from the heap
  std::size_t placed = 0;
  for (const bool real : {true, false})
    for (std::size_t i = 0; i < size; ++i)
      if (is_real(found[i]) == real) values[placed++] = found[i];
  for (std::size_t i = 0; i < size; ++i) {
    Complex value = values[i];
    if (is_real(value))
      value.im = 0;
    else if (value.im < 0)
      continue;
    Vector right = eigenvector(size, a, value, false), left = eigenvector(size, a, value, true);
    if (is_real(value))
      for (std::size_t j = 0; j < size; ++j) right[j].im = left[j].im = 0;
    // left' A right / left' right: better than the root of a polynomial by its conditioning
    Complex quotient{}, product{};
    for (std::size_t j = 0; j < size; ++j) {
      product = product + left[j] * right[j];
      for (std::size_t k = 0; k < size; ++k)
        quotient = quotient + scaled(left[j] * right[k], a[j * size + k]);
    }
    const Complex unit = reciprocal_of(product);
    for (std::size_t j = 0; j < size; ++j) left[j] = left[j] * unit;
    value = quotient * unit;
    if (magnitude_of(value) < 1e-15L) value = {};  // a singular matrix: an explicit stage
    const std::size_t mode = modes.reals + modes.pairs;
    modes.value[mode] = value, modes.right[mode] = right, modes.left[mode] = left;
    ++(is_real(values[i]) ? modes.reals : modes.pairs);
  }
  return modes;
}

}  // namespace odemark
