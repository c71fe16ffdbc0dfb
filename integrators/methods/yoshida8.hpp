#pragma once
#include "integrators/splitting_order.hpp"
#include "integrators/symmetric_weights.hpp"

namespace odemark {

namespace detail {
inline constexpr std::array<Coefficient, 7> yoshida8_weights{
    0.914844246229791566748793489848L, 0.25369333656621135414614602069L, -1.44485223686060515769473065754L,
    -0.15824063536805017520406677676L, 1.93813913762252598657918648744L, -1.9606102329753108076076333764L,
    0.102799849391796440698115131601L,
};
}  // namespace detail

inline constexpr Splitting<16> yoshida8{
    .id = "yoshida8",
    .source =
        "H. Yoshida, Phys. Lett. A 150 (1990) 262-268, doi:10.1016/0375-9601(90)90092-3, table 2, solution D "
        "(what is printed holds to 12 digits; the rest from the order conditions)",
    .order = 8,
    .drift = composed_drifts(detail::yoshida8_weights),
    .kick = composed_kicks(detail::yoshida8_weights),
    .note = "order 1 where the force depends on velocity",
    .advice = "historical: the backward steps are long, suzuki_umeno8 costs the same and errs less",
};
static_assert(yoshida8.consistent());  // its order takes too long to prove here: order_conditions_test does

}  // namespace odemark
