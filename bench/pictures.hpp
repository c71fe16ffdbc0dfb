// What a report shows beside rows: trajectories, stability regions, who methods and problems are.
#pragma once

#include "bench/data/pictures.hpp"
#include "bench/data/row.hpp"

namespace odemark {

struct Registry;
struct AnyProblem;

/// Of the problems and methods of these rows, as far as this registry has them. Deterministic.
Pictures make_pictures(const Registry& registry, const std::vector<Row>& rows);

inline constexpr long coarse_steps = 64;

/// One scene: a line as exact as a picture needs, and well-known methods with so many steps.
/// `certified` says that a truth can be asked for.
Scene make_scene(const Registry& registry, const AnyProblem& problem, bool certified,
                 long steps = coarse_steps);

/// Regions of the methods in `wanted` that the registry has, grouped by what they are compared with.
std::vector<RegionGroup> make_regions(const Registry& registry);

/// |R(z)| at a few z along both axes, of every method that has a stability function.
void add_damping(Pictures& pictures, const Registry& registry);

}  // namespace odemark
