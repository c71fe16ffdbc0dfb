#pragma once
#include "integrators/fully_implicit_runge_kutta.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient sqrt15 = 3.87298334620741688517926539978239961L;
}

inline constexpr FullyImplicitRungeKutta<3> gauss6{
    .id = "gauss6",
    .source =
        "J. C. Butcher, Math. Comp. 18 (1964) 50-64; E. Hairer, G. Wanner, Solving ODEs II (1996), IV.5, "
        "table 5.2",
    .order = 6,
    .a = {{{5.0L / 36, 2.0L / 9 - detail::sqrt15 / 15, 5.0L / 36 - detail::sqrt15 / 30},
           {5.0L / 36 + detail::sqrt15 / 24, 2.0L / 9, 5.0L / 36 - detail::sqrt15 / 24},
           {5.0L / 36 + detail::sqrt15 / 30, 2.0L / 9 + detail::sqrt15 / 15, 5.0L / 36}}},
    .b = {5.0L / 18, 4.0L / 9, 5.0L / 18},
    .advice = "as gauss4 where six orders pay: smooth orbits at large steps; does not damp stiff springs",
};
static_assert(orders_hold(gauss6));

}  // namespace odemark
