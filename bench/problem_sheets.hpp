// The sheets of families: parameters, truths, spectra along the solution, a picture.
#pragma once

#include <functional>

#include "bench/data/problem_sheet.hpp"
#include "bench/registry.hpp"

namespace odemark {

/// "(0, inf)", "[0, 1)", "any".
std::string range_text(const Range& range);

/// One family. Truths that are not stored are computed, which takes its time. `with_scene` draws.
ProblemSheet problem_sheet(const Registry& registry, const AnyFamily& family, bool with_scene);

/// Of these families; methods that draw are taken from the registry. `progress` is told after each.
std::vector<ProblemSheet> problem_sheets(
    const Registry& registry, const std::vector<AnyFamily>& families,
    const std::function<void(std::size_t done, std::size_t total)>& progress = {});

}  // namespace odemark
