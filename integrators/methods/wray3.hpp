#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<3> wray3{
    .id = "wray3",
    .source =
        "A. A. Wray, Minimal storage time advancement schemes for spectral methods, NASA Ames Research "
        "Center, report MS 202 (1990); P. R. Spalart, R. D. Moser, M. M. Rogers, J. Comput. Phys. 96 (1991) "
        "297-324",
    .advice = "the order 3 of turbulence codes; williamson3 is its rival in two registers",
    .order = 3,
    .a = {{{}, {8.0L / 15}, {1.0L / 4, 5.0L / 12}}},
    .b = {1.0L / 4, 0, 3.0L / 4},
};
static_assert(orders_hold(wray3));

}  // namespace odemark
