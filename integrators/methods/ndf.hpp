#pragma once
#include "integrators/variable_order_bdf.hpp"

namespace odemark {

inline constexpr VariableOrderBdf ndf{
    .id = "ndf",
    .source =
        "R. W. Klopfenstein, RCA Review 32 (1971) 447-462; L. F. Shampine, M. W. Reichelt, SIAM J. Sci. "
        "Comput. 18 (1997) 1-22, table 1",
    .advice =
        "as bdf, with a quarter fewer steps at low order and a slightly smaller angle of stability; not for "
        "weakly damped oscillations",
    .kappa = {0, -0.1850L, -1.0L / 9, -0.0823L, -0.0415L, 0},
};

}  // namespace odemark
