#pragma once
#include "integrators/exponential.hpp"

namespace odemark {

inline constexpr ExponentialEuler exponential_euler{
    .id = "exponential_euler",
    .source = "M. Hochbruck, A. Ostermann, Acta Numerica 19 (2010) 209-286, eq. 2.5",
    .order = 1,
};

}  // namespace odemark
