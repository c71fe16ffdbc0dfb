#pragma once
#include "integrators/methods/fehlberg78.hpp"

namespace odemark {

/// The estimate 41/840 h (k1 + k11 - k12 - k13) is zero for y' = f(t): quadratures are not controlled.
inline constexpr ExplicitRungeKutta<13> fehlberg87{
    .id = "fehlberg87",
    .source = "E. Fehlberg, NASA TR R-287 (1968), Table X, order 8 propagated",
    .advice =
        "common in orbit codes; dop853 and verner87 do better, and see a right-hand side that depends on t "
        "alone",
    .order = 8,
    .embedded_order = 7,
    .a = fehlberg78.a,
    .b = fehlberg78.b_embedded,
    .b_embedded = fehlberg78.b,
};
// its order is proved by tests/order_conditions_test.cpp: the trees would cost every unit that includes it
// seconds

}  // namespace odemark
