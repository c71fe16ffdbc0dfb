#pragma once
#include "integrators/diagonally_implicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr DiagonallyImplicitRungeKutta<4> esdirk32{
    .id = "esdirk32",
    .source =
        "C. A. Kennedy, M. H. Carpenter, NASA/TM-2016-219173, ESDIRK3(2)4L[2]SA; digits beyond the printed "
        "ones from the order conditions",
    .order = 3,
    .embedded_order = 2,
    .a = {{{},
           {0.435866521508458999416019451193557L, 0.435866521508458999416019451193557L},
           {0.257648246066426951481371146388416L, -0.0935147675748863134856161096787115L,
            0.435866521508458999416019451193557L},
           {0.187641024346723642101154714326449L, -0.595297473576954055541338307719826L,
            0.97178992772177141402416414219982L, 0.435866521508458999416019451193557L}}},
    .b = {0.187641024346723642101154714326449L, -0.595297473576954055541338307719826L,
          0.97178992772177141402416414219982L, 0.435866521508458999416019451193557L},
    .b_embedded = {0.108896617615863084230370151395843L, -0.915325811870712560415345187264413L,
                   1.27127359730215437837695817629992L, 0.535155596952695097808016859568653L},
    .filter_estimate = true,
    .advice = "stiff problems at 1e-2 to 1e-4; kvaerno32 has the more stable estimate",
};
static_assert(orders_hold(esdirk32));

}  // namespace odemark
