// odeint's rosenbrock4 behind plain pointers: uBLAS up to Boost 1.74 does not compile as C++20.
#pragma once

#include <cstddef>
#include <memory>

namespace odemark::contestant {

/// What the stepper calls. `jacobian` writes df/dy by rows, and df/dt.
struct RosenbrockProblem {
  void* self;
  void (*rhs)(void* self, double t, const double* y, double* dydt);
  void (*jacobian)(void* self, double t, const double* y, double* row_major, double* dfdt);
};

class RosenbrockStepper {
 public:
  /// The tolerances matter for try_step only.
  RosenbrockStepper(std::size_t size, double absolute_tolerance, double relative_tolerance);
  ~RosenbrockStepper();
  RosenbrockStepper(const RosenbrockStepper&) = delete;
  RosenbrockStepper& operator=(const RosenbrockStepper&) = delete;

  void step(const RosenbrockProblem& problem, double t, double h, double* y);
  /// True: y and t moved on. h becomes the next step to try either way.
  bool try_step(const RosenbrockProblem& problem, double& t, double& h, double* y);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace odemark::contestant
