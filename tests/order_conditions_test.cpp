// Trees are counted right, and every tableau and every splitting has exactly the orders it claims.
#include "integrators/order_conditions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "integrators/catalogue.hpp"
#include "integrators/collocation_tableau.hpp"
#include "tests/support/runs.hpp"

namespace odemark::order_conditions_test {
namespace {

template <class F, const auto&... methods>
void for_each_method(MethodList<methods...>, F&& f) {
  (f(methods), ...);
}

/// The coefficients of a method as an array of rows: its own, or what its low-storage form amounts to.
const auto& tableau_of(const auto& method) requires requires { method.a, method.b, method.stages; }
{ return method; }
auto tableau_of(const auto& method) requires requires { method.tableau().a; }
{ return method.tableau(); }
template <class M>
concept HasTableau = requires(const M& m) {
  { tableau_of(m).b[0] } -> std::convertible_to<Coefficient>;
};

TEST(OrderConditions, TreesAreCountedRight) {
  const int expected[] = {1, 1, 2, 4, 9, 20, 48, 115, 286, 719, 1842};  // OEIS A000081
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
      const auto& tableau = tableau_of(method);
      if (method.order < highest_tree_order) {
        EXPECT_EQ(algebraic_order(tableau.a, tableau.b, method.order + 1), method.order);
      } else {  // trees up to there, and the simplifying assumptions beyond
        EXPECT_EQ(algebraic_order(tableau.a, tableau.b, highest_tree_order), highest_tree_order);
        EXPECT_EQ(simplifying_assumptions(tableau.a, tableau.b).proved_order(), method.order);
      }
      if constexpr (requires { method.b_embedded; }) {
        if (method.embedded_order > 0) {
          EXPECT_EQ(algebraic_order(method.a, method.b_embedded, method.embedded_order + 1),
                    method.embedded_order);
          EXPECT_NE(method.b, method.b_embedded);
        }
      }
      if constexpr (requires { method.b_second_embedded; }) {
        if (method.second_embedded_order > 0) {
          EXPECT_EQ(algebraic_order(method.a, method.b_second_embedded, method.second_embedded_order + 1),
                    method.second_embedded_order);
          EXPECT_LT(method.second_embedded_order, method.embedded_order);
        }
      }
    }
  });
  EXPECT_GE(tableaux, 50);
}

/// A sum minus one with twice the digits: every addition keeps what it rounds away (D. E. Knuth, The Art of
/// Computer Programming II, 4.2.2, theorem C).
template <std::size_t S>
double excess_over_one(const std::array<Coefficient, S>& weights) {
  Coefficient sum = -1, rest = 0;
  for (const Coefficient w : weights) {
    const Coefficient next = sum + w, added = next - sum;
    rest += (sum - (next - added)) + (w - added);
    sum = next;
  }
  return double(sum + rest);
}

/// Every weight is off by half a unit in its last place at most, where it is written as a decimal or as one
/// fraction; an expression of a few roundings may take that three times.
TEST(OrderConditions, WeightsSumToOneUpToTheirOwnRounding) {
  for_each_method(SuiteMethods{}, [](const auto& method) {
    if constexpr (HasTableau<std::remove_cvref_t<decltype(method)>>) {
      const auto b = tableau_of(method).b;
      const double rounding = double(sum_of_magnitudes(b) * std::numeric_limits<Coefficient>::epsilon() / 2);
      // the fractions that Prince and Dormand printed, of 18 digits, sum to this themselves
      const double printed = method.id == "dormand_prince87" ? -3.685314672982368e-18 : 0;
      EXPECT_NEAR(excess_over_one(b), printed, 1.5 * rounding) << method.id;
    }
  });
  auto wrong = rk4.b;
  wrong[1] += 1e-19L;
  EXPECT_GT(excess_over_one(wrong), 1.5 * double(std::numeric_limits<Coefficient>::epsilon()) / 2);
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
    const double term = double(TreeWeights<S>(a, tree).against(b).residual) / double(symmetry(levels));
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
      const double inverse_gamma = -double(TreeWeights<1>(a, tree).against(b).residual);
      sum += factorial * inverse_gamma / double(symmetry(levels));
    } while (tree.advance());
    EXPECT_NEAR(sum, factorial / order, 1e-9 * factorial) << "of order " << order;
  }
}

TEST(OrderConditions, TheTsitourasEmbeddingIsThePublishedOne) {
  EXPECT_NEAR(principal_error_norm(tsitouras54.a, tsitouras54.b_embedded, 4), 1.065e-3, 0.001e-3);
  EXPECT_LT(principal_error_norm(tsitouras54.a, tsitouras54.b, 5), 2e-4);
}

template <class M>
concept IsSplitting = requires(const M& m) {
  m.drift, m.kick;
};

TEST(OrderConditions, SpecialNystromTreesAreCountedRight) {
  const int expected[] = {1, 1, 2, 3, 6, 10, 20, 36, 72, 137, 275, 541, 1098};  // HNW I, II.14, table 14.3
  const auto trees = [](int highest) { return NystromTrees<13>(highest); }(std::size(expected));
  std::array<int, 14> count{};
  for (std::size_t k = 0; k < trees.count; ++k) ++count[std::size_t(trees.order[k])];
  for (std::size_t n = 1; n <= 13; ++n) EXPECT_EQ(count[n], expected[n - 1]) << n;
  EXPECT_EQ(trees.count, trees.most);
  EXPECT_LE(trees.used, trees.most_children);
}

TEST(OrderConditions, EverySplittingHasExactlyItsOrder) {
  std::map<std::string_view, int> separable;
  for_each_method(SuiteMethods{}, [&](const auto& method) {
    if constexpr (IsSplitting<std::remove_cvref_t<decltype(method)>>) {
      SCOPED_TRACE(method.id);
      EXPECT_EQ(splitting_order(method, method.order + 1), method.order);
      separable[method.id] = separable_order(method, method.order + 1);
      Coefficient drifts = 0, kicks = 0;
      for (const Coefficient w : method.drift) drifts += w;
      for (const Coefficient w : method.kick) kicks += w;
      EXPECT_LE(std::abs(drifts - 1), 1e-18L);
      EXPECT_LE(std::abs(kicks - 1), 1e-18L);
    }
  });
  EXPECT_GE(separable.size(), 21u);
  // what holds for quadratic kinetic energy only, by two independent proofs; all others hold for any split
  for (const auto& [id, order] : separable) {
    const std::map<std::string_view, int> lower{
        {"mclachlan_atela4", 3}, {"calvo_sanz_serna4", 3}, {"blanes_moan_rkn6", 4}};
    const auto found = lower.find(id);
    EXPECT_EQ(order, found == lower.end() ? suite_method(id).order : found->second) << id;
  }
}

TEST(OrderConditions, EveryNystromMethodHasExactlyItsOrders) {
  int methods = 0;
  for_each_method(SuiteMethods{}, [&](const auto& method) {
    if constexpr (requires { method.b_position_embedded; }) {
      SCOPED_TRACE(method.id);
      ++methods;
      EXPECT_TRUE(orders_hold(method));
    }
  });
  EXPECT_GE(methods, 5);
}

/// Changing the last digits that a double would not hold is noticed, and swapping what belongs to x and to v.
TEST(OrderConditions, OneWrongDigitOfASplittingIsSeen) {
  for (const Coefficient slip : {1e-3L, 1e-8L, 1e-13L, 2e-16L}) {
    SCOPED_TRACE(double(slip));
    // keeps the sums, so that only the order conditions can tell
    const auto spoil = [&](auto m) {
      m.kick[1] += slip, m.kick[2] -= slip;
      return m;
    };
    EXPECT_TRUE(spoil(blanes_moan4).consistent());
    EXPECT_EQ(splitting_order(spoil(blanes_moan4), 5), slip > 1e-15L ? 1 : 2);
    EXPECT_LT(splitting_order(spoil(kahan_li6), 7), 3);
    EXPECT_LT(splitting_order(spoil(yoshida8), 9), 3);
    EXPECT_LT(separable_order(spoil(kahan_li6), 7), 3);
    auto lost = pefrl;
    lost.drift[2] += slip;
    EXPECT_EQ(splitting_order(lost, 5), 0);
    EXPECT_FALSE(orders_hold(lost));
  }
  // the coefficients as printed, to 15 digits, have a floor that these proofs see
  auto printed = blanes_moan6;
  printed.kick = mirrored<11, 10>(std::array<Coefficient, 4>{0.148816447901042L, -0.132385865767784L,
                                                             0.067307604692185L, 0.432666402578175L});
  EXPECT_TRUE(printed.consistent());
  EXPECT_LT(splitting_order(printed, 7), 6);
}

TEST(OrderConditions, OneWrongDigitOfANystromMethodIsSeen) {
  auto wrong = rkn_dormand_prince64;
  wrong.a[4][2] = 65568.0L / 281250;
  EXPECT_FALSE(orders_hold(wrong));
  wrong = rkn_dormand_prince64;
  std::swap(wrong.b_position, wrong.b_velocity);
  EXPECT_FALSE(orders_hold(wrong));
  auto estimate = rkn_dormand_prince86;
  estimate.b_velocity_embedded[8] = -3.0L / 20;
  EXPECT_FALSE(orders_hold(estimate));
  auto misplaced = rkn_dormand_prince86;
  std::swap(misplaced.c[4], misplaced.c[5]);
  EXPECT_FALSE(orders_hold(misplaced));
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
  // the highest orders, which no compiler proves
  auto last_digits = verner98;
  last_digits.a[13][9] += 1e-14L;
  EXPECT_LT(algebraic_order(last_digits.a, last_digits.b, 9), 9);
  auto swapped = feagin108;
  std::swap(swapped.b[8], swapped.b[9]);
  EXPECT_LT(algebraic_order(swapped.a, swapped.b, 10), 10);
  auto second = dop853;
  second.b_second_embedded[8] += 1e-15L;
  EXPECT_EQ(algebraic_order(second.a, second.b_second_embedded, 3), 0);
  auto registers = carpenter_kennedy4;
  registers.carry[2] += 1e-14L;
  EXPECT_FALSE(orders_hold(registers.tableau()));
  auto claim = rk4;
  claim.order = 3;
  EXPECT_FALSE(orders_hold(claim)) << "a claim below the truth is wrong too";
}

}  // namespace
}  // namespace odemark::order_conditions_test
