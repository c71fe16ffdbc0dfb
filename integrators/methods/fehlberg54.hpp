#pragma once
#include "integrators/methods/fehlberg45.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<6> fehlberg54{
    .id = "fehlberg54",
    .source = "E. Fehlberg, NASA TR R-315 (1969), Table III, order 5 propagated",
    .advice = "the classic ode45; dormand_prince54 has the smaller error",
    .order = 5,
    .embedded_order = 4,
    .a = fehlberg45.a,
    .b = fehlberg45.b_embedded,
    .b_embedded = fehlberg45.b,
};
static_assert(orders_hold(fehlberg54));

}  // namespace odemark
