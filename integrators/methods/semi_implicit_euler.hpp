#pragma once
#include "integrators/splitting_order.hpp"

namespace odemark {

inline constexpr Splitting<2> semi_implicit_euler{
    .id = "semi_implicit_euler",
    .source =
        "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, I.1, eq. 1.9 (new velocity moves "
        "the position)",
    .order = 1,
    .drift = {0, 1},
    .kick = {1, 0},
    .note = "force at the old position and the old velocity",
    .advice =
        "cheapest stable step of games: bounded energy error of order h; not where phases or positions must "
        "be accurate",
};
static_assert(orders_hold(semi_implicit_euler));

}  // namespace odemark
