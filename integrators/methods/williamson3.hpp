#pragma once
#include "integrators/low_storage_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

/// In Butcher's form the method that weather codes call Knoth-Wolke 3.
inline constexpr LowStorageRungeKutta<3> williamson3{
    .id = "williamson3",
    .source = "J. H. Williamson, J. Comput. Phys. 35 (1980) 48-56, case 7",
    .advice = "order 3 in two registers, for fields that barely fit into memory",
    .order = 3,
    .carry = {0, -5.0L / 9, -153.0L / 128},
    .gain = {1.0L / 3, 15.0L / 16, 8.0L / 15},
};
static_assert(orders_hold(williamson3.tableau()));

}  // namespace odemark
