// The two blocks of a second-order problem's Jacobian: how the acceleration answers to position and velocity.
#pragma once

#include <algorithm>
#include <array>

#include "integrators/jacobian.hpp"

namespace odemark {

/// Filled by evaluate(); memory is taken once, at construction.
template <SecondOrderSystem P>
class SecondOrderJacobian {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  SecondOrderJacobian(const P& system, const State& model)
      : system_(system),
        half_(size_of(model) / 2),
        matrix_(jacobian_shape(system, model)),
        scratch_{blank_like(model), blank_like(model), blank_like(model)} {}

  void evaluate(Real t, const State& y) {
    evaluate_jacobian(system_, t, y, matrix_, scratch_[0], scratch_[1], scratch_[2]);
  }
  /// d a_row / d x_column, 1/s^2: minus the stiffness over the mass.
  Real by_position(std::size_t row, std::size_t column) const { return matrix_.at(half_ + row, column); }
  /// d a_row / d v_column, 1/s: minus the damping over the mass.
  Real by_velocity(std::size_t row, std::size_t column) const {
    return matrix_.at(half_ + row, half_ + column);
  }

  MatrixShape block_shape() const { return matrix_.shape().block(); }
  /// f(column) wherever a block of that shape may differ from 0 in this row.
  template <class F>
  void for_each_near(std::size_t row, F&& f) const {
    const MatrixShape block = block_shape();
    const std::size_t first = row > block.lower ? row - block.lower : 0,
                      last = std::min(half_, row + block.upper + 1);
    for (std::size_t column = first; column < last; ++column) f(column);
  }

 private:
  const P& system_;
  std::size_t half_;
  JacobianMatrix<Real> matrix_;
  std::array<State, 3> scratch_;
};

}  // namespace odemark
