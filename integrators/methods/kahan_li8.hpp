#pragma once
#include "integrators/splitting_order.hpp"
#include "integrators/symmetric_weights.hpp"

namespace odemark {

namespace detail {
inline constexpr std::array<Coefficient, 8> kahan_li8_weights{
    0.130202483088890080878817632097L, 0.5611629817751083845619644077L,    -0.389474962644847286408078598235L,
    0.158841906555155600896210745707L, -0.395903894133237577336231539348L, 0.184539640978315707091832541533L,
    0.258374387686322047293979109995L, 0.295011723609310298870966240218L,
};
}  // namespace detail

inline constexpr Splitting<18> kahan_li8{
    .id = "kahan_li8",
    .source =
        "W. Kahan, R.-C. Li, Math. Comp. 66 (1997) 1089-1099, doi:10.1090/S0025-5718-97-00873-9 (s17odr8a; "
        "digits beyond the 26 of HLW, Geometric Numerical Integration, V.3.2 from the order conditions)",
    .order = 8,
    .drift = composed_drifts(detail::kahan_li8_weights),
    .kick = composed_kicks(detail::kahan_li8_weights),
    .note = "order 1 where the force depends on velocity",
    .advice =
        "celestial mechanics near round-off over long times; not below 1e-8, where lower orders cost less",
};
static_assert(kahan_li8.consistent());  // its order takes too long to prove here: order_conditions_test does

}  // namespace odemark
