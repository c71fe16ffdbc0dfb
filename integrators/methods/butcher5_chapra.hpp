#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<6> butcher5_chapra{
    .id = "butcher5_chapra",
    .source =
        "J. C. Butcher, J. Austral. Math. Soc. 4 (1964) 179-194; with a42 = -1/2, a43 = 1 as textbooks "
        "print it under his name (S. C. Chapra, R. P. Canale, Numerical Methods for Engineers, ch. 25), "
        "proved by its order conditions",
    .advice =
        "the Butcher method of engineering textbooks; not to be confused with butcher5, same nodes and "
        "weights",
    .order = 5,
    .a = {{{},
           {1.0L / 4},
           {1.0L / 8, 1.0L / 8},
           {0, -1.0L / 2, 1},
           {3.0L / 16, 0, 0, 9.0L / 16},
           {-3.0L / 7, 2.0L / 7, 12.0L / 7, -12.0L / 7, 8.0L / 7}}},
    .b = {7.0L / 90, 0, 32.0L / 90, 12.0L / 90, 32.0L / 90, 7.0L / 90},
};
static_assert(orders_hold(butcher5_chapra));

}  // namespace odemark
