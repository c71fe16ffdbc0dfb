#pragma once
#include "integrators/splitting_order.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient cube_root_of_two = 1.259921049894873164767210607278228350570L;
inline constexpr Coefficient yoshida_outer = 1 / (2 - cube_root_of_two),
                             yoshida_inner = -cube_root_of_two * yoshida_outer;
}  // namespace detail

inline constexpr Splitting<4> yoshida4{
    .id = "yoshida4",
    .source = "H. Yoshida, Phys. Lett. A 150 (1990) 262-268 (triple jump)",
    .order = 4,
    .drift = {detail::yoshida_outer / 2, (detail::yoshida_outer + detail::yoshida_inner) / 2,
              (detail::yoshida_outer + detail::yoshida_inner) / 2, detail::yoshida_outer / 2},
    .kick = {detail::yoshida_outer, detail::yoshida_inner, detail::yoshida_outer, 0},
    .note = "order 1 where the force depends on velocity",
    .advice =
        "historical order 4 with three forces a step and a long step back; pefrl, suzuki4 and blanes_moan4 "
        "err less for the work",
};
static_assert(orders_hold(yoshida4));

}  // namespace odemark
