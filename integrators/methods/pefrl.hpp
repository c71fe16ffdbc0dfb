#pragma once
#include "integrators/splitting_order.hpp"
#include "integrators/symmetric_weights.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient pefrl_lambda = -0.212341831062605403831890458069L;
}  // namespace detail

inline constexpr Splitting<5> pefrl{
    .id = "pefrl",
    .source =
        "I. P. Omelyan, I. M. Mryglod, R. Folk, Comput. Phys. Commun. 146 (2002) 188-202, "
        "doi:10.1016/S0010-4655(02)00451-4 (position form; digits beyond the 16 printed from the order "
        "conditions)",
    .order = 4,
    .drift = mirrored<5, 5>(
        std::array<Coefficient, 2>{0.178617895844809067059903767081L, -0.0662645826698184962780156217646L}),
    .kick = mirrored<5, 4>(std::array<Coefficient, 1>{(1 - 2 * detail::pefrl_lambda) / 2}),
    .note = "order 1 where the force depends on velocity",
    .advice =
        "molecular dynamics and orbits at order 4 with four forces a step; not for damped or "
        "driven-by-velocity forces",
};
static_assert(orders_hold(pefrl));

}  // namespace odemark
