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

}  // namespace

RunReport no_error_estimate(double t0) {
  RunReport report;
  report.status = RunStatus::not_applicable;
  report.reason = "has no error estimate: give a fixed number of steps";
  report.t_reached = t0;
  return report;
}

template <class T>
RunReport solve_erased(ErasedStepper<T> stepper, const ErasedSystem<T>& system, const Control& control,
                       int error_order, double t0, double t1, std::vector<T>& y) {
  NoObserver nobody;
  return run(stepper, system, control, error_order, t0, t1, y, nobody);
}

template <class T>
RunReport solve_erased_traced(ErasedStepper<T> stepper, ErasedStepper<T> side, const ErasedSystem<T>& system,
                              const Control& control, int error_order, double t0, double t1,
                              std::vector<T>& y, Trace<T>& trace) {
  GridSampler sampler(side, y.size(), t0, t1, y, trace);
  return run(stepper, system, control, error_order, t0, t1, y, sampler);
}

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

template double first_step(const ErasedSystem<float>&, const ErrorControl&, int, double, double,
                           const std::vector<float>&);
template double first_step(const ErasedSystem<double>&, const ErrorControl&, int, double, double,
                           const std::vector<double>&);
template double first_step(const ErasedSystem<long double>&, const ErrorControl&, int, double, double,
                           const std::vector<long double>&);
#define ODEMARK_NUMBER(T)                                                                                  \
  template RunReport solve_erased(ErasedStepper<T>, const ErasedSystem<T>&, const Control&, int, double,   \
                                  double, std::vector<T>&);                                                \
  template RunReport solve_erased_traced(ErasedStepper<T>, ErasedStepper<T>, const ErasedSystem<T>&,       \
                                         const Control&, int, double, double, std::vector<T>&, Trace<T>&); \
  template TransitionMatrix<T> transition_of(ErasedStepper<T>, std::size_t, T);
ODEMARK_NUMBER(float)
ODEMARK_NUMBER(double)
ODEMARK_NUMBER(long double)
#undef ODEMARK_NUMBER

}  // namespace odemark
