// The number types a right-hand side runs on beyond the plain ones: lanes of an ensemble, and numbers that
// count.
#include <gtest/gtest.h>

#include <cstring>

#include "bench/family_system.hpp"
#include "integrators/counting_number.hpp"
#include "integrators/integrate.hpp"
#include "integrators/lanes.hpp"
#include "integrators/methods/dormand_prince54.hpp"
#include "integrators/methods/rk4.hpp"
#include "problems/kepler.hpp"
#include "problems/lorenz63.hpp"
#include "problems/oscillator.hpp"
#include "problems/pendulum.hpp"

namespace odemark::numbers_test {
namespace {

constexpr std::size_t width = 8;
using Pack = Lanes<double, width>;

/// Steps `width` copies with different initial states together, and each alone: the bits must be equal.
template <class F, const auto& method>
void expect_lanes_equal_single_runs(long steps, double t_end) {
  const FamilySystem<F, Pack> together{F{}};
  const FamilySystem<F, double> alone{F{}};
  std::array<double, F::size> start{};
  F{}.initial(start.data());
  std::array<Pack, F::size> pack;
  const auto nudged = [&](std::size_t lane, std::size_t i) {
    return start[i] * (1 + 0.015625 * double(lane));
  };
  for (std::size_t i = 0; i < F::size; ++i)
    for (std::size_t lane = 0; lane < width; ++lane) pack[i].lane[lane] = nudged(lane, i);
  StepperOf<method, FamilySystem<F, Pack>> pack_stepper(together, pack);
  EXPECT_EQ(integrate(pack_stepper, FixedSteps{steps}, 0, t_end, pack).status, RunStatus::reached_end);
  for (std::size_t lane = 0; lane < width; ++lane) {
    std::array<double, F::size> y;
    for (std::size_t i = 0; i < F::size; ++i) y[i] = nudged(lane, i);
    StepperOf<method, FamilySystem<F, double>> stepper(alone, y);
    integrate(stepper, FixedSteps{steps}, 0, t_end, y);
    for (std::size_t i = 0; i < F::size; ++i)
      EXPECT_EQ(std::memcmp(&y[i], &pack[i].lane[lane], sizeof(double)), 0) << F::id << " lane " << lane;
  }
}

TEST(Lanes, EachGetsTheBitsOfItsOwnRun) {
  expect_lanes_equal_single_runs<Lorenz63<double>, rk4>(500, 5);
  expect_lanes_equal_single_runs<Lorenz63<double>, dormand_prince54>(500, 5);
  expect_lanes_equal_single_runs<Kepler<double>, rk4>(500, 5);
  expect_lanes_equal_single_runs<Pendulum<double>, dormand_prince54>(100, 5);
}

template <class F>
OperationCounts count_rhs(const F& family, int& chain) {
  std::array<double, F::size> start{};
  family.initial(start.data());
  std::array<CountingNumber, F::size> y, slope;
  std::copy(start.begin(), start.end(), y.begin());
  CountingNumber::counts() = {};
  family.rhs(CountingNumber(0.0), y.data(), slope.data());
  chain = 0;
  for (const auto& s : slope) chain = std::max(chain, s.ready());
  return CountingNumber::counts();
}

TEST(CountingNumbers, CountWhatIsWritten) {
  int chain = 0;
  // s (y - x); x (r - z) - y; x y - b z
  const auto lorenz = count_rhs(Lorenz63<double>{}, chain);
  EXPECT_EQ(lorenz.add, 4);
  EXPECT_EQ(lorenz.multiply, 4);
  EXPECT_EQ(lorenz.divide, 0);
  EXPECT_EQ(chain, 2 + 3 + 2);                                 // sub, mul, sub
  const auto spring = count_rhs(Oscillator<double>{}, chain);  // -(k/m) x
  EXPECT_EQ(spring.multiply, 1);
  EXPECT_EQ(spring.divide, 1);
  EXPECT_EQ(chain, 14 + 3);
  const auto orbit = count_rhs(Kepler<double>{}, chain);
  EXPECT_EQ(orbit.root, 1);
  EXPECT_GE(orbit.multiply, 4);
}

}  // namespace
}  // namespace odemark::numbers_test
