// What a compiled step does to the pendulum and to a quadrature: work, nodes, areas, the way back.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/linear_block.hpp"
#include "bench/measured_facts.hpp"
#include "integrators/facts.hpp"
#include "reference/any_problem.hpp"

namespace odemark {

namespace {

MeasuredFact compared(const char* name, const std::string& scalar, double theory, double measured,
                      double bound, std::string note) {
  MeasuredFact fact;
  fact.fact = name, fact.scalar = scalar, fact.theory = theory, fact.measured = measured;
  fact.difference = measured - theory, fact.bound = bound;
  fact.agrees = std::abs(measured - theory) <= bound;
  fact.note = std::move(note);
  return fact;
}

/// Evaluations of the right-hand side or the force in a step, once a method has started.
template <class T>
void count_evaluations(const AnyMethod& method, const MethodFacts& facts, const AnyProblem& pendulum,
                       const std::string& scalar, std::vector<MeasuredFact>& out) {
  const auto evaluations = [&](long steps) {
    WorkCounts counts;
    const CountingSystem<T> counting(pendulum.system<T>(), counts);
    std::vector<T> y(pendulum.initial.begin(), pendulum.initial.end());
    method.runs<T>().solve(counting.view(), FixedSteps{steps}, 0, 0.0625 * double(steps), y);
    return counts.rhs + counts.acceleration;
  };
  const double per_step = double(evaluations(32) - evaluations(16)) / 16;
  if (per_step == 0) return;  // it works on the recorded right-hand side
  if (facts.evaluations_per_step) {
    out.push_back(compared("evaluations_per_step", scalar, *facts.evaluations_per_step, per_step, 0,
                           "counted over 16 steps of the pendulum"));
    return;
  }
  MeasuredFact fact;
  fact.fact = "evaluations_per_step", fact.scalar = scalar, fact.measured = per_step;
  fact.note = "counted over 16 steps of the pendulum; " + facts.evaluations_per_step.reason;
  out.push_back(std::move(fact));
}

/// Of y' = (k + 1) t^k a method of order p makes no error for k < p, if it evaluates where it says.
template <class T>
void measure_nodes(const AnyMethod& method, const std::string& scalar, std::vector<MeasuredFact>& out) {
  if ((method.needs & ~Quadrature<T>{0}.view().abilities) != 0) return;
  // A multistep method too: the error of a starter of lower order would stay. An acceleration that is carried
  // along is that of another time (S. Erlicher, L. Bonaventura, O. S. Bursi, Comput. Mech. 28 (2002) 83-104):
  // its start, the force at t0, leaves an error of h^order behind in the highest power, and nothing else
  // does.
  const bool carries_acceleration =
      !method.starter.empty() && method.theory && method.theory().second_order_step != nullptr;
  // linearly implicit steps difference their right-hand side in t
  const bool differenced = method.theory && !method.theory().tableau.gamma.empty();
  const double slack = std::max(differenced ? 1e-5 : 0, 4096 * double(std::numeric_limits<T>::epsilon()));
  double worst = 0;
  int where = 0;
  for (int k = 0; k < method.order; ++k) {
    const auto off_after = [&](long steps) {
      const Quadrature<T> problem{k};
      std::vector<T> y(2, T(0));
      method.runs<T>().solve(problem.view(), FixedSteps{steps}, 0, 1, y);
      return double(y[1]) - 1;
    };
    double off = off_after(method.multistep ? 32 : 1);
    if (carries_acceleration && k + 1 == method.order) off -= std::ldexp(off_after(64), method.order);
    off = std::abs(off);
    if (!(off <= worst)) worst = off, where = k;
  }
  if (method.order > 0)
    out.push_back(
        compared("quadrature in t", scalar, 0, worst, slack,
                 fmt::format("largest error of y' = (k + 1) t^k over k < {}, at k = {}{}", method.order,
                             where, carries_acceleration ? ", less what the start leaves behind" : "")));
}

template <class T>
std::vector<double> step_of_pendulum(const AnyMethod& method, const AnyProblem& pendulum,
                                     const std::vector<double>& from, double h) {
  std::vector<T> y(from.begin(), from.end());
  method.runs<T>().solve(pendulum.system<T>(), FixedSteps{1}, 0, h, y);
  return {y.begin(), y.end()};
}

/// The determinant of the Jacobian of a step by central differences: areas that a symplectic step keeps.
void measure_area(const AnyMethod& method, const AnyProblem& pendulum, std::vector<MeasuredFact>& out) {
  constexpr double h = 0.5, move = 0x1p-16;
  double m[2][2];
  for (std::size_t j = 0; j < 2; ++j) {
    auto plus = pendulum.initial, minus = pendulum.initial;
    plus[j] += move, minus[j] -= move;
    plus = step_of_pendulum<double>(method, pendulum, plus, h);
    minus = step_of_pendulum<double>(method, pendulum, minus, h);
    for (std::size_t i = 0; i < 2; ++i) m[i][j] = (plus[i] - minus[i]) / (2 * move);
  }
  out.push_back(compared("symplectic", "double", 1, m[0][0] * m[1][1] - m[0][1] * m[1][0], 1e-8,
                         "determinant of the Jacobian of a step of the pendulum"));
}

template <class T>
void measure_way_back(const AnyMethod& method, const AnyProblem& pendulum, const std::string& scalar,
                      std::vector<MeasuredFact>& out) {
  const auto forth = step_of_pendulum<T>(method, pendulum, pendulum.initial, 0.125);
  const auto back = step_of_pendulum<T>(method, pendulum, forth, -0.125);
  double gap = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const double off = std::abs(back[i] - double(T(pendulum.initial[i])));
    if (!(off <= gap)) gap = off;
  }
  out.push_back(compared("symmetric", scalar, 0, gap, 64 * double(std::numeric_limits<T>::epsilon()),
                         "where a step of the pendulum and the step back end"));
}

template <class T>
std::vector<MeasuredFact> nonlinear_facts(const AnyMethod& method, const std::string& scalar) {
  std::vector<MeasuredFact> out;
  if (!method.runs<T>().solve || !method.takes_fixed_steps) return out;
  static const AnyProblem pendulum = find_problem(suite_families(), "pendulum_rotating");
  const Quadrature<T> still{0};
  if ((method.needs & ~still.view().abilities) == 0) {  // codes that choose their own steps say so when asked
    std::vector<T> y(2, T(0));
    if (method.runs<T>().solve(still.view(), FixedSteps{1}, 0, 1, y).status == RunStatus::not_applicable)
      return out;
  }
  const MethodFacts facts =
      method_facts(method.theory ? method.theory() : Theory{}, method.order, method.embedded_order);
  if ((method.needs & ~pendulum.abilities) == 0) {
    count_evaluations<T>(method, facts, pendulum, scalar, out);
    const bool one_step = !method.multistep;
    if (one_step && facts.symmetric && *facts.symmetric) measure_way_back<T>(method, pendulum, scalar, out);
    if (one_step && facts.symplectic && *facts.symplectic && scalar == "double")
      measure_area(method, pendulum, out);
  }
  measure_nodes<T>(method, scalar, out);
  return out;
}

}  // namespace

std::vector<MeasuredFact> detail::measure_nonlinear(const AnyMethod& method, const std::string& scalar) {
  return scalar == "float" ? nonlinear_facts<float>(method, scalar) : nonlinear_facts<double>(method, scalar);
}

}  // namespace odemark
