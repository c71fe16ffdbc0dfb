#pragma once
#include "integrators/splitting_order.hpp"
#include "integrators/symmetric_weights.hpp"

namespace odemark {

inline constexpr Splitting<7> blanes_moan4{
    .id = "blanes_moan4",
    .source =
        "S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313-330, "
        "doi:10.1016/S0377-0427(01)00492-7, table 2 (S6, A the drift; digits beyond the 15 printed from the "
        "order conditions)",
    .order = 4,
    .drift = mirrored<7, 7>(std::array<Coefficient, 3>{0.0792036964311956694336634958883L,
                                                       0.353172906049773988481061311573L,
                                                       -0.0420650803577195353681102983025L}),
    .kick = mirrored<7, 6>(
        std::array<Coefficient, 2>{0.20951510661336202127407264003L, -0.143851773179818008275115057857L}),
    .note = "order 1 where the force depends on velocity",
    .advice =
        "first choice of order 4 for conservative problems: the error constant pays for six forces a step; "
        "for shorter steps only than its narrow gap at omega h = 3.13",
};
static_assert(orders_hold(blanes_moan4));

}  // namespace odemark
