#pragma once
#include "integrators/low_storage_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr LowStorageRungeKutta<5> carpenter_kennedy4{
    .id = "carpenter_kennedy4",
    .source = "M. H. Carpenter, C. A. Kennedy, NASA TM-109112 (1994), RK4(3)5[2N] solution 3",
    .advice = "order 4 in two registers with a longer imaginary interval than rk4: wave propagation",
    .order = 4,
    .carry = {0, -567301805773.0L / 1357537059087, -2404267990393.0L / 2016746695238,
              -3550918686646.0L / 2091501179385, -1275806237668.0L / 842570457699},
    .gain = {1432997174477.0L / 9575080441755, 5161836677717.0L / 13612068292357,
             1720146321549.0L / 2090206949498, 3134564353537.0L / 4481467310338,
             2277821191437.0L / 14882151754819},
};
static_assert(orders_hold(carpenter_kennedy4.tableau()));

}  // namespace odemark
