// The two blocks of a second-order problem's Jacobian: how the acceleration answers to position and velocity.
#pragma once

#include <array>
#include <vector>

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
        size_(size_of(model)),
        matrix_(size_ * size_, Real(0)),
        scratch_{blank_like(model), blank_like(model), blank_like(model)} {}

  void evaluate(Real t, const State& y) {
    evaluate_jacobian(system_, t, y, MatrixView<Real>{matrix_.data(), size_}, scratch_[0], scratch_[1],
                      scratch_[2]);
  }
  /// d a_row / d x_column, 1/s^2: minus the stiffness over the mass.
  Real by_position(std::size_t row, std::size_t column) const {
    return matrix_[column * size_ + size_ / 2 + row];
  }
  /// d a_row / d v_column, 1/s: minus the damping over the mass.
  Real by_velocity(std::size_t row, std::size_t column) const {
    return matrix_[(size_ / 2 + column) * size_ + size_ / 2 + row];
  }

 private:
  const P& system_;
  std::size_t size_;
  std::vector<Real> matrix_;
  std::array<State, 3> scratch_;
};

}  // namespace odemark
