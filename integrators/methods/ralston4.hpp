#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient sqrt5 = 2.236067977499789696409173668731276235L;
}  // namespace detail

inline constexpr ExplicitRungeKutta<4> ralston4{
    .id = "ralston4",
    .source = "A. Ralston, Math. Comp. 16 (1962) 431-437",
    .advice = "order 4 with a smaller error bound than rk4 at the same cost",
    .order = 4,
    .a = {{{},
           {2.0L / 5},
           {(-2889 + 1428 * detail::sqrt5) / 1024, (3785 - 1620 * detail::sqrt5) / 1024},
           {(-3365 + 2094 * detail::sqrt5) / 6040, (-975 - 3046 * detail::sqrt5) / 2552,
            (467040 + 203968 * detail::sqrt5) / 240845}}},
    .b = {(263 + 24 * detail::sqrt5) / 1812, (125 - 1000 * detail::sqrt5) / 3828,
          1024 * (3346 + 1623 * detail::sqrt5) / 5924787, (30 - 4 * detail::sqrt5) / 123},
};
static_assert(orders_hold(ralston4));

}  // namespace odemark
