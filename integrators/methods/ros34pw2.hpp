#pragma once
#include "integrators/rosenbrock.hpp"
#include "integrators/rosenbrock_order.hpp"

namespace odemark {

inline constexpr Rosenbrock<4> ros34pw2{
    .id = "ros34pw2",
    .source =
        "J. Rang, L. Angermann, BIT Numer. Math. 45 (2005) 761-787, ROS34PW2; gamma is the root 0.4358... of "
        "x^3 - 3 x^2 + "
        "3/2 x - 1/6, digits completed by the conditions of order",
    .advice = "order 3 with an old or approximate Jacobian; with an exact one rodas4 is more accurate",
    .note = "steps over a singularity: with fixed steps it returns as a finite number",
    .order = 3,
    .embedded_order = 2,
    .jumps_over_poles = true,
    .w_method = true,
    .alpha = {{{},
               {0.87173304301691799883203890L},
               {0.84457060015369424253068337L, -0.11299064236484184666711995L},
               {0, 0, 1}}},
    .gamma = {{{0.43586652150845899941601945L},
               {-0.87173304301691799883203890L, 0.43586652150845899941601945L},
               {-0.90338057013044076587884584L, 0.054180672388095323318957484L,
                0.43586652150845899941601945L},
               {0.24212380706095347473732623L, -1.2232505839045146159942621L, 0.54526025533510214184091647L,
                0.43586652150845899941601945L}}},
    .b = {0.24212380706095347473732623L, -1.2232505839045146159942621L, 1.5452602553351021418409165L,
          0.43586652150845899941601945L},
    .b_embedded = {0.37810903145819367243084348L, -0.096042292212423172138853201L, 1.0L / 2,
                   0.21793326075422949970800973L},
};
static_assert(orders_hold(ros34pw2));

}  // namespace odemark
