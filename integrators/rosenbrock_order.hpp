// Order of Rosenbrock and W-methods by rooted trees, at compile time or run time.
#pragma once

#include "integrators/order_conditions.hpp"

namespace odemark {

/// One condition of a Rosenbrock tableau. Nodes with one child are of two sorts: with the exact Jacobian
/// their child hangs on beta = alpha + gamma; where the matrix is arbitrary, each is either alpha (f' was
/// meant) or gamma (the matrix was), and every tree with a gamma in it must vanish (E. Hairer, G. Wanner,
/// Solving ODEs II, IV.7, theorem 7.4 for the exact Jacobian and theorem 7.7 for W-methods).
template <std::size_t S>
struct RosenbrockTree {
  using Row = std::array<Coefficient, S>;
  using Matrix = std::array<Row, S>;
  Coefficient residual = 0, size = 0;

  /// Bit n of `matrix_nodes`: node n stands for the matrix. Negative: the exact Jacobian.
  constexpr RosenbrockTree(const Matrix& alpha, const Matrix& gamma, const Row& b, const RootedTree& tree,
                           int matrix_nodes) {
    std::array<Row, highest_tree_order> weight{}, magnitude{};
    std::array<int, highest_tree_order> subtree{}, children{};
    for (auto& w : weight) w.fill(1);
    for (auto& w : magnitude) w.fill(1);
    for (int node = 1; node < tree.order; ++node) ++children[std::size_t(tree.parent(node))];
    Coefficient density = 1;
    for (int node = tree.order - 1; node >= 0; --node) {
      const auto n = std::size_t(node);
      density *= Coefficient(++subtree[n]);
      if (node == 0) break;
      const auto up = std::size_t(tree.parent(node));
      subtree[up] += subtree[n];
      const bool single = children[up] == 1,
                 is_matrix = single && matrix_nodes > 0 && ((matrix_nodes >> up) & 1) != 0;
      const bool with_alpha = !is_matrix, with_gamma = is_matrix || (single && matrix_nodes < 0);
      for (std::size_t i = 0; i < S; ++i) {
        Coefficient sum = 0, absolute = 0;
        for (std::size_t j = 0; j <= i; ++j) {
          const Coefficient entry = (with_alpha ? alpha[i][j] : 0) + (with_gamma ? gamma[i][j] : 0);
          sum += entry * weight[n][j];
          absolute += (entry < 0 ? -entry : entry) * magnitude[n][j];
        }
        weight[up][i] *= sum;
        magnitude[up][i] *= absolute;
      }
    }
    for (std::size_t i = 0; i < S; ++i) {
      residual += b[i] * weight[0][i];
      size += (b[i] < 0 ? -b[i] : b[i]) * magnitude[0][i];
    }
    if (matrix_nodes <= 0) residual -= 1 / density;
    size += 1 / density;
  }
  constexpr bool vanishes() const {
    const Coefficient tolerance = 1e-17L * Coefficient(S) * size;
    return residual <= tolerance && residual >= -tolerance;
  }
};

/// The nodes of a tree that have exactly one child, as bits.
constexpr int single_nodes(const RootedTree& tree) {
  std::array<int, highest_tree_order> children{};
  for (int node = 1; node < tree.order; ++node) ++children[std::size_t(tree.parent(node))];
  int bits = 0;
  for (int node = 0; node < tree.order; ++node)
    if (children[std::size_t(node)] == 1) bits |= 1 << node;
  return bits;
}

/// The order with the exact Jacobian, proved as algebraic_order() does; looks up to `highest`.
template <std::size_t S>
constexpr int rosenbrock_order(const std::array<std::array<Coefficient, S>, S>& alpha,
                               const std::array<std::array<Coefficient, S>, S>& gamma,
                               const std::array<Coefficient, S>& b, int highest) {
  for (int order = 1; order <= highest; ++order) {
    auto tree = RootedTree::tallest(order);
    do {
      if (!RosenbrockTree<S>(alpha, gamma, b, tree, -1).vanishes()) return order - 1;
    } while (tree.advance());
  }
  return highest;
}

/// The order whatever matrix stands for the Jacobian.
template <std::size_t S>
constexpr int w_order(const std::array<std::array<Coefficient, S>, S>& alpha,
                      const std::array<std::array<Coefficient, S>, S>& gamma,
                      const std::array<Coefficient, S>& b, int highest) {
  for (int order = 1; order <= highest; ++order) {
    auto tree = RootedTree::tallest(order);
    do {
      const int singles = single_nodes(tree);
      for (int nodes = 0; nodes <= singles; ++nodes)
        if ((nodes & ~singles) == 0 && !RosenbrockTree<S>(alpha, gamma, b, tree, nodes).vanishes())
          return order - 1;
    } while (tree.advance());
  }
  return highest;
}

/// Exactly the orders it claims, and a W-method exactly where it says so.
template <class Method>
requires requires(const Method& m) { m.gamma; }
constexpr bool orders_hold(const Method& m) {
  return rosenbrock_order(m.alpha, m.gamma, m.b, m.order + 1) == m.order &&
         (m.embedded_order == 0 ||
          rosenbrock_order(m.alpha, m.gamma, m.b_embedded, m.embedded_order + 1) == m.embedded_order) &&
         m.w_method == (w_order(m.alpha, m.gamma, m.b, m.order) == m.order);
}

}  // namespace odemark
