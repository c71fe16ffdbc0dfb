#pragma once
#include "integrators/average_vector_field.hpp"

namespace odemark {

inline constexpr AverageVectorField<5> average_vector_field{
    .id = "average_vector_field",
    .source =
        "G. R. W. Quispel, D. I. McLaren, J. Phys. A 41 (2008) 045206, doi:10.1088/1751-8113/41/4/045206 "
        "(five "
        "Gauss points along the chord)",
    .order = 2,
    .nodes = {0.04691007703066800360118656085030352L, 0.2307653449471584544818427896498956L, 0.5L,
              0.7692346550528415455181572103501044L, 0.9530899229693319963988134391496965L},
    .weights = {0.1184634425280945437571320203599587L, 0.2393143352496832340206457574178191L,
                0.2844444444444444444444444444444444L, 0.2393143352496832340206457574178191L,
                0.1184634425280945437571320203599587L},
    .note = "keeps energy exactly where it is a polynomial of degree 10 or less",
    .advice =
        "conservative problems whose energy must not move at all, at long steps; expensive, and where a "
        "bounded energy error will do a symplectic method costs a tenth",
};
static_assert(average_vector_field.energy_degree() == 10);

}  // namespace odemark
