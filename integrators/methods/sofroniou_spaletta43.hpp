#pragma once
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/order_conditions.hpp"

namespace odemark {

inline constexpr ExplicitRungeKutta<5> sofroniou_spaletta43{
    .id = "sofroniou_spaletta43",
    .source = "M. Sofroniou, G. Spaletta, Math. Comput. Modelling 40 (2004) 1157-1169",
    .advice = "order 4 with error control at medium tolerances; stable controller at the stability limit",
    .order = 4,
    .embedded_order = 3,
    .a = {{{},
           {2.0L / 5},
           {-3.0L / 20, 3.0L / 4},
           {19.0L / 44, -15.0L / 44, 10.0L / 11},
           {11.0L / 72, 25.0L / 72, 25.0L / 72, 11.0L / 72}}},
    .b = {11.0L / 72, 25.0L / 72, 25.0L / 72, 11.0L / 72, 0},
    .b_embedded = {1251515.0L / 8970912, 3710105.0L / 8970912, 2519695.0L / 8970912, 61105.0L / 8970912,
                   119041.0L / 747576},
};
static_assert(orders_hold(sofroniou_spaletta43));
static_assert(sofroniou_spaletta43.first_same_as_last());

}  // namespace odemark
