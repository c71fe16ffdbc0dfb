#pragma once
#include "integrators/variable_order_bdf.hpp"

namespace odemark {

inline constexpr VariableOrderBdf bdf{
    .id = "bdf",
    .source =
        "C. W. Gear, Comm. ACM 14 (1971) 176-179; L. F. Shampine, M. W. Reichelt, SIAM J. Sci. Comput. 18 "
        "(1997) 1-22",
    .advice =
        "stiff problems at 1e-3 to 1e-8, the more so the more equations; not for oscillations without "
        "damping or forces that switch often",
};

}  // namespace odemark
