#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<4> bogacki_shampine32{
    .id = "bogacki_shampine32",
    .source = "P. Bogacki, L. F. Shampine, Appl. Math. Lett. 2 (1989) 321-325",
    .advice = "the pair for crude tolerances (1e-2 to 1e-4) and mildly stiff problems",
    .order = 3,
    .embedded_order = 2,
    .a = {{{}, {1.0L / 2}, {0, 3.0L / 4}, {2.0L / 9, 1.0L / 3, 4.0L / 9}}},
    .b = {2.0L / 9, 1.0L / 3, 4.0L / 9, 0},
    .b_embedded = {7.0L / 24, 1.0L / 4, 1.0L / 3, 1.0L / 8},
};
static_assert(orders_hold(bogacki_shampine32));
static_assert(bogacki_shampine32.first_same_as_last());

}  // namespace odemark
