// Radau IIA and Lobatto IIIC with any number of stages, computed in wide arithmetic: nothing is typed in.
#pragma once

#include <vector>

#include "reference/wide_problem.hpp"

namespace odemark {

/// An implicit Runge-Kutta method whose last stage is the end of the step (b_j = a_sj, c_s = 1).
struct StiffStages {
  std::size_t stages = 0;
  std::vector<Wide> c;
  std::vector<Wide> a;  // row by row
};

/// Collocation at the zeros of P_s - P_{s-1} on [0, 1] (E. Hairer, G. Wanner, Solving Ordinary Differential
/// Equations II, 2nd ed. (Springer, 1996), IV.5): order 2s - 1, L-stable.
StiffStages radau_iia(int stages);
/// At the zeros of x (x - 1) P'_{s-1}, with a_i1 = b_1 and the conditions C(s-1) (the same book, IV.5,
/// table 5.12): order 2s - 2, L-stable, and no collocation method.
StiffStages lobatto_iiic(int stages);

/// Legendre polynomials P_0 .. P_degree at x in [-1, 1].
std::vector<Wide> legendre(const Wide& x, int degree);
/// Row k: weights that give the coefficient of P_k(2 x - 1) of the polynomial through values at `nodes` in
/// [0, 1].
std::vector<Wide> legendre_transform(const std::vector<Wide>& nodes);

}  // namespace odemark
