// Rooted trees are counted right, and every tableau has exactly the orders it claims.
#include "integrators/order_conditions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "integrators/catalogue.hpp"
#include "integrators/collocation_tableau.hpp"

namespace odemark {
namespace {

template <class F, const auto&... methods>
void for_each_method(MethodList<methods...>, F&& f) {
  (f(methods), ...);
}

template <class M>
concept HasTableau = requires(const M& m) {
  m.a, m.b, M::stages;
};

TEST(OrderConditions, TreesAreCountedRight) {
  const int expected[] = {1, 1, 2, 4, 9, 20, 48, 115, 286, 719};  // OEIS A000081
  for (int order = 1; order <= highest_tree_order; ++order) {
    auto tree = RootedTree::tallest(order);
    int count = 1;
    while (tree.advance()) ++count;
    EXPECT_EQ(count, expected[order - 1]) << "of order " << order;
  }
}

TEST(OrderConditions, EveryTableauHasExactlyItsOrder) {
  int tableaux = 0;
  for_each_method(SuiteMethods{}, [&](const auto& method) {
    using M = std::remove_cvref_t<decltype(method)>;
    if constexpr (HasTableau<M>) {
      SCOPED_TRACE(method.id);
      ++tableaux;
      if (method.order < highest_tree_order) {
        EXPECT_EQ(algebraic_order(method.a, method.b, method.order + 1), method.order);
      } else {  // trees up to there, and the simplifying assumptions beyond
        EXPECT_EQ(algebraic_order(method.a, method.b, highest_tree_order), highest_tree_order);
        EXPECT_EQ(simplifying_assumptions(method.a, method.b).proved_order(), method.order);
      }
      if constexpr (requires { method.b_embedded; }) {
        if (method.embedded_order > 0) {
          EXPECT_EQ(algebraic_order(method.a, method.b_embedded, method.embedded_order + 1),
                    method.embedded_order);
          EXPECT_NE(method.b, method.b_embedded);
        }
      }
    }
  });
  EXPECT_GE(tableaux, 12);
}

TEST(OrderConditions, WeightsSumToOneInEveryNumberType) {
  for_each_method(SuiteMethods{}, [](const auto& method) {
    if constexpr (HasTableau<std::remove_cvref_t<decltype(method)>>) {
      const auto sum = std::accumulate(method.b.begin(), method.b.end(), Coefficient(0));
      EXPECT_NEAR(double(sum - 1), 0, 1e-18) << method.id;
    }
  });
}

/// Number of ways to relabel a tree onto itself: equal subtrees at one node may be exchanged.
long symmetry(const std::vector<int>& levels) {
  long total = 1, equal = 1;
  std::vector<int> previous;
  for (std::size_t begin = 1; begin < levels.size();) {
    std::size_t end = begin + 1;
    while (end < levels.size() && levels[end] > levels[begin]) ++end;
    const std::vector<int> child(levels.begin() + std::ptrdiff_t(begin),
                                 levels.begin() + std::ptrdiff_t(end));
    equal = child == previous ? equal + 1 : 1;
    total *= equal * symmetry(child);
    previous = child;
    begin = end;
  }
  return total;
}

template <std::size_t S>
double principal_error_norm(const std::array<std::array<Coefficient, S>, S>& a,
                            const std::array<Coefficient, S>& b, int order) {
  double squares = 0;
  auto tree = RootedTree::tallest(order + 1);
  do {
    const std::vector<int> levels(tree.level.begin(), tree.level.begin() + tree.order);
    const double term = double(TreeResidual<S>(a, b, tree).residual) / double(symmetry(levels));
    squares += term * term;
  } while (tree.advance());
  return std::sqrt(squares);
}

TEST(OrderConditions, SymmetriesSumToTheTreesOfEveryLabelling) {
  // sum of n! / (gamma sigma) over trees of order n counts the monotone labellings: (n - 1)!
  for (int order = 1; order <= 8; ++order) {
    double sum = 0, factorial = 1;
    for (int k = 2; k <= order; ++k) factorial *= k;
    auto tree = RootedTree::tallest(order);
    do {
      const std::vector<int> levels(tree.level.begin(), tree.level.begin() + tree.order);
      const std::array<std::array<Coefficient, 1>, 1> a{};
      const std::array<Coefficient, 1> b{};
      const double inverse_gamma = -double(TreeResidual<1>(a, b, tree).residual);
      sum += factorial * inverse_gamma / double(symmetry(levels));
    } while (tree.advance());
    EXPECT_NEAR(sum, factorial / order, 1e-9 * factorial) << "of order " << order;
  }
}

TEST(OrderConditions, TheTsitourasEmbeddingIsThePublishedOne) {
  EXPECT_NEAR(principal_error_norm(tsitouras54.a, tsitouras54.b_embedded, 4), 1.065e-3, 0.001e-3);
  EXPECT_LT(principal_error_norm(tsitouras54.a, tsitouras54.b, 5), 2e-4);
}

TEST(OrderConditions, SimplifyingAssumptionsSeeAWrongDigitAndAWrongClaim) {
  auto wrong = radau_iia5;
  wrong.a[0][1] += 1e-12L, wrong.a[0][2] -= 1e-12L;  // the nodes stay
  EXPECT_FALSE(orders_hold(wrong));
  auto claim = gauss6;
  claim.order = 5;
  EXPECT_FALSE(orders_hold(claim));
  auto estimate = gauss4;  // no real mode to filter an estimate with
  estimate.embedded_order = 2;
  EXPECT_FALSE(orders_hold(estimate));
  EXPECT_EQ(simplifying_assumptions(lobatto_iiib4.a, lobatto_iiib4.b).stage, 1);
  EXPECT_EQ(simplifying_assumptions(lobatto_iiic4.a, lobatto_iiic4.b).stage, 2);
  EXPECT_EQ(simplifying_assumptions(lobatto_iiia4.a, lobatto_iiia4.b).stage, 3);
}

TEST(OrderConditions, OneWrongDigitIsSeen) {
  auto wrong = dormand_prince54;
  wrong.a[5][3] = 48.0L / 176;
  EXPECT_FALSE(orders_hold(wrong));
  auto embedded = dormand_prince54;
  embedded.b_embedded = embedded.b;
  EXPECT_FALSE(orders_hold(embedded)) << "an embedding of higher order than claimed";
  auto claim = rk4;
  claim.order = 3;
  EXPECT_FALSE(orders_hold(claim)) << "a claim below the truth is wrong too";
}

}  // namespace
}  // namespace odemark
