#pragma once
#include "integrators/diagonally_implicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr DiagonallyImplicitRungeKutta<4> kvaerno32{
    .id = "kvaerno32",
    .source =
        "A. Kvaerno, BIT 44 (2004) 489-502, method 3/2; digits beyond the printed ones from the order "
        "conditions",
    .order = 3,
    .embedded_order = 2,
    .a = {{{},
           {0.435866521508458999416019451193557L, 0.435866521508458999416019451193557L},
           {0.490563388421780570628467958466545L, 0.0735700900697604299555125903398985L,
            0.435866521508458999416019451193557L},
           {0.308809969976746523348162469886701L, 1.49056338842178057062846795846654L,
            -1.2352398799069860933926498795468L, 0.435866521508458999416019451193557L}}},
    .b = {0.308809969976746523348162469886701L, 1.49056338842178057062846795846654L,
          -1.2352398799069860933926498795468L, 0.435866521508458999416019451193557L},
    .b_embedded = {0.490563388421780570628467958466545L, 0.0735700900697604299555125903398985L,
                   0.435866521508458999416019451193557L, 0},
    .advice = "stiff problems at 1e-2 to 1e-4, L-stable, one factorization a step; radau_iia5 below",
};
static_assert(orders_hold(kvaerno32));

}  // namespace odemark
