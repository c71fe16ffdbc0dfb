#include "bench/expected_order.hpp"

#include <array>
#include <cmath>

#include "integrators/jacobian.hpp"
#include "integrators/lowered_order.hpp"

namespace odemark {

namespace {

/// Does the flow shrink volumes where it starts? Then what runs against it grows: see is_weakly_stable().
bool contracts(const AnyProblem& problem) {
  if (!(problem.abilities & Ability::jacobian)) return false;
  const auto& system = problem.system<double>();
  JacobianMatrix<double> j(system.jacobian_shape());
  std::vector<double> scratch;
  evaluate_jacobian(system, problem.t_begin, problem.initial, j, scratch, scratch, scratch);
  double trace = 0, size = 0;
  for (std::size_t i = 0; i < j.shape().size * j.shape().rows(); ++i) size += std::abs(j.data()[i]);
  for (std::size_t i = 0; i < j.shape().size; ++i) trace += j.at(i, i);
  return trace < -1e-12 * size;
}

/// Damping, or anything else that asks how fast the body turns: is another torque felt at another rate?
bool torque_depends_on_rate(const AnyProblem& problem) {
  if (!(problem.abilities & Ability::rotation)) return false;
  const auto& system = problem.system<double>();
  std::vector<double> faster = problem.initial;
  for (std::size_t i = 0; i < 3; ++i) faster[system.place.rate + i] += 1;
  std::array<double, 3> before{}, after{};
  system.torque(problem.t_begin, problem.initial, before.data());
  system.torque(problem.t_begin, faster, after.data());
  return before != after;
}

}  // namespace

ExpectedOrder expected_order(const AnyMethod& method, const AnyProblem& problem) {
  const Theory theory = method.theory ? method.theory() : Theory{};
  const bool sees_velocity = (problem.abilities & Ability::second_order) &&
                             !(problem.abilities & Ability::separable) &&
                             (method.needs & Ability::second_order);
  if (sees_velocity)
    if (const int order = order_with_damping(theory, method.order); order < method.order)
      return {order, "the force depends on velocity"};
  if (method.order_with_rate_torque > 0 && torque_depends_on_rate(problem))
    return {method.order_with_rate_torque, "the torque depends on the rate"};
  if (contracts(problem) && is_weakly_stable(theory))
    return {0, "a second root on the unit circle grows where the flow contracts"};
  return {method.order};
}

}  // namespace odemark
