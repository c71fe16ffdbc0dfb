#pragma once
#include "integrators/rosenbrock.hpp"
#include "integrators/rosenbrock_order.hpp"

namespace odemark {

inline constexpr Rosenbrock<4> rodas3{
    .id = "rodas3",
    .source =
        "A. Sandu, J. G. Verwer, J. G. Blom, G. R. Carmichael, F. A. Potra, Atmos. Environ. 31 (1997) "
        "3459-3472, RODAS3",
    .advice = "very stiff kinetics at 1e-2 to 1e-3 where robustness counts; rodas4 for more digits",
    .order = 3,
    .embedded_order = 2,
    .alpha = {{{}, {}, {1}, {3.0L / 4, -1.0L / 4, 1.0L / 2}}},
    .gamma = {{{1.0L / 2},
               {1, 1.0L / 2},
               {-1.0L / 4, -1.0L / 4, 1.0L / 2},
               {1.0L / 12, 1.0L / 12, -2.0L / 3, 1.0L / 2}}},
    .b = {5.0L / 6, -1.0L / 6, -1.0L / 6, 1.0L / 2},
    .b_embedded = {3.0L / 4, -1.0L / 4, 1.0L / 2},
};
static_assert(orders_hold(rodas3));

}  // namespace odemark
