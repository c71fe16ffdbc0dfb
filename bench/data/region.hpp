// The set of z = lambda dt where a method is stable, as closed polygons: what reports draw. Plain data.
#pragma once

#include <complex>
#include <string>
#include <vector>

namespace odemark {

struct StabilityRegion {
  std::string method, reason;  // no polygons: see `reason`
  /// The window that was looked at. Where the region goes on beyond it, a polygon runs along the window's
  /// edge: fill it, but do not draw that part as a boundary.
  double re_min = 0, re_max = 0, im_min = 0, im_max = 0;
  /// Closed polygons (the first point is not repeated) between which, by the even-odd rule, the method is
  /// stable.
  std::vector<std::vector<std::complex<double>>> boundaries;
  /// Multistep methods: the whole root locus, of which the boundary is a part. Closed, cut where it passes
  /// through infinity.
  std::vector<std::vector<std::complex<double>>> root_locus;
};

}  // namespace odemark
