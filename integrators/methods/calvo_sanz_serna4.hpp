#pragma once
#include "integrators/splitting_order.hpp"

namespace odemark {

inline constexpr Splitting<5> calvo_sanz_serna4{
    .id = "calvo_sanz_serna4",
    .source =
        "M. P. Calvo, J. M. Sanz-Serna, SIAM J. Sci. Comput. 14 (1993) 936-952, doi:10.1137/0914057 "
        "(symplectic Nystrom method of five stages, kick first; digits beyond the 9 printed from the order "
        "conditions, by the least change)",
    .order = 4,
    .drift = {0, 0.205177661992719284706789795619L, 0.403021281245451248436904965888L,
              -0.120920876257477463398615852453L, 0.512721933019306930254921090946L},
    .kick = {0.0617588584841193692652394027558L, 0.338978026476693612218524714311L,
             0.614791306866052059904318093341L, -0.140548014622988093593438449659L,
             0.125019822796123052205356239251L},
    .note = "order 1 where the force depends on velocity",
    .advice =
        "order 4 with four new forces a step where the last serves the next; pefrl costs the same and is "
        "symmetric",
};
static_assert(orders_hold(calvo_sanz_serna4));

}  // namespace odemark
