#pragma once
#include "integrators/rosenbrock.hpp"
#include "integrators/rosenbrock_order.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient ros2_gamma = 1.70710678118654752440084436210484903928L;  // 1 + 1/sqrt(2)
}

inline constexpr Rosenbrock<2> ros2{
    .id = "ros2",
    .source =
        "J. G. Verwer, E. J. Spee, J. G. Blom, W. Hundsdorfer, SIAM J. Sci. Comput. 20 (1999) 1456-1480, "
        "ROS2 with gamma = "
        "1 + 1/sqrt(2); estimate against the linearly implicit Euler step",
    .advice =
        "positive concentrations and dt far above the fast scales, at a few percent; its error constant is "
        "large",
    .note = "steps over a singularity: with fixed steps it returns as a finite number",
    .order = 2,
    .embedded_order = 1,
    .jumps_over_poles = true,
    .w_method = true,
    .alpha = {{{}, {1}}},
    .gamma = {{{detail::ros2_gamma}, {-2 * detail::ros2_gamma, detail::ros2_gamma}}},
    .b = {1.0L / 2, 1.0L / 2},
    .b_embedded = {1},
};
static_assert(orders_hold(ros2));

}  // namespace odemark
