#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<8> dverk65{
    .id = "dverk65",
    .source =
        "J. H. Verner, SIAM J. Numer. Anal. 15 (1978) 772-790; DVERK of T. E. Hull, W. H. Enright, K. R. "
        "Jackson (1976)",
    .advice = "the order 6 of IMSL and of old codes; verner65 is the better pair today",
    .order = 6,
    .embedded_order = 5,
    .a = {{{},
           {1.0L / 6},
           {4.0L / 75, 16.0L / 75},
           {5.0L / 6, -8.0L / 3, 5.0L / 2},
           {-165.0L / 64, 55.0L / 6, -425.0L / 64, 85.0L / 96},
           {12.0L / 5, -8, 4015.0L / 612, -11.0L / 36, 88.0L / 255},
           {-8263.0L / 15000, 124.0L / 75, -643.0L / 680, -81.0L / 250, 2484.0L / 10625},
           {3501.0L / 1720, -300.0L / 43, 297275.0L / 52632, -319.0L / 2322, 24068.0L / 84065, 0,
            3850.0L / 26703}}},
    .b = {3.0L / 40, 0, 875.0L / 2244, 23.0L / 72, 264.0L / 1955, 0, 125.0L / 11592, 43.0L / 616},
    .b_embedded = {13.0L / 160, 0, 2375.0L / 5984, 5.0L / 16, 12.0L / 85, 3.0L / 44, 0, 0},
};
static_assert(orders_hold(dverk65));

}  // namespace odemark
