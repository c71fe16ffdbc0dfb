#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<1> explicit_euler{
    .id = "explicit_euler",
    .source = "L. Euler, Institutionum calculi integralis I (1768), 650-653",
    .advice = "for teaching and for crude steps of dissipative scenes; gains energy on anything that swings",
    .order = 1,
    .a = {{{}}},
    .b = {1},
};
static_assert(orders_hold(explicit_euler));

}  // namespace odemark
