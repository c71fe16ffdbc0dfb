#include "integrators/erased_stepper.hpp"

#include "integrators/grid_sampler.hpp"

namespace odemark {

namespace {

template <class T, class Observer>
RunReport run(ErasedStepper<T>& stepper, const ErasedSystem<T>& system, const Control& control,
              int error_order, double t0, double t1, std::vector<T>& y, Observer& observe) {
  if (const auto* fixed = std::get_if<FixedSteps>(&control))
    return integrate(stepper, *fixed, t0, t1, y, observe);
  if (error_order > 0)
    return integrate(stepper, system, std::get<ErrorControl>(control), error_order, t0, t1, y, observe);
  return no_error_estimate(t0);
}

/// Where the unit vectors go in one step of h on a linear homogeneous system of `n` components.
template <class T>
TransitionMatrix<T> transition_of(ErasedStepper<T> stepper, std::size_t n, T h) {
  std::vector<T> y(n, T(0)), next(n, T(0)), error(n, T(0));
  TransitionMatrix<T> matrix;
  const std::size_t past = stepper.history_length();
  matrix.size = n * (1 + past);
  for (std::size_t j = 0; j < matrix.size; ++j) {
    std::fill(y.begin(), y.end(), T(0));
    std::fill(error.begin(), error.end(), T(0));
    if (j < n) y[j] = T(1);
    stepper.start();
    stepper.assume_history();
    for (std::size_t k = 0; k < past; ++k)
      for (std::size_t i = 0; i < n; ++i) stepper.history(k)[i] = T(j == n * (1 + k) + i);
    if (stepper.attempt(T(0), y, h, next, error) != StepStatus::ok) matrix.solved = false;
    stepper.accept();
    matrix.columns.insert(matrix.columns.end(), next.begin(), next.end());
    if (j < n) matrix.errors.insert(matrix.errors.end(), error.begin(), error.end());
    for (std::size_t k = 0; k < past; ++k)
      matrix.columns.insert(matrix.columns.end(), stepper.history(k).begin(), stepper.history(k).end());
  }
  return matrix;
}

/// `with_stepper` of a method, called with anything that takes a stepper.
template <class T, class Use>
void with_stepper(typename MethodRuns<T>::WithStepper* method, const ErasedSystem<T>& system,
                  const std::vector<T>& model, Use use) {
  method(system, model, &use,
         [](void* context, ErasedStepper<T> stepper) { (*static_cast<Use*>(context))(stepper); });
}

}  // namespace

RunReport no_error_estimate(double t0) {
  RunReport report;
  report.status = RunStatus::not_applicable;
  report.reason = "has no error estimate: give a fixed number of steps";
  report.t_reached = t0;
  return report;
}

template <class T>
void set_runs(MethodRuns<T>& runs, typename MethodRuns<T>::WithStepper* method, int error_order) {
  runs.with_stepper = method;
  runs.solve = [=](const ErasedSystem<T>& system, const Control& control, double t0, double t1,
                   std::vector<T>& y) {
    RunReport report;
    with_stepper<T>(method, system, y, [&](ErasedStepper<T> stepper) {
      NoObserver nobody;
      report = run(stepper, system, control, error_order, t0, t1, y, nobody);
    });
    return report;
  };
  // a second stepper, on the uncounted system, makes the values between steps
  runs.solve_traced = [=](const ErasedSystem<T>& counted, const ErasedSystem<T>& bare, const Control& control,
                          double t0, double t1, std::vector<T>& y, Trace<T>& trace) {
    RunReport report;
    with_stepper<T>(method, bare, y, [&](ErasedStepper<T> side) {
      with_stepper<T>(method, counted, y, [&](ErasedStepper<T> stepper) {
        GridSampler sampler(side, y.size(), t0, t1, y, trace);
        report = run(stepper, counted, control, error_order, t0, t1, y, sampler);
      });
    });
    return report;
  };
  runs.transition = [=](const ErasedSystem<T>& homogeneous, T h) {
    TransitionMatrix<T> matrix;
    with_stepper<T>(method, homogeneous, std::vector<T>(homogeneous.size, T(0)),
                    [&](ErasedStepper<T> stepper) { matrix = transition_of(stepper, homogeneous.size, h); });
    return matrix;
  };
}

template double first_step(const ErasedSystem<float>&, const ErrorControl&, int, double, double,
                           const std::vector<float>&);
template double first_step(const ErasedSystem<double>&, const ErrorControl&, int, double, double,
                           const std::vector<double>&);
template double first_step(const ErasedSystem<long double>&, const ErrorControl&, int, double, double,
                           const std::vector<long double>&);
template void set_runs(MethodRuns<float>&, MethodRuns<float>::WithStepper*, int);
template void set_runs(MethodRuns<double>&, MethodRuns<double>::WithStepper*, int);
template void set_runs(MethodRuns<long double>&, MethodRuns<long double>::WithStepper*, int);

}  // namespace odemark
