// Values between the ends of a step: how many powers and stages, and weights from a Hermite form.
#pragma once

#include "integrators/stepper.hpp"

namespace odemark {

inline constexpr std::size_t highest_dense_degree = 7, most_dense_stages = 4;

/// Dense weights of the form of DOP853: the cubic Hermite polynomial through both ends of the step, and
/// beyond it theta^2 (1 - theta)^2 (d_0 + theta (d_1 + (1 - theta) (d_2 + theta d_3))). The first dense stage
/// is the slope at the end.
template <std::size_t Stages>
constexpr auto dense_from_hermite(
    const std::array<Coefficient, Stages>& b,
    const std::array<std::array<Coefficient, Stages + most_dense_stages>, 4>& d) {
  std::array<std::array<Coefficient, highest_dense_degree>, Stages + most_dense_stages> dense{};
  for (std::size_t j = 0; j < Stages + most_dense_stages; ++j) {
    const Coefficient step = j < Stages ? b[j] : 0, start = j == 0, end = j == Stages;
    // theta (step + (1 - theta) (u + theta (v + (1 - theta) inner))), from the inside
    const Coefficient u = start - step, v = 2 * step - start - end;
    // ascending powers of theta
    std::array<Coefficient, highest_dense_degree + 1> p{};
    const auto times_theta = [&p] {
      for (std::size_t k = highest_dense_degree; k > 0; --k) p[k] = p[k - 1];
      p[0] = 0;
    };
    const auto times_rest = [&p] {
      for (std::size_t k = highest_dense_degree; k > 0; --k) p[k] -= p[k - 1];
    };
    p[0] = d[3][j];
    times_theta(), p[0] += d[2][j];
    times_rest(), p[0] += d[1][j];
    times_theta(), p[0] += d[0][j];
    times_rest(), p[0] += v;
    times_theta(), p[0] += u;
    times_rest(), p[0] += step;
    times_theta();
    for (std::size_t k = 0; k < highest_dense_degree; ++k) dense[j][k] = p[k + 1];
  }
  return dense;
}

}  // namespace odemark
