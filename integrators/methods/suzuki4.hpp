#pragma once
#include "integrators/splitting_order.hpp"
#include "integrators/symmetric_weights.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient cube_root_of_four = 1.587401051968199474751705639272308260391L;
inline constexpr std::array<Coefficient, 2> suzuki4_weights{1 / (4 - cube_root_of_four),
                                                            1 / (4 - cube_root_of_four)};
}  // namespace detail

inline constexpr Splitting<6> suzuki4{
    .id = "suzuki4",
    .source =
        "M. Suzuki, Phys. Lett. A 146 (1990) 319-323, doi:10.1016/0375-9601(90)90962-N (fractal, five Verlet "
        "steps)",
    .order = 4,
    .drift = composed_drifts(detail::suzuki4_weights),
    .kick = composed_kicks(detail::suzuki4_weights),
    .note = "order 1 where the force depends on velocity",
    .advice =
        "order 4 with short backward steps: stable further and more accurate than yoshida4; blanes_moan4 is "
        "better still",
};
static_assert(orders_hold(suzuki4));

}  // namespace odemark
