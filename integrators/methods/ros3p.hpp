#pragma once
#include "integrators/rosenbrock.hpp"
#include "integrators/rosenbrock_order.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient ros3p_gamma = 0.788675134594812882254574390250978728L;  // 1/2 + sqrt(3)/6
}

/// Both later stages look at y + h k_1, and the estimate is h (k_1 - k_2) / 3, the only one of order 2 that
/// these stages have: of f it sees the curvature alone.
inline constexpr Rosenbrock<3> ros3p{
    .id = "ros3p",
    .source = "J. Lang, J. Verwer, BIT Numer. Math. 41 (2001) 731-738, ROS3P",
    .advice =
        "nonlinear diffusion at 1e-2 to 1e-4, two evaluations a step; its estimate is 0 where f is linear "
        "with constant coefficients: there steps grow unchecked; not L-stable (R = -0.73 at infinity)",
    .note = "steps over a singularity: with fixed steps it returns as a finite number",
    .order = 3,
    .embedded_order = 2,
    .jumps_over_poles = true,
    .alpha = {{{}, {1}, {1}}},
    .gamma = {{{detail::ros3p_gamma},
               {-1, detail::ros3p_gamma},
               {-detail::ros3p_gamma, 0.5L - 2 * detail::ros3p_gamma, detail::ros3p_gamma}}},
    .b = {2.0L / 3, 0, 1.0L / 3},
    .b_embedded = {1.0L / 3, 1.0L / 3, 1.0L / 3},
};
static_assert(orders_hold(ros3p));

}  // namespace odemark
