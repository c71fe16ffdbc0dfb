#pragma once
#include "integrators/splitting_order.hpp"

namespace odemark {

namespace detail {
inline constexpr std::array<Coefficient, 3> mclachlan_atela3_weights{
    0.919661523017399857050897638153L,
    -0.187991618799159782007852868079L,
    0.268330095781759924956955229925L,
};
}  // namespace detail

inline constexpr Splitting<4> mclachlan_atela3{
    .id = "mclachlan_atela3",
    .source =
        "R. I. McLachlan, P. Atela, Nonlinearity 5 (1992) 541-562, doi:10.1088/0951-7715/5/2/011 (optimal "
        "order 3, kick first; digits beyond the 19 printed from the order conditions)",
    .order = 3,
    .drift = {0, detail::mclachlan_atela3_weights[0], detail::mclachlan_atela3_weights[1],
              detail::mclachlan_atela3_weights[2]},
    .kick = {detail::mclachlan_atela3_weights[2], detail::mclachlan_atela3_weights[1],
             detail::mclachlan_atela3_weights[0], 0},
    .note = "order 1 where the force depends on velocity",
    .advice =
        "best of three kicks at moderate accuracy over long times; order 4 costs one kick more and is mostly "
        "worth it",
};
static_assert(orders_hold(mclachlan_atela3));

}  // namespace odemark
