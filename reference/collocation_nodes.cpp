#include "reference/collocation_nodes.hpp"

#include "reference/collocation_linear.hpp"

namespace odemark {

namespace {

/// All zeros inside (-1, 1) of a polynomial with `count` simple real ones: signs on a grid that is dense
/// where zeros of orthogonal polynomials crowd, then bisection.
template <class Polynomial>
std::vector<Wide> zeros(Polynomial&& polynomial, int count) {
  std::vector<Wide> found;
  const int samples = 40 * (count + 1);
  const Wide pi = 4 * atan(Wide(1));
  Wide left = -cos(pi / (samples + 1)), value = polynomial(left);
  for (int i = 2; i <= samples; ++i) {
    const Wide right = -cos(pi * i / (samples + 1)), next = polynomial(right);
    if ((value < 0) != (next < 0)) {
      Wide low = left, high = right;
      for (int halving = 0; halving < 190; ++halving) {
        const Wide middle = (low + high) / 2;
        ((polynomial(middle) < 0) == (value < 0) ? low : high) = middle;
      }
      found.push_back((low + high) / 2);
    }
    left = right, value = next;
  }
  if (found.size() != std::size_t(count))
    throw std::logic_error("zeros of a Legendre combination were missed");
  return found;
}

/// The integral of P_k(2 x - 1) over [0, c].
Wide integral(const std::vector<Wide>& p, int k, const Wide& c) {
  return k == 0 ? c : Wide((p[std::size_t(k) + 1] - p[std::size_t(k) - 1]) / (2 * (2 * k + 1)));
}

/// b_j with sum b_j P_k(2 c_j - 1) = integral over [0, 1], k = 0 .. s-1.
std::vector<Wide> quadrature(const std::vector<Wide>& c) {
  const std::size_t s = c.size();
  std::vector<Wide> matrix(s * s), b(s, Wide(0));
  for (std::size_t j = 0; j < s; ++j) {
    const auto p = legendre(2 * c[j] - 1, int(s));
    for (std::size_t k = 0; k < s; ++k) matrix[k * s + j] = p[k];
  }
  b[0] = 1;
  WideLu<Wide> lu;
  lu.factor(std::move(matrix), s);
  lu.solve(b.data());
  return b;
}

}  // namespace

std::vector<Wide> legendre(const Wide& x, int degree) {
  std::vector<Wide> p(std::size_t(degree) + 1);
  p[0] = 1;
  if (degree > 0) p[1] = x;
  for (std::size_t k = 1; k < std::size_t(degree); ++k)
    p[k + 1] = (Wide(2 * k + 1) * x * p[k] - Wide(k) * p[k - 1]) / Wide(k + 1);
  return p;
}

std::vector<Wide> legendre_transform(const std::vector<Wide>& nodes) {
  const std::size_t n = nodes.size();
  std::vector<Wide> matrix(n * n), out(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto p = legendre(2 * nodes[i] - 1, int(n));
    for (std::size_t k = 0; k < n; ++k) matrix[i * n + k] = p[k];
  }
  WideLu<Wide> lu;
  lu.factor(std::move(matrix), n);
  for (std::size_t column = 0; column < n; ++column) {
    std::vector<Wide> unit(n, Wide(0));
    unit[column] = 1;
    lu.solve(unit.data());
    for (std::size_t k = 0; k < n; ++k) out[k * n + column] = unit[k];
  }
  return out;
}

StiffStages radau_iia(int stages) {
  const std::size_t s = std::size_t(stages);
  StiffStages method{s, {}, std::vector<Wide>(s * s)};
  for (const Wide& x : zeros(
           [&](const Wide& x) {
             const auto p = legendre(x, stages);
             return Wide(p[s] - p[s - 1]);
           },
           stages - 1))
    method.c.push_back((x + 1) / 2);
  method.c.emplace_back(1);
  // sum_j a_ij P_k(2 c_j - 1) = integral of P_k over [0, c_i], k = 0 .. s-1
  std::vector<Wide> matrix(s * s);
  for (std::size_t j = 0; j < s; ++j) {
    const auto p = legendre(2 * method.c[j] - 1, stages);
    for (std::size_t k = 0; k < s; ++k) matrix[k * s + j] = p[k];
  }
  WideLu<Wide> lu;
  lu.factor(std::move(matrix), s);
  for (std::size_t i = 0; i < s; ++i) {
    const auto p = legendre(2 * method.c[i] - 1, stages);
    for (std::size_t k = 0; k < s; ++k) method.a[i * s + k] = integral(p, int(k), method.c[i]);
    lu.solve(&method.a[i * s]);
  }
  return method;
}

StiffStages lobatto_iiic(int stages) {
  const std::size_t s = std::size_t(stages);
  StiffStages method{s, {}, std::vector<Wide>(s * s)};
  method.c.emplace_back(0);
  for (const Wide& x : zeros(
           [&](const Wide& x) {  // (1 - x^2) P'_n = n (P_{n-1} - x P_n)
             const auto p = legendre(x, stages - 1);
             return Wide(p[s - 2] - x * p[s - 1]);
           },
           stages - 2))
    method.c.push_back((x + 1) / 2);
  method.c.emplace_back(1);
  const auto b = quadrature(method.c);
  // a_i1 = b_1 and sum_j a_ij P_k(2 c_j - 1) = integral of P_k over [0, c_i], k = 0 .. s-2
  std::vector<Wide> matrix(s * s, Wide(0));
  for (std::size_t j = 0; j < s; ++j) {
    const auto p = legendre(2 * method.c[j] - 1, stages);
    for (std::size_t k = 0; k + 1 < s; ++k) matrix[k * s + j] = p[k];
  }
  matrix[(s - 1) * s] = 1;
  WideLu<Wide> lu;
  lu.factor(std::move(matrix), s);
  for (std::size_t i = 0; i < s; ++i) {
    const auto p = legendre(2 * method.c[i] - 1, stages);
    for (std::size_t k = 0; k + 1 < s; ++k) method.a[i * s + k] = integral(p, int(k), method.c[i]);
    method.a[i * s + s - 1] = b[0];
    lu.solve(&method.a[i * s]);
  }
  return method;
}

}  // namespace odemark
