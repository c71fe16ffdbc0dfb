#pragma once
#include "integrators/diagonally_implicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr DiagonallyImplicitRungeKutta<2> implicit_trapezoid{
    .id = "implicit_trapezoid",
    .source = "J. Crank, P. Nicolson, Proc. Camb. Phil. Soc. 43 (1947) 50-67",
    .order = 2,
    .a = {{{}, {1.0L / 2, 1.0L / 2}}},
    .b = {1.0L / 2, 1.0L / 2},
    .advice = "mildly stiff problems at two evaluations a solve; stiff springs ring on undamped",
};
static_assert(orders_hold(implicit_trapezoid));

}  // namespace odemark
