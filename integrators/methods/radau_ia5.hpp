#pragma once
#include "integrators/fully_implicit_runge_kutta.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient radau_sqrt6 = 2.44948974278317809819728407470589139L;
}

inline constexpr FullyImplicitRungeKutta<3> radau_ia5{
    .id = "radau_ia5",
    .source =
        "B. L. Ehle, SIAM J. Math. Anal. 4 (1973) 671-680; E. Hairer, G. Wanner, Solving ODEs II (1996), "
        "IV.5, table 5.4",
    .order = 5,
    .jumps_over_poles = true,
    .a = {{{1.0L / 9, (-1 - detail::radau_sqrt6) / 18, (-1 + detail::radau_sqrt6) / 18},
           {1.0L / 9, (88 + 7 * detail::radau_sqrt6) / 360, (88 - 43 * detail::radau_sqrt6) / 360},
           {1.0L / 9, (88 + 43 * detail::radau_sqrt6) / 360, (88 - 7 * detail::radau_sqrt6) / 360}}},
    .b = {1.0L / 9, (16 + detail::radau_sqrt6) / 36, (16 - detail::radau_sqrt6) / 36},
    .note = "steps over a singularity: with fixed steps it returns as a finite number",
    .advice = "L-stable of order 5; radau_iia5 is better where f is stiff, being stiffly accurate",
};
static_assert(orders_hold(radau_ia5));

}  // namespace odemark
