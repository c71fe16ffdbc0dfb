#pragma once
#include "integrators/splitting_order.hpp"
#include "integrators/symmetric_weights.hpp"

namespace odemark {

inline constexpr Splitting<7> blanes_moan_rkn4{
    .id = "blanes_moan_rkn4",
    .source =
        "S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313-330, "
        "doi:10.1016/S0377-0427(01)00492-7, table 3 (SRKN6b; digits beyond the 15 printed from the order "
        "conditions)",
    .order = 4,
    .drift = mirrored<7, 6, 1>(
        std::array<Coefficient, 2>{0.245298957184271162603932426001L, 0.604872665711079974960892697643L}),
    .kick = mirrored<7, 7>(std::array<Coefficient, 3>{0.0829844064174050188383474789423L,
                                                      0.396309801498368077094911528264L,
                                                      -0.0390563049223484351708652907654L}),
    .note = "order 1 where the force depends on velocity",
    .advice =
        "order 4 made for x'' = a(x): smaller errors than blanes_moan4 for the same six forces; only where "
        "kinetic energy is quadratic",
};
static_assert(orders_hold(blanes_moan_rkn4));

}  // namespace odemark
