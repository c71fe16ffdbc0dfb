// Algebraic order of Nystrom methods for x'' = a(t, x) by special Nystrom trees, at compile time or run time.
#pragma once

#include "integrators/theory.hpp"

namespace odemark {

/// Special Nystrom trees (HNW I, II.14): the root is an acceleration; its branches are velocities, which end
/// there and count 1, or accelerations by way of a velocity, which count 1 more than their own tree.
/// Tree k of the table has `velocities` ended branches and, in child[first .. first + children), the rest.
/// Highest 9 is enough for most and cheap at compile time; 13 is the most.
template <int Highest = 9>
struct NystromTrees {
  static_assert(Highest == 9 || Highest == 13);
  static constexpr std::size_t most = Highest == 9 ? 151 : 2202, most_children = 3 * most;
  std::array<int, most> order{}, velocities{};
  std::array<std::size_t, most> first{}, children{};
  std::array<std::size_t, most_children> child{};
  std::size_t count = 0, used = 0;
  /// What the elementary weight of a tree of order r is on the exact solution, as a multiple of s^(r-1).
  std::array<Coefficient, most> exact{};

  /// Those of up to `highest` <= Highest.
  explicit constexpr NystromTrees(int highest) {
    for (int n = 1; n <= highest; ++n) {
      std::array<std::size_t, Highest> chosen{};
      add(n, n - 1, count, chosen, 0);
    }
  }

 private:
  /// All ways to fill `rest` with branches that are no later in the table than the one before (`below` the
  /// next index allowed + 1): every multiset once.
  constexpr void add(int n, int rest, std::size_t below, std::array<std::size_t, Highest>& chosen,
                     std::size_t depth) {
    order[count] = n, velocities[count] = rest, first[count] = used, children[count] = depth;
    exact[count] = 1;
    for (std::size_t i = 0; i < depth; ++i) {
      child[used++] = chosen[i];
      const int r = order[chosen[i]];
      exact[count] *= exact[chosen[i]] / Coefficient(r * (r + 1));
    }
    ++count;
    for (std::size_t k = 0; k < below; ++k)
      if (order[k] + 1 <= rest) {
        chosen[depth] = k;
        add(n, rest - order[k] - 1, k + 1, chosen, depth + 1);
      }
  }
};

/// The order up to which both rows of weights meet every condition: sum b_velocity Phi = exact / r for trees
/// of order r <= p, sum b_position Phi = exact / (r (r + 1)) for r < p. `tolerance` is relative to the sum of
/// the absolute values of what is added. Looks up to `highest` <= Highest. Not inlined: its tables are large.
template <int Highest = 9, std::size_t S>
[[gnu::noinline]] constexpr int nystrom_order(const std::array<std::array<Coefficient, S>, S>& a,
                                              const std::array<Coefficient, S>& c,
                                              const std::array<Coefficient, S>& b_position,
                                              const std::array<Coefficient, S>& b_velocity, int highest,
                                              Coefficient tolerance = 1e-18L * Coefficient(S)) {
  const NystromTrees<Highest> trees(highest);
  std::array<std::array<Coefficient, S>, NystromTrees<Highest>::most> weight{}, magnitude{};
  int position_order = highest, velocity_order = highest;
  const auto absolute = [](Coefficient x) { return x < 0 ? -x : x; };
  for (std::size_t k = 0; k < trees.count; ++k) {
    for (std::size_t i = 0; i < S; ++i) {
      weight[k][i] = 1;
      for (int n = 0; n < trees.velocities[k]; ++n) weight[k][i] *= c[i];
      magnitude[k][i] = absolute(weight[k][i]);
    }
    for (std::size_t n = 0; n < trees.children[k]; ++n) {
      const std::size_t below = trees.child[trees.first[k] + n];
      for (std::size_t i = 0; i < S; ++i) {
        Coefficient sum = 0, size = 0;
        for (std::size_t j = 0; j < S; ++j) {
          sum += a[i][j] * weight[below][j];
          size += absolute(a[i][j]) * magnitude[below][j];
        }
        weight[k][i] *= sum, magnitude[k][i] *= size;
      }
    }
    const auto holds = [&](const std::array<Coefficient, S>& b, Coefficient right) {
      Coefficient sum = -right, size = right;
      for (std::size_t i = 0; i < S; ++i)
        sum += b[i] * weight[k][i], size += absolute(b[i]) * magnitude[k][i];
      return absolute(sum) <= tolerance * size;
    };
    const int r = trees.order[k];
    const auto lower = [](int& order, int to) { order = to < order ? to : order; };
    if (!holds(b_velocity, trees.exact[k] / Coefficient(r))) lower(velocity_order, r - 1);
    if (!holds(b_position, trees.exact[k] / Coefficient(r * (r + 1)))) lower(position_order, r);
  }
  return position_order < velocity_order ? position_order : velocity_order;
}

template <class Method>
concept IsNystrom = requires(const Method& m) {
  m.b_position_embedded;
};

/// The orders of a Nystrom method up to one beyond its claims; 0 where the nodes do not belong to the rows:
/// sum_j a_ij = c_i^2/2. The embedded weights may be of higher order in one of the two.
template <IsNystrom Method>
constexpr ProvedOrders proved_orders(const Method& m) {
  for (std::size_t i = 0; i < Method::stages; ++i) {
    Coefficient sum = -m.c[i] * m.c[i] / 2;
    for (std::size_t j = 0; j < Method::stages; ++j) sum += m.a[i][j];
    if (!(sum <= 1e-17L && sum >= -1e-17L)) return {};
  }
  constexpr int highest = Method::stages > 9 ? 13 : 9;
  ProvedOrders found{nystrom_order<highest>(m.a, m.c, m.b_position, m.b_velocity, m.order + 1)};
  if (m.embedded_order > 0)
    found.embedded_order =
        nystrom_order<highest>(m.a, m.c, m.b_position_embedded, m.b_velocity_embedded, m.embedded_order + 1);
  return found;
}

/// Are they as claimed?
template <IsNystrom Method>
constexpr bool orders_hold(const Method& m) {
  const ProvedOrders found = proved_orders(m);
  return found.order == m.order && found.embedded_order == m.embedded_order;
}

}  // namespace odemark
