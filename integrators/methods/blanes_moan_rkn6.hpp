#pragma once
#include "integrators/splitting_order.hpp"
#include "integrators/symmetric_weights.hpp"

namespace odemark {

inline constexpr Splitting<12> blanes_moan_rkn6{
    .id = "blanes_moan_rkn6",
    .source =
        "S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313-330, "
        "doi:10.1016/S0377-0427(01)00492-7, table 3 (SRKN11b; digits beyond the 15 printed from the order "
        "conditions)",
    .order = 6,
    .drift = mirrored<12, 11, 1>(
        std::array<Coefficient, 5>{0.123229775946271151561086380333L, 0.290553797799558270366414169328L,
                                   -0.127049212625416915662505053827L, -0.246331761062075404194973489104L,
                                   0.357208872795927752619860349619L}),
    .kick = mirrored<12, 12>(
        std::array<Coefficient, 5>{0.0414649985182628432987781339147L, 0.198128671918066541136726473181L,
                                   -0.0400061921041526868888283635359L, 0.075253984301580341127878878527L,
                                   -0.0115113874206877700624432015013L}),
    .note = "order 1 where the force depends on velocity",
    .advice =
        "first choice of order 6 for x'' = a(x) over long times; only order 4 where kinetic energy is not "
        "quadratic",
};
static_assert(orders_hold(blanes_moan_rkn6));

}  // namespace odemark
