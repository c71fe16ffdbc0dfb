#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

/// The estimate 41/840 h (k1 + k11 - k12 - k13) is zero for y' = f(t): quadratures are not controlled.
inline constexpr ExplicitRungeKutta<13> fehlberg78{
    .id = "fehlberg78",
    .source = "E. Fehlberg, NASA TR R-287 (1968), Table X, order 7 propagated",
    .advice = "as Fehlberg meant it; blind where the right-hand side depends on t alone",
    .order = 7,
    .embedded_order = 8,
    .propagates_lower = true,
    .a = {{{},
           {2.0L / 27},
           {1.0L / 36, 1.0L / 12},
           {1.0L / 24, 0, 1.0L / 8},
           {5.0L / 12, 0, -25.0L / 16, 25.0L / 16},
           {1.0L / 20, 0, 0, 1.0L / 4, 1.0L / 5},
           {-25.0L / 108, 0, 0, 125.0L / 108, -65.0L / 27, 125.0L / 54},
           {31.0L / 300, 0, 0, 0, 61.0L / 225, -2.0L / 9, 13.0L / 900},
           {2, 0, 0, -53.0L / 6, 704.0L / 45, -107.0L / 9, 67.0L / 90, 3},
           {-91.0L / 108, 0, 0, 23.0L / 108, -976.0L / 135, 311.0L / 54, -19.0L / 60, 17.0L / 6, -1.0L / 12},
           {2383.0L / 4100, 0, 0, -341.0L / 164, 4496.0L / 1025, -301.0L / 82, 2133.0L / 4100, 45.0L / 82,
            45.0L / 164, 18.0L / 41},
           {3.0L / 205, 0, 0, 0, 0, -6.0L / 41, -3.0L / 205, -3.0L / 41, 3.0L / 41, 6.0L / 41, 0},
           {-1777.0L / 4100, 0, 0, -341.0L / 164, 4496.0L / 1025, -289.0L / 82, 2193.0L / 4100, 51.0L / 82,
            33.0L / 164, 12.0L / 41, 0, 1}}},
    .b = {41.0L / 840, 0, 0, 0, 0, 34.0L / 105, 9.0L / 35, 9.0L / 35, 9.0L / 280, 9.0L / 280, 41.0L / 840, 0,
          0},
    .b_embedded = {0, 0, 0, 0, 0, 34.0L / 105, 9.0L / 35, 9.0L / 35, 9.0L / 280, 9.0L / 280, 0, 41.0L / 840,
                   41.0L / 840},
};
// its order is proved by tests/order_conditions_test.cpp: the trees would cost every unit that includes it
// seconds

}  // namespace odemark
