// The order that a curve of error against dt shows on its longest straight stretch.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace odemark {

struct CurvePoint {
  double dt = 0, error = 0;
};

struct Stretch {
  double slope = 0;    // of the line of least squares in logarithms
  double decades = 0;  // of the error
  std::size_t points = 0;
};

/// The error of a method of order p has an expansion h^p (e_p + h e_{p+1} + ...) (E. Hairer, S. P. Norsett,
/// G. Wanner, Solving ODEs I, II.8), so that local slopes tend to p; but where e_p is small beside e_{p+1},
/// and over long times some terms grow as t^2 and others as t, they pass through anything between p - 1 and p
/// + 2 on their way, for a decade of steps and more. Such a passage shows in itself: there neighbouring
/// slopes differ. So the stretch is looked for on which all local slopes lie within `scatter` of each other,
/// and of all such that with the most decades of error is taken. Errors beyond `largest` or below `floor` are
/// not used.
inline std::optional<Stretch> straightest(std::vector<CurvePoint> curve, double scatter, double largest,
                                          double floor) {
  std::sort(curve.begin(), curve.end(), [](const CurvePoint& a, const CurvePoint& b) { return a.dt > b.dt; });
  const auto usable = [&](const CurvePoint& p) { return p.error <= largest && p.error >= floor; };
  std::optional<Stretch> best;
  for (std::size_t first = 0; first + 3 < curve.size(); ++first) {
    if (!usable(curve[first])) continue;
    double least = 1e300, most = -1e300;
    std::size_t last = first;
    while (last + 1 < curve.size() && usable(curve[last + 1])) {
      const auto &a = curve[last], &b = curve[last + 1];
      const double slope = std::log(a.error / b.error) / std::log(a.dt / b.dt);
      least = std::min(least, slope), most = std::max(most, slope);
      if (!(most - least <= scatter && least > 0)) break;
      ++last;
    }
    const double decades = std::log10(curve[first].error / curve[last].error);
    if (last < first + 3 || (best && decades < best->decades)) continue;
    const auto count = double(last - first + 1);
    double x_mean = 0, y_mean = 0, xx = 0, xy = 0;
    for (std::size_t i = first; i <= last; ++i)
      x_mean += std::log(curve[i].dt) / count, y_mean += std::log(curve[i].error) / count;
    for (std::size_t i = first; i <= last; ++i) {
      const double x = std::log(curve[i].dt) - x_mean;
      xx += x * x, xy += x * (std::log(curve[i].error) - y_mean);
    }
    best = Stretch{xy / xx, decades, last - first + 1};
  }
  return best;
}

}  // namespace odemark
