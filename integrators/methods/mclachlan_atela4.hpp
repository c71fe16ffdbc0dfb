#pragma once
#include "integrators/splitting_order.hpp"

namespace odemark {

inline constexpr Splitting<5> mclachlan_atela4{
    .id = "mclachlan_atela4",
    .source =
        "R. I. McLachlan, P. Atela, Nonlinearity 5 (1992) 541-562, doi:10.1088/0951-7715/5/2/011 (optimal "
        "order 4 for quadratic kinetic energy, kick first; digits beyond the 19 printed from the order "
        "conditions)",
    .order = 4,
    .drift = {0, 0.515352837431122936400175058625L, -0.0857820194129736460700034069602L,
              0.441583023616466524253061282182L, 0.128846158365384185416767066153L},
    .kick = {0.134496199277431089205506460459L, -0.224819803079420805817180948947L,
             0.756320000515668291112497544841L, 0.334003603286321425499176943648L, 0},
    .note = "order 1 where the force depends on velocity",
    .advice =
        "accurate order 4 for four forces a step; only order 3 where kinetic energy is not quadratic; not "
        "symmetric",
};
static_assert(orders_hold(mclachlan_atela4));

}  // namespace odemark
