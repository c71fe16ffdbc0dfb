// The static tier: runs whose right-hand side is compiled into the step. Same bits as the erased tier, less
// time.
#pragma once

#include <string_view>
#include <vector>

#include "integrators/integrate.hpp"

namespace odemark {

struct StaticRun {
  std::string_view family, method;
  /// `values` is the Family<double> of a problem; y holds the state, in and out.
  RunReport (*solve)(const void* values, const Control&, double t0, double t1, double* y);
};

/// The pairs marked `static` in the catalogues, where the method applies.
const std::vector<StaticRun>& suite_static_runs();

/// The marks themselves, whether the method applies or not.
struct StaticMark {
  std::string_view family, method;
};
const std::vector<StaticMark>& suite_static_marks();

/// Null where the pair is not compiled statically. Contestants are found too, for error control only, where
/// their library lets its user inline: comparing an inlined run of ours with a called one of theirs would be
/// unfair.
const StaticRun* find_static_run(std::string_view family, std::string_view method);

}  // namespace odemark
