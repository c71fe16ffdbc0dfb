#pragma once
#include "integrators/splitting_order.hpp"
#include "integrators/symmetric_weights.hpp"

namespace odemark {

namespace detail {
inline constexpr std::array<Coefficient, 4> kahan_li6_weights{
    0.392161444007314139279250557423L,
    0.3325991367893594385997486375L,
    -0.706246172557639359809964819549L,
    0.0822135962935508002314904481021L,
};
}  // namespace detail

inline constexpr Splitting<10> kahan_li6{
    .id = "kahan_li6",
    .source =
        "W. Kahan, R.-C. Li, Math. Comp. 66 (1997) 1089-1099, doi:10.1090/S0025-5718-97-00873-9 (s9odr6a; "
        "digits beyond the 26 of HLW, Geometric Numerical Integration, V.3.2 from the order conditions)",
    .order = 6,
    .drift = composed_drifts(detail::kahan_li6_weights),
    .kick = composed_kicks(detail::kahan_li6_weights),
    .note = "order 1 where the force depends on velocity",
    .advice = "smooth conservative problems over long times at 1e-6 to 1e-10; not for forces with kinks",
};
static_assert(orders_hold(kahan_li6));

}  // namespace odemark
