// The one unit that sees uBLAS. Compiled as C++17 and with NDEBUG, without which uBLAS checks every solve
// again.
#include "reference/contestants/odeint_rosenbrock_stepper.hpp"

#ifndef NDEBUG
#error "uBLAS without NDEBUG costs odeint's rosenbrock4 a factor of 14 and more"
#endif

#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_controller.hpp>

namespace odemark::contestant {
namespace {

using Stepper = boost::numeric::odeint::rosenbrock4<double>;
using Vector = Stepper::state_type;
using Matrix = Stepper::matrix_type;

auto callbacks(const RosenbrockProblem& problem) {
  return std::make_pair(
      [&problem](const Vector& y, Vector& dydt, double t) { problem.rhs(problem.self, t, &y[0], &dydt[0]); },
      [&problem](const Vector& y, Matrix& j, double t, Vector& dfdt) {
        problem.jacobian(problem.self, t, &y[0], &j.data()[0], &dfdt[0]);
      });
}

}  // namespace

struct RosenbrockStepper::Parts {
  Vector y;
  Stepper plain;
  boost::numeric::odeint::rosenbrock4_controller<Stepper> controlled;
};

RosenbrockStepper::RosenbrockStepper(std::size_t size, double absolute_tolerance, double relative_tolerance)
    : parts_(new Parts{Vector(size), {}, {absolute_tolerance, relative_tolerance}}) {}

RosenbrockStepper::~RosenbrockStepper() = default;

void RosenbrockStepper::step(const RosenbrockProblem& problem, double t, double h, double* y) {
  auto& parts = *parts_;
  std::copy(y, y + parts.y.size(), parts.y.begin());
  auto calls = callbacks(problem);
  parts.plain.do_step(std::ref(calls), parts.y, t, h);
  std::copy(parts.y.begin(), parts.y.end(), y);
}

bool RosenbrockStepper::try_step(const RosenbrockProblem& problem, double& t, double& h, double* y) {
  auto& parts = *parts_;
  std::copy(y, y + parts.y.size(), parts.y.begin());
  auto calls = callbacks(problem);
  const auto result = parts.controlled.try_step(std::ref(calls), parts.y, t, h);
  std::copy(parts.y.begin(), parts.y.end(), y);
  return result == boost::numeric::odeint::success;
}

}  // namespace odemark::contestant
