#pragma once
#include "integrators/splitting_order.hpp"

namespace odemark {

inline constexpr Splitting<2> stormer_verlet{
    .id = "stormer_verlet",
    .source = "L. Verlet, Phys. Rev. 159 (1967) 98-103 (kick-drift-kick)",
    .order = 2,
    .drift = {0, 1},
    .kick = {1.0L / 2, 1.0L / 2},
    .note = "second kick sees the velocity of the half step: order 1 where the force depends on velocity",
    .advice = "default for conservative mechanics at moderate accuracy; not where force depends on velocity",
};
static_assert(orders_hold(stormer_verlet));

}  // namespace odemark
