// A method whose type is gone: one row of the catalogue, callable for any system.
#pragma once

#include <functional>
#include <tuple>

#include "integrators/erased_system.hpp"
#include "integrators/integrate.hpp"
#include "integrators/theory.hpp"

namespace odemark {

/// What a traced run records besides its end: the state at given times, and a look at every accepted step.
template <class T>
struct Trace {
  std::vector<double> grid;  // ascending times in (t0, t1]
  std::vector<T> samples;    // grid.size() rows of `size` numbers; NaN where the method has no value there
  std::function<bool(T t, const T* y)>
      on_step;  // after every accepted step; false stops the run (time_limit)
};

/// One step of a linear homogeneous problem as a matrix: column j is where the j-th unit vector goes. For
/// multistep methods the vector is (y, past slopes).
template <class T>
struct TransitionMatrix {
  std::size_t size = 0;
  std::vector<T> columns;  // column-major
  std::vector<T> errors;  // where the error estimate of the first `n` columns goes, n rows; zeros without one
  bool solved = true;     // false: a Newton iteration failed
};

template <class T>
class ErasedStepper;

/// The functions of a method for one number type; null where it does not work in that type.
template <class T>
struct MethodRuns {
  using Solve = RunReport(const ErasedSystem<T>&, const Control&, double t0, double t1, std::vector<T>& y);
  /// `bare` is the same system uncounted: values between steps are taken from it.
  using SolveTraced = RunReport(const ErasedSystem<T>& counted, const ErasedSystem<T>& bare, const Control&,
                                double t0, double t1, std::vector<T>& y, Trace<T>&);
  using Transition = TransitionMatrix<T>(const ErasedSystem<T>& homogeneous, T h);
  /// Calls `use(context, stepper)` with a stepper made for states like `model`, which lives as long as the
  /// call.
  using WithStepper = void(const ErasedSystem<T>&, const std::vector<T>& model, void* context,
                           void (*use)(void* context, ErasedStepper<T>));

  std::function<Solve> solve;
  std::function<SolveTraced> solve_traced;
  std::function<Transition> transition;
  WithStepper* with_stepper = nullptr;
};

struct AnyMethod {
  std::string_view id, kind, source;
  std::string_view provider = "odemark";  // or "sundials", "gsl", "odeint"
  int order = 0, embedded_order = 0;
  int order_with_rate_torque = 0;  // rotation methods: lower where a torque depends on the rate; 0: it stands
  unsigned needs = 0;
  bool takes_fixed_steps = true, takes_error_control = false, compensated = false, multistep = false;
  std::string_view starter = "";  // of a multistep method
  std::string_view note = "";     // what a reader of its rows must know
  std::string_view advice = "";   // when to use it and when not, in a line
  bool own_step_control = false;  // under error control it does not ask the step-size filter
  bool solves_equations = false;  // a step fails where an equation has no solution that it finds
  bool propagates_lower = false;  // of its two formulas the one of lower order is carried on
  bool jumps_over_poles = false;  // its step exists on the far side of a singularity too, as a finite number
  std::function<Theory()> theory;
  std::tuple<MethodRuns<float>, MethodRuns<double>, MethodRuns<long double>> by_type;

  template <class T>
  const MethodRuns<T>& runs() const {
    return std::get<MethodRuns<T>>(by_type);
  }
};

/// Every method of integrators/catalogue.txt, in its order.
const std::vector<AnyMethod>& suite_methods();

}  // namespace odemark
