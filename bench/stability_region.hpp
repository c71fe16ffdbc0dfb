// Stability regions in the plane of z = lambda dt, as polygons.
#pragma once

#include <optional>
#include <string>

#include "bench/data/region.hpp"
#include "integrators/linear_stability.hpp"

namespace odemark {

struct RegionWindow {
  double re_min, re_max, im_min, im_max;
};

/// The window that shows the finite part of the boundary with a margin, symmetric about the real axis.
RegionWindow region_window(const Theory& theory);

/// Marching squares on |R(z)| <= 1 (multistep: all roots in the unit circle) over `cells` x `cells` squares,
/// every crossing bisected. Islands and holes smaller than a square are not seen.
StabilityRegion stability_region(const std::string& method, const Theory& theory,
                                 std::optional<RegionWindow> window = std::nullopt, int cells = 160);

}  // namespace odemark
