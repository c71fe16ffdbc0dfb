// The four last stages of ROCK4 from the order conditions of a composition.
#include <algorithm>
#include <cmath>

#include "integrators/rock_polynomials.hpp"

namespace odemark {

namespace {

/// 1, [1], [1,1], [[1]], [1,1,1], [1,[1]], [[1,1]], [[[1]]]
using Weights = std::array<Coefficient, 8>;

/// Of h f(Y) where Y has the weights g: cut off the root.
Weights slope_of(const Weights& g) {
  return {1, g[0], g[0] * g[0], g[1], g[0] * g[0] * g[0], g[0] * g[1], g[2], g[3]};
}

struct Attempt {
  LastStages stages;
  Coefficient gap = 0;  // in the condition of the tall tree of order 4
};

/// Nodes 1/3 and 2/3 of the way are chosen; the conditions of trees without branches at depth give the
/// weights, the next three the coefficients, and the last one the node of the fourth stage, by the caller.
Attempt with_last_node(const Weights& p, Coefficient part) {
  Attempt out;
  auto& s = out.stages;
  const Coefficient whole = 1 - p[0];
  const Coefficient c[4] = {0, whole / 3, 2 * whole / 3, whole * part};
  Coefficient n[4];  // nodes seen from the start of the step
  for (int i = 0; i < 4; ++i) n[i] = p[0] + c[i];
  // b: moments of the quadrature, by Lagrange polynomials in ascending powers
  const Coefficient moments[4] = {1 - p[0], 1.0L / 2 - p[1], 1.0L / 3 - p[2], 1.0L / 4 - p[4]};
  for (int i = 0; i < 4; ++i) {
    Coefficient q[4] = {1, 0, 0, 0};
    for (int j = 0, degree = 0; j < 4; ++j) {
      if (j == i) continue;
      const Coefficient width = n[i] - n[j];
      for (int k = ++degree; k >= 0; --k) q[k] = ((k > 0 ? q[k - 1] : 0) - n[j] * q[k]) / width;
    }
    for (int k = 0; k < 4; ++k) s.b[std::size_t(i)] += q[k] * moments[k];
  }
  const auto& b = s.b;
  // third and fourth stage: X = a_32 c_2, Y = a_42 c_2 + a_43 c_3 from [[1]] and [1,[1]]
  Coefficient right[2] = {1.0L / 6 - p[3], 1.0L / 8 - p[5]};
  for (std::size_t i = 0; i < 4; ++i) {
    const Coefficient known = b[i] * (p[1] + c[i] * p[0]);
    right[0] -= known, right[1] -= known * n[i];
  }
  const Coefficient determinant = b[2] * b[3] * (n[3] - n[2]);
  const Coefficient x = (right[0] * b[3] * n[3] - right[1] * b[3]) / determinant;
  const Coefficient y = (right[1] * b[2] - right[0] * b[2] * n[2]) / determinant;
  s.a[2][1] = x / c[1];
  // [[1,1]] is linear in a_43
  const auto bend = [&](int j) { return c[j] * (2 * p[0] + c[j]); };
  Coefficient rest = 1.0L / 12 - p[6];
  for (std::size_t i = 0; i < 4; ++i) rest -= b[i] * (p[2] + c[i] * p[0] * p[0]);
  rest -= b[2] * s.a[2][1] * bend(1) + b[3] * y / c[1] * bend(1);
  s.a[3][2] = rest / (b[3] * (bend(2) - c[2] / c[1] * bend(1)));
  s.a[3][1] = (y - s.a[3][2] * c[2]) / c[1];
  s.a[1][0] = c[1], s.a[2][0] = c[2] - s.a[2][1], s.a[3][0] = c[3] - s.a[3][1] - s.a[3][2];
  // what is left: [[[1]]]
  Weights slopes[4], end = p;
  for (std::size_t i = 0; i < 4; ++i) {
    Weights g = p;
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t t = 0; t < 8; ++t) g[t] += s.a[i][j] * slopes[j][t];
    slopes[i] = slope_of(g);
    for (std::size_t t = 0; t < 8; ++t) end[t] += b[i] * slopes[i][t];
  }
  out.gap = end[7] - 1.0L / 24;
  // order 3 with the slope at the end of the step, weight a tenth of the rest of the step: 1, [1], [1,1],
  // [[1]]
  const Weights last = slope_of(end);
  Coefficient m[4][5];
  for (std::size_t t = 0; t < 4; ++t) {
    for (std::size_t i = 0; i < 4; ++i) m[t][i] = slopes[i][t];
    m[t][4] = -last[t];
  }
  for (int k = 0; k < 4; ++k) {
    int pivot = k;
    for (int i = k; i < 4; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    std::swap(m[k], m[pivot]);
    for (int i = 0; i < 4; ++i) {
      if (i == k) continue;
      const Coefficient factor = m[i][k] / m[k][k];
      for (int j = k; j < 5; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  for (std::size_t i = 0; i < 4; ++i) s.error[i] = -whole / 10 * m[i][4] / m[i][i];
  s.error[4] = -whole / 10;
  for (std::size_t i = 0; i < 4; ++i) s.node[i] = c[i];
  return out;
}

}  // namespace

std::array<Coefficient, 8> elementary_weights(const std::vector<RecurrenceStage>& recurrence) {
  Weights before{}, now{};
  for (std::size_t j = 1; j < recurrence.size(); ++j) {
    const Weights slope = slope_of(now);
    Weights next;
    for (std::size_t t = 0; t < 8; ++t)
      next[t] = recurrence[j].mu * now[t] + recurrence[j].nu * before[t] + recurrence[j].slope * slope[t];
    before = now, now = next;
  }
  return now;
}

LastStages last_stages_of_order_four(const std::array<Coefficient, 8>& before) {
  // the first change of sign of the last condition, from the whole step outwards
  const Coefficient grid = 1.0L / 64;
  for (int ring = 0; ring < 64; ++ring)
    for (const int side : {1, -1}) {
      Coefficient low = 1 + Coefficient(side) * grid * Coefficient(ring) + grid / 7,
                  high = low + Coefficient(side) * grid;
      Coefficient at_low = with_last_node(before, low).gap, at_high = with_last_node(before, high).gap;
      if (!(at_low * at_high <= 0) || !std::isfinite(at_low * at_high)) continue;
      for (int n = 0; n < 90; ++n) {
        const Coefficient middle = (low + high) / 2, gap = with_last_node(before, middle).gap;
        if (gap * at_low <= 0)
          high = middle;
        else
          low = middle, at_low = gap;
      }
      const Attempt found = with_last_node(before, (low + high) / 2);
      Coefficient largest = 0;
      for (const auto& row : found.stages.a)
        for (const Coefficient value : row) largest = std::max(largest, std::abs(value));
      // not the change of sign at a pole, where a weight vanishes
      if (std::abs(found.gap) < 1e-16L && largest < 5) return found.stages;
    }
  return {};
}

}  // namespace odemark
