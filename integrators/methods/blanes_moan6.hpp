#pragma once
#include "integrators/splitting_order.hpp"
#include "integrators/symmetric_weights.hpp"

namespace odemark {

inline constexpr Splitting<11> blanes_moan6{
    .id = "blanes_moan6",
    .source =
        "S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313-330, "
        "doi:10.1016/S0377-0427(01)00492-7, table 2 (S10, A the drift; the 15 printed digits hold to 14; the "
        "rest from the order conditions)",
    .order = 6,
    .drift = mirrored<11, 11>(
        std::array<Coefficient, 5>{0.0502627644003926860212216544021L, 0.413514300428343815063063720134L,
                                   0.0450798897943980629688970521245L, -0.188054853819568914799128488919L,
                                   0.541960678450780134831414740933L}),
    .kick = mirrored<11, 10>(
        std::array<Coefficient, 4>{0.148816447901043231920901005536L, -0.132385865767783647448845426599L,
                                   0.0673076046921844581502578965926L, 0.432666402578173597527667970884L}),
    .note = "order 1 where the force depends on velocity",
    .advice =
        "first choice of order 6 for conservative problems that split in any two parts; with quadratic "
        "kinetic energy blanes_moan_rkn6 errs less",
};
static_assert(orders_hold(blanes_moan6));

}  // namespace odemark
