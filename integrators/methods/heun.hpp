#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<2> heun{
    .id = "heun",
    .source = "K. Heun, Z. Math. Phys. 45 (1900) 23-38 (the chapter's improved Euler)",
    .advice =
        "order 2 that keeps monotonicity (it is SSPRK22); grows slowly on undamped oscillations at every "
        "step",
    .order = 2,
    .a = {{{}, {1}}},
    .b = {1.0L / 2, 1.0L / 2},
};
static_assert(orders_hold(heun));

}  // namespace odemark
