#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

/// The embedded formula has order 5 for linear problems with constant coefficients only; in general its order
/// is 3, and that is what the estimate is worth.
inline constexpr ExplicitRungeKutta<5> merson43{
    .id = "merson43",
    .source =
        "R. H. Merson, Proc. Symp. Data Processing, Weapons Research Establishment, Salisbury (1957) 110-125",
    .advice = "historical: the estimate misjudges nonlinear problems; take dormand_prince54",
    .order = 4,
    .embedded_order = 3,
    .a = {{{}, {1.0L / 3}, {1.0L / 6, 1.0L / 6}, {1.0L / 8, 0, 3.0L / 8}, {1.0L / 2, 0, -3.0L / 2, 2}}},
    .b = {1.0L / 6, 0, 0, 2.0L / 3, 1.0L / 6},
    .b_embedded = {1.0L / 10, 0, 3.0L / 10, 2.0L / 5, 1.0L / 5},
};
static_assert(orders_hold(merson43));

}  // namespace odemark
