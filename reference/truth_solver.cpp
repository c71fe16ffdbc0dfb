#include "reference/truth_solver.hpp"

#include <algorithm>
#include <cmath>

namespace odemark {

long double log2_size(const Wide& x) {
  if (x == 0) return -1e9L;
  int exponent = 0;
  const Wide mantissa = frexp(x, &exponent);
  return static_cast<long double>(exponent) + std::log2(std::abs(static_cast<long double>(mantissa)));
}

Wide error_unit(const Wide& y, double floor, double scale) {
  const double lowest = floor * (scale > 0 && std::isfinite(scale) ? scale : 1);
  const Wide size = abs(y);
  return size > lowest ? size : Wide(lowest);
}

Wide power_of_two(long double x) {
  const long double whole = std::floor(x);
  return ldexp(Wide(std::exp2(x - whole)), static_cast<int>(whole));
}

Wide first_step(const WideSystem& system, const Wide& t, const std::vector<Wide>& y, const Wide& stop,
                const RunTolerance& tolerance) {
  std::vector<Wide> slope(y.size());
  system.rhs(t, y.data(), slope.data());
  Wide fastest = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const Wide rate = abs(slope[i]) / error_unit(y[i], 1, tolerance.scale[i]);
    if (!(rate <= fastest)) fastest = rate;
  }
  const Wide whole = stop - t;
  if (!isfinite(fastest)) throw RunFailed("the right-hand side is not finite at the start");
  return fastest * whole > 1 ? Wide(Wide(0.01) / fastest) : Wide(whole * Wide(0.01));
}

}  // namespace odemark
