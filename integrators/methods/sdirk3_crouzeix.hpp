#pragma once
#include "integrators/diagonally_implicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient crouzeix_gamma = 0.788675134594812882254574390250978728L;  // (3 + sqrt 3) / 6
}  // namespace detail

inline constexpr DiagonallyImplicitRungeKutta<2> sdirk3_crouzeix{
    .id = "sdirk3_crouzeix",
    .source =
        "M. Crouzeix, thesis, Paris VI (1975); S. P. Norsett, Report 6/74, Trondheim (1974); E. Hairer, G. "
        "Wanner, Solving ODEs II (1996), IV.6",
    .order = 3,
    .a = {{{detail::crouzeix_gamma}, {1 - 2 * detail::crouzeix_gamma, detail::crouzeix_gamma}}},
    .b = {1.0L / 2, 1.0L / 2},
    .advice =
        "order 3 for two solves, A- and B-stable; not where stiff modes must die at once, |R| = 0.73 at "
        "infinity",
};
static_assert(orders_hold(sdirk3_crouzeix));

}  // namespace odemark
