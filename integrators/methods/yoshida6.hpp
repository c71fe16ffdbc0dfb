#pragma once
#include "integrators/splitting_order.hpp"
#include "integrators/symmetric_weights.hpp"

namespace odemark {

namespace detail {
inline constexpr std::array<Coefficient, 3> yoshida6_weights{
    0.784513610477557263819497633866L,
    0.235573213359358133684793182979L,
    -1.17767998417887100694641568096L,
};
}  // namespace detail

inline constexpr Splitting<8> yoshida6{
    .id = "yoshida6",
    .source =
        "H. Yoshida, Phys. Lett. A 150 (1990) 262-268, doi:10.1016/0375-9601(90)90092-3, table 1, solution A "
        "(digits beyond the 15 printed from the order conditions)",
    .order = 6,
    .drift = composed_drifts(detail::yoshida6_weights),
    .kick = composed_kicks(detail::yoshida6_weights),
    .note = "order 1 where the force depends on velocity",
    .advice = "order 6 for 7 forces a step; kahan_li6 and blanes_moan6 err far less for the work",
};
static_assert(orders_hold(yoshida6));

}  // namespace odemark
