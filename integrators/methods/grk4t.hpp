#pragma once
#include "integrators/rosenbrock.hpp"
#include "integrators/rosenbrock_order.hpp"

namespace odemark {

inline constexpr Rosenbrock<4> grk4t{
    .id = "grk4t",
    .source =
        "P. Kaps, P. Rentrop, Numer. Math. 33 (1979) 55-68, method GRK4T with gamma = 0.231; E. Hairer, G. "
        "Wanner, Solving "
        "ODEs II, table IV.7.2; digits completed by the conditions of order",
    .advice =
        "mildly stiff problems at three evaluations a step; its error is small but it is not L-stable: no "
        "stiff transients",
    .order = 4,
    .embedded_order = 3,
    .alpha = {{{},
               {0.462L},
               {-0.081566816832722961326518881L, 0.96177515016605629465985221L},
               {-0.081566816832722961326518881L, 0.96177515016605629465985221L, 0}}},
    .gamma = {{{0.231L},
               {-0.27062966775244299674267101L, 0.231L},
               {0.31125448329409367370675178L, 0.0085244562848205683083248761L, 0.231L},
               {0.28281683204353066913627821L, -0.45795948328072528081958732L, -0.11120833333333327700685866L,
                0.231L}}},
    .b = {0.21748737165273291868590062L, 0.48622903799011939153156907L, 0, 0.29628359035714768978253031L},
    .b_embedded = {-0.71708850449932645226337326L, 1.7761791217610392143498229L,
                   -0.059090617261712762086449643L, 0},
};
static_assert(orders_hold(grk4t));

}  // namespace odemark
