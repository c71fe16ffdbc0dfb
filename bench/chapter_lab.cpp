// Steps a method of the catalogue on a problem of the catalogue, counted, and evaluates the closed forms.
#include "bench/chapter_lab.hpp"

#include <algorithm>
#include <stdexcept>

#include "problems/drag_ship.hpp"
#include "problems/drag_ship_quadratic.hpp"
#include "problems/oscillator.hpp"

namespace odemark::chapter {

const AnyMethod& method_called(std::string_view id) {
  const auto& all = suite_methods();
  const auto found = std::find_if(all.begin(), all.end(), [&](const AnyMethod& m) { return m.id == id; });
  if (found == all.end()) throw std::logic_error("the chapter page needs the method " + std::string(id));
  return *found;
}

AnyProblem problem_called(std::string_view id, std::string_view settings) {
  return find_problem(suite_families(), id, settings);
}

template <class T>
std::vector<T> initial_state(const AnyProblem& problem) {
  std::vector<T> y(problem.initial.size());
  std::transform(problem.initial.begin(), problem.initial.end(), y.begin(), [](double x) { return T(x); });
  return y;
}

namespace {

/// The same ship with its clock set to 0 at the time `from`, in wide arithmetic.
template <class T>
DragShipQuadratic<long double> begun_at(const DragShipQuadratic<>& ship, T from) {
  DragShipQuadratic<long double> wide;
  const auto widened = [](double x) { return static_cast<long double>(x); };
  wide.thrust = widened(ship.thrust), wide.c = widened(ship.c), wide.m = widened(ship.m);
  wide.t_reverse = widened(ship.t_reverse) - static_cast<long double>(from);
  return wide;
}

}  // namespace

template <class T>
std::vector<T> exact_flow(const AnyProblem& problem, T h, const std::vector<T>& y0, T from) {
  std::vector<T> y(y0.size());
  const auto flow = [&](const auto& family) { family.exact(h, y0.data(), y.data()); };
  if (problem.family == DragShip<>::id)
    flow(*static_cast<const DragShip<>*>(problem.value.get()));
  else if (problem.family == DragShipQuadratic<>::id)
    flow(begun_at(*static_cast<const DragShipQuadratic<>*>(problem.value.get()), from));
  else if (problem.family == Oscillator<>::id)
    flow(*static_cast<const Oscillator<>*>(problem.value.get()));
  else
    throw std::logic_error("the chapter page knows no closed form of " + problem.id);
  return y;
}

namespace {

template <class T>
Stepped<T> solve(const AnyMethod& method, const AnyProblem& problem, const Control& control, double t_end,
                 OnStep<T> on_step) {
  WorkCounts counts;
  const CountingSystem<T> counting(problem.system<T>(), counts);
  Stepped<T> out;
  out.y = initial_state<T>(problem);
  Trace<T> trace;
  trace.on_step = std::move(on_step);
  out.report =
      method.runs<T>().solve_traced(counting.view(), problem.system<T>(), control, 0, t_end, out.y, trace);
  out.evaluations = counts.rhs + counts.acceleration;
  return out;
}

}  // namespace

template <class T>
Stepped<T> step(const AnyMethod& method, const AnyProblem& problem, double dt, long count,
                OnStep<T> on_step) {
  return solve<T>(method, problem, FixedSteps{count}, double(count) * dt, std::move(on_step));
}

template <class T>
Stepped<T> adapt(const AnyMethod& method, const AnyProblem& problem, const ErrorControl& control,
                 double t_end, OnStep<T> on_step) {
  return solve<T>(method, problem, control, t_end, std::move(on_step));
}

int evaluations_per_step(const AnyMethod& method, const AnyProblem& problem) {
  constexpr long steps = 100;
  return int(step<double>(method, problem, 1e-3, steps).evaluations / steps);
}

Trajectory stepped_curve(std::string_view method, const AnyProblem& problem, std::size_t i, double dt,
                         long count) {
  Trajectory curve{problem.id, std::string(method), "double", {}, {}, dt, {0}, {problem.initial[i]}};
  curve.component = problem.components[i].name, curve.unit = problem.components[i].unit;
  step<double>(method_called(method), problem, dt, count, [&](double t, const double* y) {
    curve.t.push_back(t), curve.value.push_back(y[i]);
    return true;
  });
  return curve;
}

Trajectory exact_curve(const AnyProblem& problem, std::size_t i, double from, double to, int points) {
  Trajectory curve{problem.id, "exact", "double", {}, {}, 0, {}, {}};
  curve.component = problem.components[i].name, curve.unit = problem.components[i].unit;
  const auto start = initial_state<double>(problem);
  for (int n = 0; n <= points; ++n) {
    const double t = from + (to - from) * n / points;
    curve.t.push_back(t);
    curve.value.push_back(exact_flow<double>(problem, t, start)[i]);
  }
  return curve;
}

std::complex<long double> stability_function(const AnyMethod& method, std::complex<long double> z) {
  const Theory theory = method.theory();
  const auto at = [&](const std::vector<Coefficient>& p) {
    std::complex<long double> sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = sum * z + p[i];
    return sum;
  };
  if (theory.numerator.empty())
    throw std::logic_error("no stability function of one variable: " + std::string(method.id));
  return at(theory.numerator) / at(theory.denominator);
}

long double spectral_radius(long double a, long double b, long double c, long double d) {
  if (b == 0 || c == 0) return std::max(std::abs(a), std::abs(d));  // no cancellation where both are near 1
  const long double half = (a + d) / 2, determinant = a * d - b * c, beyond = half * half - determinant;
  if (beyond < 0) return std::sqrt(determinant);  // a complex pair
  return std::abs(half) + std::sqrt(beyond);
}

template std::vector<float> initial_state<float>(const AnyProblem&);
template std::vector<double> initial_state<double>(const AnyProblem&);
template std::vector<long double> initial_state<long double>(const AnyProblem&);
template std::vector<float> exact_flow<float>(const AnyProblem&, float, const std::vector<float>&, float);
template std::vector<double> exact_flow<double>(const AnyProblem&, double, const std::vector<double>&,
                                                double);
template std::vector<long double> exact_flow<long double>(const AnyProblem&, long double,
                                                          const std::vector<long double>&, long double);
template Stepped<float> step<float>(const AnyMethod&, const AnyProblem&, double, long, OnStep<float>);
template Stepped<double> step<double>(const AnyMethod&, const AnyProblem&, double, long, OnStep<double>);
template Stepped<double> adapt<double>(const AnyMethod&, const AnyProblem&, const ErrorControl&, double,
                                       OnStep<double>);

}  // namespace odemark::chapter
