// Algebraic order of a Runge-Kutta tableau by rooted trees, at compile time or run time.
#pragma once

#include <limits>

#include "integrators/stepper.hpp"

namespace odemark {

inline constexpr int highest_tree_order = 11;

/// A rooted tree as the levels of its nodes in preorder, root = 1.
struct RootedTree {
  std::array<int, highest_tree_order> level{};
  int order = 0;

  static constexpr RootedTree tallest(int order) {
    RootedTree tree;
    tree.order = order;
    for (int i = 0; i < order; ++i) tree.level[std::size_t(i)] = i + 1;
    return tree;
  }
  /// The next tree of the same order, until the bush (T. Beyer, S. M. Hedetniemi, SIAM J. Comput. 9 (1980)
  /// 706-712). Starting from the tallest every tree comes up exactly once.
  constexpr bool advance() {
    int p = order - 1;
    while (p > 0 && level[std::size_t(p)] == 2) --p;
    if (p <= 0) return false;
    int q = p - 1;
    while (level[std::size_t(q)] != level[std::size_t(p)] - 1) --q;
    for (int i = p; i < order; ++i) level[std::size_t(i)] = level[std::size_t(i - (p - q))];
    return true;
  }
  constexpr int parent(int node) const {
    int q = node - 1;
    while (level[std::size_t(q)] != level[std::size_t(node)] - 1) --q;
    return q;
  }
};

/// b . Phi(tree) - 1 / gamma(tree) and the sum of the absolute values of what was added (its rounding scale).
struct TreeResidual {
  Coefficient residual = 0, size = 0;

  constexpr bool vanishes(std::size_t stages) const {
    return within(1e-17L * Coefficient(stages));
  }  // 200 s u
  constexpr bool within(Coefficient share) const {
    return residual <= share * size && residual >= -share * size;
  }
};

/// Phi(tree) stage by stage, the same of absolute values, and gamma(tree): E. Hairer, S. P. Norsett, G.
/// Wanner, Solving ODEs I, II.2.
template <std::size_t S>
struct TreeWeights {
  std::array<Coefficient, S> weight{}, magnitude{};
  Coefficient gamma = 1;

  constexpr TreeWeights(const std::array<std::array<Coefficient, S>, S>& a, const RootedTree& tree) {
    std::array<std::array<Coefficient, S>, highest_tree_order> weights{}, magnitudes{};
    std::array<int, highest_tree_order> subtree{};
    for (auto& w : weights) w.fill(1);
    for (auto& w : magnitudes) w.fill(1);
    for (int node = tree.order - 1; node >= 0; --node) {
      const auto n = std::size_t(node);
      gamma *= Coefficient(++subtree[n]);
      if (node == 0) break;
      const auto up = std::size_t(tree.parent(node));
      subtree[up] += subtree[n];
      for (std::size_t i = 0; i < S; ++i) {
        Coefficient sum = 0, absolute = 0;
        for (std::size_t j = 0; j < S; ++j) {
          if (a[i][j] == 0) continue;  // most of an explicit tableau
          sum += a[i][j] * weights[n][j];
          absolute += (a[i][j] < 0 ? -a[i][j] : a[i][j]) * magnitudes[n][j];
        }
        weights[up][i] *= sum;
        magnitudes[up][i] *= absolute;
      }
    }
    weight = weights[0], magnitude = magnitudes[0];
  }
  constexpr TreeResidual against(const std::array<Coefficient, S>& b) const {
    TreeResidual r;
    for (std::size_t i = 0; i < S; ++i) {
      r.residual += b[i] * weight[i];
      r.size += (b[i] < 0 ? -b[i] : b[i]) * magnitude[i];
    }
    r.residual -= 1 / gamma;
    r.size += 1 / gamma;
    return r;
  }
};

/// The order, proved: every condition up to it holds and one of the next order does not. Looks up to
/// `highest`.
template <std::size_t S>
constexpr int algebraic_order(const std::array<std::array<Coefficient, S>, S>& a,
                              const std::array<Coefficient, S>& b, int highest) {
  for (int order = 1; order <= highest; ++order) {
    auto tree = RootedTree::tallest(order);
    do {
      if (!TreeWeights<S>(a, tree).against(b).vanishes(S)) return order - 1;
    } while (tree.advance());
  }
  return highest;
}

/// The order of the values between steps: b_j(theta) = sum_k dense[j][k] theta^(k+1) must meet b(theta) .
/// Phi(tree) = theta^order / gamma power by power, and be b at theta = 1. `Total` stages: those of the step,
/// and those that only values between steps need where there are some. A term of a tree of n nodes has n
/// coefficients, each rounded, and n - 1 products, rounded again: 2 n units of roundoff are all that is
/// excused.
template <std::size_t Total, class Method>
constexpr int dense_order_of(const Method& m, int highest) {
  using Weights = std::array<Coefficient, Total>;
  constexpr Coefficient unit = std::numeric_limits<Coefficient>::epsilon() / 2;
  constexpr std::size_t degree = std::tuple_size_v<std::remove_cvref_t<decltype(m.dense[0])>>;
  std::array<Weights, Total> a{};
  for (std::size_t i = 0; i < Total; ++i)
    for (std::size_t j = 0; j < i; ++j)
      a[i][j] = i >= Method::stages ? m.a_dense[i - Method::stages][j] : m.a[i][j];
  for (std::size_t j = 0; j < Total; ++j) {
    Coefficient gap = j < Method::stages ? -m.b[j] : 0, size = 1;
    for (const Coefficient part : m.dense[j]) gap += part, size += part < 0 ? -part : part;
    if (!(gap <= 1e-18L * size && gap >= -1e-18L * size)) return 0;
  }
  for (int order = 1; order <= highest; ++order) {
    auto tree = RootedTree::tallest(order);
    do {
      const TreeWeights<Total> phi(a, tree);
      for (std::size_t k = 0; k < degree; ++k) {
        Weights column{};
        for (std::size_t j = 0; j < Total; ++j) column[j] = m.dense[j][k];
        TreeResidual power = phi.against(column);
        if (int(k) + 1 != order) power.residual += 1 / phi.gamma;
        if (!power.within(2 * Coefficient(order) * unit)) return order - 1;
      }
    } while (tree.advance());
  }
  return highest;
}
template <class Method>
constexpr int algebraic_dense_order(const Method& m, int highest) {
  constexpr std::size_t most = std::tuple_size_v<std::remove_cvref_t<decltype(m.dense)>>;
  return m.dense_stages == 0 ? dense_order_of<Method::stages>(m, highest) : dense_order_of<most>(m, highest);
}
template <class Method>
constexpr bool dense_order_holds(const Method& m) {
  return algebraic_dense_order(m, m.dense_order + 1) == m.dense_order;
}

/// Does the tableau have exactly the orders it claims? A wrong coefficient does not compile.
template <class Method>
constexpr bool orders_hold(const Method& m) {
  return algebraic_order(m.a, m.b, m.order + 1) == m.order &&
         (m.embedded_order == 0 ||
          algebraic_order(m.a, m.b_embedded, m.embedded_order + 1) == m.embedded_order);
}

}  // namespace odemark
