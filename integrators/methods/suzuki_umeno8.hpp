#pragma once
#include "integrators/splitting_order.hpp"
#include "integrators/symmetric_weights.hpp"

namespace odemark {

namespace detail {
inline constexpr std::array<Coefficient, 7> suzuki_umeno8_weights{
    0.741670364350612953448227801784L,  -0.409100825800031593997300095894L, 0.19075471029623837995387625645L,
    -0.573862471116082266656387726636L, 0.299064181303655923844463540689L,  0.334624918245298183784957979882L,
    0.315293092396766596632056663811L,
};
}  // namespace detail

inline constexpr Splitting<16> suzuki_umeno8{
    .id = "suzuki_umeno8",
    .source =
        "M. Suzuki, K. Umeno, Computer Simulation Studies in Condensed-Matter Physics VI (Springer, 1993) "
        "74-86; R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151-168, doi:10.1137/0916010 (digits beyond "
        "the 26 of HLW, Geometric Numerical Integration, V.3.2 from the order conditions)",
    .order = 8,
    .drift = composed_drifts(detail::suzuki_umeno8_weights),
    .kick = composed_kicks(detail::suzuki_umeno8_weights),
    .note = "order 1 where the force depends on velocity",
    .advice = "order 8 with the fewest forces a step, 15; kahan_li8 errs less for two more",
};
static_assert(
    suzuki_umeno8.consistent());  // its order takes too long to prove here: order_conditions_test does

}  // namespace odemark
