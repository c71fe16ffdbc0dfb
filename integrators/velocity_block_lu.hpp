// I - diagonal da/dv, factored: how a step solves for velocities that are felt by their own force.
#pragma once

#include "integrators/second_order_jacobian.hpp"
#include "integrators/shifted_lu.hpp"

namespace odemark {

template <SecondOrderSystem P>
class VelocityBlockLu {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  VelocityBlockLu(const P& system, const State& model)
      : jacobian_(system, model), block_(jacobian_.block_shape()), lu_(block_.shape()) {}

  void factorize(Real t, const State& y, Real diagonal) {
    jacobian_.evaluate(t, y);
    const auto block = block_.view();
    for (std::size_t r = 0; r < block.size; ++r)
      jacobian_.for_each_near(r, [&](std::size_t c) { block(r, c) = jacobian_.by_velocity(r, c); });
    lu_.factorize_step(block_, diagonal);
  }
  /// `v` has half the size of a state.
  void solve_in_place(Real* v) { lu_.solve_in_place(v); }

 private:
  SecondOrderJacobian<P> jacobian_;
  JacobianMatrix<Real> block_;
  ShiftedLu<Real> lu_;
};

}  // namespace odemark
