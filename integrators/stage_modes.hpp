// The eigenvectors of a Runge-Kutta matrix: they decouple the stages of a fully implicit method.
#pragma once

#include <array>
#include <cstddef>

#include "integrators/plain_complex.hpp"
#include "integrators/stepper.hpp"

namespace odemark {

/// A = sum over modes of value * right left', left' right = 1: real modes first, then one of each complex
/// pair. J. C. Butcher, BIT 16 (1976) 237-240; T. A. Bickart, SIAM J. Numer. Anal. 14 (1977) 1022-1027.
struct StageModes {
  static constexpr std::size_t most = 8;
  using Complex = PlainComplex<Coefficient>;
  using Vector = std::array<Complex, most>;

  std::size_t reals = 0, pairs = 0;
  Vector value{};
  std::array<Vector, most> right{}, left{};
};

/// Of a row-major size x size matrix with distinct eigenvalues. No allocation: it may run before a step.
StageModes stage_modes(std::size_t size, const Coefficient* a);

}  // namespace odemark
