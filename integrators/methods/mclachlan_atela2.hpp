#pragma once
#include "integrators/splitting_order.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient half_root_of_two = 0.707106781186547524400844362104849039285L;
}  // namespace detail

inline constexpr Splitting<3> mclachlan_atela2{
    .id = "mclachlan_atela2",
    .source =
        "R. I. McLachlan, P. Atela, Nonlinearity 5 (1992) 541-562, doi:10.1088/0951-7715/5/2/011 (optimal "
        "order 2, kick first)",
    .order = 2,
    .drift = {0, detail::half_root_of_two, 1 - detail::half_root_of_two},
    .kick = {1 - detail::half_root_of_two, detail::half_root_of_two, 0},
    .note = "order 1 where the force depends on velocity",
    .advice =
        "smallest error constant of two kicks a step at order 2; not symmetric, so not where a run must be "
        "walked back",
};
static_assert(orders_hold(mclachlan_atela2));

}  // namespace odemark
