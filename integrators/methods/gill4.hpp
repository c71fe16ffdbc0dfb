#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient sqrt2 = 1.414213562373095048801688724209698079L;
}  // namespace detail

inline constexpr ExplicitRungeKutta<4> gill4{
    .id = "gill4",
    .source = "S. Gill, Proc. Cambridge Philos. Soc. 47 (1951) 96-108",
    .advice = "the rk4 of old libraries, made to save storage; rk4 does the same",
    .order = 4,
    .a = {{{},
           {1.0L / 2},
           {(detail::sqrt2 - 1) / 2, (2 - detail::sqrt2) / 2},
           {0, -detail::sqrt2 / 2, 1 + detail::sqrt2 / 2}}},
    .b = {1.0L / 6, (2 - detail::sqrt2) / 6, (2 + detail::sqrt2) / 6, 1.0L / 6},
};
static_assert(orders_hold(gill4));

}  // namespace odemark
