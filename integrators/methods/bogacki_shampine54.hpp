#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<8> bogacki_shampine54{
    .id = "bogacki_shampine54",
    .source = "P. Bogacki, L. F. Shampine, Comput. Math. Appl. 32 (1996) 15-28",
    .advice =
        "order 5 with a very small error constant and a trustworthy estimate; one more evaluation than "
        "tsitouras54",
    .order = 5,
    .embedded_order = 4,
    .a = {{{},
           {1.0L / 6},
           {2.0L / 27, 4.0L / 27},
           {183.0L / 1372, -162.0L / 343, 1053.0L / 1372},
           {68.0L / 297, -4.0L / 11, 42.0L / 143, 1960.0L / 3861},
           {597.0L / 22528, 81.0L / 352, 63099.0L / 585728, 58653.0L / 366080, 4617.0L / 20480},
           {174197.0L / 959244, -30942.0L / 79937, 8152137.0L / 19744439, 666106.0L / 1039181,
            -29421.0L / 29068, 482048.0L / 414219},
           {587.0L / 8064, 0, 4440339.0L / 15491840, 24353.0L / 124800, 387.0L / 44800, 2152.0L / 5985,
            7267.0L / 94080}}},
    .b = {587.0L / 8064, 0, 4440339.0L / 15491840, 24353.0L / 124800, 387.0L / 44800, 2152.0L / 5985,
          7267.0L / 94080, 0},
    .b_embedded = {2479.0L / 34992, 0, 123.0L / 416, 612941.0L / 3411720, 43.0L / 1440, 2272.0L / 6561,
                   79937.0L / 1113912, 3293.0L / 556956},
};
static_assert(orders_hold(bogacki_shampine54));
static_assert(bogacki_shampine54.first_same_as_last());

}  // namespace odemark
