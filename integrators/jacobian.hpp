// df/dy at (t, y): the problem's own, or forward differences where it has none.
#pragma once

#include <cmath>
#include <limits>

#include "integrators/system.hpp"

namespace odemark {

/// `base`, `shifted` and `moved` are scratch of the caller, so that a step allocates nothing.
template <System P>
void evaluate_jacobian(const P& system, RealOf<typename P::State> t, const typename P::State& y,
                       MatrixView<RealOf<typename P::State>> out, typename P::State& base,
                       typename P::State& shifted, typename P::State& moved) {
  using Real = RealOf<typename P::State>;
  if constexpr (HasJacobian<P>) {
    system.jacobian(t, y, out);
  } else {
    system.rhs(t, y, base);
    moved = y;
    for (std::size_t j = 0; j < out.size; ++j) {
      const Real size = std::abs(y.data()[j]);
      const Real wished = std::sqrt(std::numeric_limits<Real>::epsilon()) * (size > 1 ? size : Real(1));
      moved.data()[j] = y.data()[j] + wished;
      const Real step = moved.data()[j] - y.data()[j];  // the step that was representable
      system.rhs(t, moved, shifted);
      for (std::size_t i = 0; i < out.size; ++i) out(i, j) = (shifted.data()[i] - base.data()[i]) / step;
      moved.data()[j] = y.data()[j];
    }
  }
}

}  // namespace odemark
