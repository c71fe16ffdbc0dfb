// phi_0 .. phi_4 against the exponential in 100 digits, for numbers and matrices, in every number type.
#include "integrators/phi_functions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace odemark::phi_functions_test {
namespace {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<160>>;
using WideMatrix = std::vector<Wide>;  // column-major

constexpr int highest = 4;

WideMatrix product(std::size_t n, const WideMatrix& a, const WideMatrix& b) {
  WideMatrix out(n * n, Wide(0));
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < n; ++i) out[j * n + i] += a[k * n + i] * b[j * n + k];
  return out;
}

/// Straight from the definition: sum_j z^j / (j + k)!, with digits to spare for everything that cancels.
std::vector<WideMatrix> exact_phi(std::size_t n, const WideMatrix& z) {
  std::vector<WideMatrix> phi(highest + 1, WideMatrix(n * n, Wide(0)));
  WideMatrix power(n * n, Wide(0));
  for (std::size_t i = 0; i < n; ++i) power[i * n + i] = 1;
  for (int j = 0; j < 1200; ++j) {
    Wide factorial = 1;  // (j + k)!/j! runs along k; power is z^j / j!
    Wide largest = 0;
    for (int k = 0; k <= highest; ++k) {
      if (k > 0) factorial *= j + k;
      for (std::size_t i = 0; i < n * n; ++i) {
        const Wide term = power[i] / factorial;
        phi[std::size_t(k)][i] += term;
        if (abs(term) > largest) largest = abs(term);
      }
    }
    if (j > 4 && largest < Wide("1e-120")) break;
    power = product(n, power, z);
    for (auto& p : power) p /= j + 1;
  }
  return phi;
}

constexpr std::array<PhiSum, highest + 1> all_phi{phi(0), phi(1), phi(2), phi(3), phi(4)};

/// Largest error over phi_0 .. phi_4, each relative to its largest entry, in units of roundoff.
template <class T>
double worst_error(std::size_t n, const std::vector<T>& z) {
  PhiWeights<T> weights(n, all_phi.data(), all_phi.size());
  std::copy(z.begin(), z.end(), weights.matrix());
  weights.prepare(T(1));
  WideMatrix wide;
  for (const T x : z) wide.emplace_back(x);
  const auto exact = exact_phi(n, wide);
  double worst = 0;
  for (int k = 0; k <= highest; ++k) {
    Wide size = 0, error = 0;
    for (std::size_t j = 0; j < n; ++j) {
      std::vector<T> unit(n, T(0)), column(n, T(0));
      unit[j] = T(1);
      weights.add_product(std::size_t(k), unit.data(), column.data());
      for (std::size_t i = 0; i < n; ++i) {
        const Wide& e = exact[std::size_t(k)][j * n + i];
        size = std::max<Wide>(size, abs(e)), error = std::max<Wide>(error, abs(Wide(column[i]) - e));
      }
    }
    // below the smallest normal number there are fewer digits to be right
    const Wide unit_of = size * Wide(std::numeric_limits<T>::epsilon()) / 2 +
                         Wide(std::numeric_limits<T>::min()) * Wide(std::numeric_limits<T>::epsilon());
    const double ratio = static_cast<double>(Wide(error / unit_of));
    if (!(ratio <= worst)) worst = ratio;
  }
  return worst;
}

std::vector<double> magnitudes() {
  std::vector<double> out;
  for (int i = -16; i <= 4; ++i) out.push_back(std::pow(10.0, i / 2.0));
  return out;
}

/// What round-off allows: e^z itself changes by |z| units in the last place when z changes by one. Numbers
/// narrower than long double are computed in it and have that spared.
template <class T>
double allowed(double size) {
  return sizeof(T) < sizeof(long double) ? 1.25 : 40 + 4 * size;
}

template <class T>
void expect_round_off() {
  for (const double r : magnitudes()) {
    SCOPED_TRACE(std::to_string(r));
    const T x = static_cast<T>(r);
    if (std::exp(r) < static_cast<double>(std::numeric_limits<float>::max()) || sizeof(T) > 4) {
      EXPECT_LE(worst_error<T>(1, {x}), allowed<T>(r)) << "growth";
    }
    EXPECT_LE(worst_error<T>(1, {-x}), allowed<T>(r)) << "decay";
    EXPECT_LE(worst_error<T>(2, {0, -x, x, 0}), allowed<T>(r)) << "rotation";
    EXPECT_LE(worst_error<T>(2, {-x, 0, x, -x}), allowed<T>(2 * r)) << "a Jordan block";
    EXPECT_LE(worst_error<T>(3, {-x, 0, 0, 30 * x, -x / 2, 0, 0, 20 * x, -x / 4}), allowed<T>(60 * r))
        << "far from normal";
    EXPECT_LE(worst_error<T>(2, {0, 0, x, 0}), allowed<T>(r)) << "nilpotent";
  }
}

TEST(PhiFunctions, AreAccurateToRoundOffInFloat) { expect_round_off<float>(); }
TEST(PhiFunctions, AreAccurateToRoundOffInDouble) { expect_round_off<double>(); }
TEST(PhiFunctions, AreAccurateToRoundOffInLongDouble) { expect_round_off<long double>(); }

/// The planted fault: the formula of the definition, which the bounds above must refuse.
TEST(PhiFunctions, TheNaiveFormulaWouldNotPass) {
  int refused = 0;
  for (const double z : magnitudes()) {
    const double naive = (std::exp(-z) - 1) / -z;
    const double exact = static_cast<double>(exact_phi(1, {Wide(-z)})[1][0]);
    refused += std::abs(naive - exact) > 1.25 * std::numeric_limits<double>::epsilon() / 2 * exact;
  }
  EXPECT_GE(refused, 6);
}

TEST(PhiFunctions, ScalesAndSumsAreTheirDefinition) {
  constexpr std::array<PhiSum, 2> sums{0.5L * phi(1, 0.5L) - 2 * phi(3), phi(2, 0) + phi(2, 0)};
  static_assert(sums[1].count == 1 && sums[1].at_zero() == 1);
  static_assert((phi(4) - phi(4)).is_zero());
  PhiWeights<double> weights(1, sums.data(), sums.size());
  *weights.matrix() = -3;
  weights.prepare(2);
  const double one = 1;
  double first = 0, second = 0;
  weights.add_product(0, &one, &first);
  weights.add_product(1, &one, &second);
  const auto half = exact_phi(1, {Wide(-3)}), whole = exact_phi(1, {Wide(-6)});
  EXPECT_NEAR(first, 2 * (0.5 * static_cast<double>(half[1][0]) - 2 * static_cast<double>(whole[3][0])),
              1e-16);
  EXPECT_EQ(second, 2);
}

TEST(PhiFunctions, NotANumberStaysOne) {
  PhiWeights<double> weights(1, all_phi.data(), all_phi.size());
  for (const double z : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    *weights.matrix() = z;
    weights.prepare(1);
    const double one = 1;
    double out = 0;
    weights.add_product(1, &one, &out);
    EXPECT_NE(out, out);
  }
}

}  // namespace
}  // namespace odemark::phi_functions_test
