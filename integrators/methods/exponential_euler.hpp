#pragma once
#include "integrators/exponential.hpp"

namespace odemark {

inline constexpr ExponentialRungeKutta<1> exponential_euler{
    .id = "exponential_euler",
    .source = "M. Hochbruck, A. Ostermann, Acta Numerica 19 (2010) 209-286, eq. 2.5",
    .advice = "a stiff linear part and a slow rest, at a few percent; not where the rest is stiff too",
    .order = 1,

};
static_assert(orders_hold(exponential_euler));

}  // namespace odemark
