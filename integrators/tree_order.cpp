// Elementary weights of all trees: in long double with their rounding scale, then in integers.
#include "integrators/tree_order.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "integrators/fractions.hpp"
#include "integrators/rooted_trees.hpp"

namespace odemark {

namespace {

using Integer = boost::multiprecision::cpp_int;

/// The weights g(t) of one tableau in numbers N, tree after tree.
template <class N>
class Weights {
 public:
  /// `single` is used on the edge of a node with one branch, `several` on the edges of others; row by row.
  Weights(std::size_t stages, std::vector<N> several, std::vector<N> single)
      : stages_(stages), several_(std::move(several)), single_(std::move(single)) {}

  /// Call with every tree, in the order of the list.
  const std::vector<N>& add(const BranchedTree& tree) {
    products_.emplace_back(stages_, N(1));
    weights_.emplace_back(stages_, N(1));
    if (tree.rest != BranchedTree::none) {
      const auto& branch = through(several_, moved_, tree.branch);
      for (std::size_t i = 0; i < stages_; ++i) products_.back()[i] = products_[tree.rest][i] * branch[i];
      weights_.back() = tree.branches == 1 && !single_.empty() ? through(single_, moved_single_, tree.branch)
                                                               : products_.back();
    }
    return weights_.back();
  }

 private:
  const std::vector<N>& through(const std::vector<N>& matrix, std::vector<std::vector<N>>& cache,
                                std::size_t tree) {
    if (cache.size() <= tree) cache.resize(tree + 1);
    auto& out = cache[tree];
    if (out.empty()) {
      out.assign(stages_, N(0));
      for (std::size_t i = 0; i < stages_; ++i)
        for (std::size_t j = 0; j < stages_; ++j)
          if (matrix[i * stages_ + j] != 0) out[i] += matrix[i * stages_ + j] * weights_[tree][j];
    }
    return out;
  }

  std::size_t stages_;
  std::vector<N> several_, single_;
  std::vector<std::vector<N>> weights_, products_, moved_, moved_single_;
};

std::vector<Coefficient> sum(const std::vector<Coefficient>& a, const std::vector<Coefficient>& b) {
  std::vector<Coefficient> out = a;
  for (std::size_t i = 0; i < b.size(); ++i) out[i] += b[i];
  return out;
}

template <class F>
auto map(const std::vector<Coefficient>& from, F f) {
  std::vector<decltype(f(from[0]))> out;
  for (const Coefficient x : from) out.push_back(f(x));
  return out;
}

/// Do all conditions up to `order` hold exactly? In integers: every coefficient times the common denominator,
/// so that a tree of n nodes comes out n - 1 times too large by that factor, its b once more.
bool holds_exactly(const Tableau& tableau, const std::vector<Coefficient>& b, int order,
                   const std::vector<BranchedTree>& trees) {
  constexpr std::size_t most_bits = 20'000;  // of the largest numbers: beyond it a proof takes seconds
  std::vector<Coefficient> all = tableau.a;
  all.insert(all.end(), tableau.gamma.begin(), tableau.gamma.end());
  all.insert(all.end(), b.begin(), b.end());
  Integer common = 1;
  for (const Coefficient x : all) {
    const auto fraction = simplest_fraction(x);
    if (!fraction) return false;
    common = boost::multiprecision::lcm(common, Integer(fraction->denominator));
    if (msb(common) * std::size_t(order) > most_bits) return false;
  }
  const auto scaled = [&](Coefficient x) {
    const auto fraction = *simplest_fraction(x);
    return Integer(common / fraction.denominator * fraction.numerator);
  };
  const auto a = map(tableau.a, scaled), gamma = map(tableau.gamma, scaled), weights = map(b, scaled);
  auto single = gamma.empty() ? gamma : a;
  for (std::size_t i = 0; i < gamma.size(); ++i) single[i] += gamma[i];
  Weights<Integer> elementary(tableau.stages, a, single);
  for (const auto& tree : trees) {
    if (tree.order > order) return true;
    const auto& g = elementary.add(tree);
    Integer left = 0, right = 1;
    for (std::size_t i = 0; i < g.size(); ++i) left += weights[i] * g[i];
    for (int k = 0; k < tree.order; ++k) right *= common;
    // gamma(t) of trees with up to 20 nodes is an integer that long double holds
    if (left * Integer(static_cast<std::uint64_t>(tree.gamma)) != right) return false;
  }
  return true;
}

}  // namespace

TreeOrder tree_order(const Tableau& tableau, const std::vector<Coefficient>& b, int highest) {
  constexpr Coefficient unit = std::numeric_limits<Coefficient>::epsilon() / 2;
  const auto size_of = [](Coefficient x) { return std::abs(x); };
  const bool row = !tableau.gamma.empty();
  const auto single = row ? sum(tableau.a, tableau.gamma) : std::vector<Coefficient>{};
  Weights<Coefficient> values(tableau.stages, tableau.a, single),
      sizes(tableau.stages, map(tableau.a, size_of), map(single, size_of));
  const Coefficient tolerance = 20 * Coefficient(tableau.stages) * unit;
  TreeOrder out;
  std::vector<BranchedTree> trees;
  Coefficient worst = 0;
  for (int order = 1; order <= highest + 1; ++order) {
    const std::size_t known = trees.size();
    trees = rooted_trees(order);
    Coefficient squares = 0;
    bool holds = true;
    for (std::size_t t = known; t < trees.size(); ++t) {
      const auto &g = values.add(trees[t]), &s = sizes.add(trees[t]);
      Coefficient residual = -1 / trees[t].gamma, size = 1 / trees[t].gamma;
      for (std::size_t i = 0; i < b.size(); ++i) residual += b[i] * g[i], size += std::abs(b[i]) * s[i];
      const Coefficient roundings = std::abs(residual) / size / unit;
      if (!(roundings * unit <= tolerance))
        holds = false;
      else
        worst = std::max(worst, roundings);
      squares += residual / trees[t].symmetry * (residual / trees[t].symmetry);
    }
    out.principal_error_norm = std::sqrt(squares);
    if (!holds) break;
    out.order = order, out.worst_residual = worst;
  }
  out.exact = holds_exactly(tableau, b, out.order, trees);
  return out;
}

std::size_t count_trees(int order) {
  std::size_t n = 0;
  for (const auto& tree : rooted_trees(order)) n += tree.order == order;
  return n;
}

}  // namespace odemark
