#pragma once
#include "integrators/variable_order_radau.hpp"

namespace odemark {

inline constexpr VariableOrderRadau radau{
    .id = "radau",
    .source = "E. Hairer, G. Wanner, J. Comput. Appl. Math. 111 (1999) 93-111",
    .order = radau_iia5.order,
    .embedded_order = radau_iia5.embedded_order,
    .advice =
        "first choice for stiff problems at 1e-9 and beyond; as radau_iia5 above; not for cheap explicit "
        "work",
};

}  // namespace odemark
