#pragma once
#include "integrators/fully_implicit_runge_kutta.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient radau_iia5_sqrt6 = 2.44948974278317809819728407470589139L;
}

inline constexpr FullyImplicitRungeKutta<3> radau_iia5{
    .id = "radau_iia5",
    .source = "E. Hairer, G. Wanner, Solving ODEs II (1996), IV.5, table 5.6; IV.8",
    .order = 5,
    .embedded_order = 3,
    .a = {{{(88 - 7 * detail::radau_iia5_sqrt6) / 360, (296 - 169 * detail::radau_iia5_sqrt6) / 1800,
            (-2 + 3 * detail::radau_iia5_sqrt6) / 225},
           {(296 + 169 * detail::radau_iia5_sqrt6) / 1800, (88 + 7 * detail::radau_iia5_sqrt6) / 360,
            (-2 - 3 * detail::radau_iia5_sqrt6) / 225},
           {(16 - detail::radau_iia5_sqrt6) / 36, (16 + detail::radau_iia5_sqrt6) / 36, 1.0L / 9}}},
    .b = {(16 - detail::radau_iia5_sqrt6) / 36, (16 + detail::radau_iia5_sqrt6) / 36, 1.0L / 9},
    .advice = "first choice for stiff problems from 1e-4 to 1e-9; not for cheap explicit work",
};
static_assert(orders_hold(radau_iia5));

}  // namespace odemark
