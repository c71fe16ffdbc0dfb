#pragma once
#include "integrators/nystrom.hpp"
#include "integrators/nystrom_order.hpp"

namespace odemark {

inline constexpr Nystrom<9> rkn_dormand_prince86{
    .id = "rkn_dormand_prince86",
    .source =
        "J. R. Dormand, M. E. A. El-Mikkawy, P. J. Prince, IMA J. Numer. Anal. 7 (1987) 423-430, "
        "doi:10.1093/imanum/7.4.423 (RKN8(6)9FM)",
    .order = 8,
    .embedded_order = 6,
    .c = {0, 1.0L / 20, 1.0L / 10, 3.0L / 10, 1.0L / 2, 7.0L / 10, 9.0L / 10, 1, 1},
    .a = {{{},
           {1.0L / 800},
           {1.0L / 600, 1.0L / 300},
           {9.0L / 200, -9.0L / 100, 9.0L / 100},
           {-66701.0L / 197352, 28325.0L / 32892, -2665.0L / 5482, 2170.0L / 24669},
           {227015747.0L / 304251000, -54897451.0L / 30425100, 12942349.0L / 10141700, -9499.0L / 304251,
            539.0L / 9250},
           {-1131891597.0L / 901789000, 41964921.0L / 12882700, -6663147.0L / 3220675, 270954.0L / 644135,
            -108.0L / 5875, 114.0L / 1645},
           {13836959.0L / 3667458, -17731450.0L / 1833729, 1063919505.0L / 156478208, -33213845.0L / 39119552,
            13335.0L / 28544, -705.0L / 14272, 1645.0L / 57088},
           {223.0L / 7938, 0, 1175.0L / 8064, 925.0L / 6048, 41.0L / 448, 925.0L / 14112, 1175.0L / 72576}}},
    .b_position = {223.0L / 7938, 0, 1175.0L / 8064, 925.0L / 6048, 41.0L / 448, 925.0L / 14112,
                   1175.0L / 72576, 0, 0},
    .b_velocity = {223.0L / 7938, 0, 5875.0L / 36288, 4625.0L / 21168, 41.0L / 224, 4625.0L / 21168,
                   5875.0L / 36288, 223.0L / 7938, 0},
    .b_position_embedded = {7987313.0L / 109941300, 0, 1610737.0L / 44674560, 10023263.0L / 33505920,
                            -497221.0L / 12409600, 10023263.0L / 78180480, 1610737.0L / 402071040, 0, 0},
    .b_velocity_embedded = {7987313.0L / 109941300, 0, 1610737.0L / 40207104, 10023263.0L / 23454144,
                            -497221.0L / 6204800, 10023263.0L / 23454144, 1610737.0L / 40207104,
                            -4251941.0L / 54970650, 3.0L / 20},
    .advice =
        "orbits and other smooth forces without velocity at 1e-8 to 1e-13 with error control; not for kinks "
        "or damped springs",
};
// its orders take clang too long to prove here: order_conditions_test does

}  // namespace odemark
