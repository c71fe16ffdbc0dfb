#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient sqrt21 = 4.582575694955840006588047193728008489L;
}  // namespace detail

inline constexpr ExplicitRungeKutta<7> luther6{
    .id = "luther6",
    .source = "H. A. Luther, Math. Comp. 22 (1968) 434-436",
    .advice = "order 6 on Lobatto nodes in seven evaluations, fixed steps",
    .order = 6,
    .a = {{{},
           {1},
           {3.0L / 8, 1.0L / 8},
           {8.0L / 27, 2.0L / 27, 8.0L / 27},
           {(-21 + 9 * detail::sqrt21) / 392, (-56 + 8 * detail::sqrt21) / 392,
            (336 - 48 * detail::sqrt21) / 392, (-63 + 3 * detail::sqrt21) / 392},
           {(-1155 - 255 * detail::sqrt21) / 1960, (-280 - 40 * detail::sqrt21) / 1960,
            -320 * detail::sqrt21 / 1960, (63 + 363 * detail::sqrt21) / 1960,
            (2352 + 392 * detail::sqrt21) / 1960},
           {(330 + 105 * detail::sqrt21) / 180, 120.0L / 180, (-200 + 280 * detail::sqrt21) / 180,
            (126 - 189 * detail::sqrt21) / 180, (-686 - 126 * detail::sqrt21) / 180,
            (490 - 70 * detail::sqrt21) / 180}}},
    .b = {9.0L / 180, 0, 64.0L / 180, 0, 49.0L / 180, 49.0L / 180, 9.0L / 180},
};
static_assert(orders_hold(luther6));

}  // namespace odemark
