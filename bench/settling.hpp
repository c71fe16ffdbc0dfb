// The settling test: does step-size control come to rest on the boundary of stability?
#pragma once

#include <vector>

#include "bench/data/settling.hpp"
#include "integrators/any_method.hpp"

namespace odemark {

/// Every explicit one-step method of ours with an error estimate, under every step-size filter. The solution
/// of the problem is smooth: an error that grows in an unstable step is what holds the step down, and a
/// controller that is stable there lets h |lambda| rest where |R| = 1 (E. Hairer, G. Wanner, Solving ODEs II,
/// IV.2; K. Gustafsson, ACM TOMS 17 (1991) 533-554). The tolerance is loose, for a tight one would hold the
/// step down by accuracy now and then.
std::vector<Settling> measure_settling(const std::vector<AnyMethod>& methods);

}  // namespace odemark
