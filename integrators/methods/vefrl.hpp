#pragma once
#include "integrators/splitting_order.hpp"
#include "integrators/symmetric_weights.hpp"

namespace odemark {

namespace detail {
inline constexpr Coefficient vefrl_lambda = -0.0209433391039898810671612763466L;
}  // namespace detail

inline constexpr Splitting<5> vefrl{
    .id = "vefrl",
    .source =
        "I. P. Omelyan, I. M. Mryglod, R. Folk, Comput. Phys. Commun. 146 (2002) 188-202, "
        "doi:10.1016/S0010-4655(02)00451-4 (velocity form; digits beyond the 16 printed from the order "
        "conditions)",
    .order = 4,
    .drift = mirrored<5, 4, 1>(std::array<Coefficient, 1>{(1 - 2 * detail::vefrl_lambda) / 2}),
    .kick = mirrored<5, 5>(
        std::array<Coefficient, 2>{0.1644986515575759720216332118L, 1.2356926511389169997626454809L}),
    .note = "order 1 where the force depends on velocity",
    .advice =
        "as pefrl with positions known where the force is; its long kicks stay accurate only at small steps",
};
static_assert(orders_hold(vefrl));

}  // namespace odemark
