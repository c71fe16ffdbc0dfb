#pragma once
#include "integrators/splitting_order.hpp"

namespace odemark {

inline constexpr Splitting<2> position_verlet{
    .id = "position_verlet",
    .source =
        "M. Tuckerman, B. J. Berne, G. J. Martyna, J. Chem. Phys. 97 (1992) 1990-2001 (drift-kick-drift)",
    .order = 2,
    .drift = {1.0L / 2, 1.0L / 2},
    .kick = {1, 0},
    .note = "order 1 where the force depends on velocity",
    .advice =
        "cheapest symmetric step where positions at the half step suit the force; not for damped springs",
};
static_assert(orders_hold(position_verlet));

}  // namespace odemark
