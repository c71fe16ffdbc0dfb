#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<6> butcher5{
    .id = "butcher5",
    .source =
        "J. C. Butcher, J. Austral. Math. Soc. 4 (1964) 179-194; with a42 = 0, a43 = 1/2 as in Numerical "
        "Methods for ODEs, Wiley 2016, (236a)",
    .advice = "Boole's rule on quadratures; not to be confused with butcher5_chapra, same nodes and weights",
    .order = 5,
    .a = {{{},
           {1.0L / 4},
           {1.0L / 8, 1.0L / 8},
           {0, 0, 1.0L / 2},
           {3.0L / 16, -3.0L / 8, 3.0L / 8, 9.0L / 16},
           {-3.0L / 7, 8.0L / 7, 6.0L / 7, -12.0L / 7, 8.0L / 7}}},
    .b = {7.0L / 90, 0, 32.0L / 90, 12.0L / 90, 32.0L / 90, 7.0L / 90},
};
static_assert(orders_hold(butcher5));

}  // namespace odemark
