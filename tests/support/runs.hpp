// Bare runs of erased methods, and how their results are compared.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>

#include "bench/registry.hpp"
#include "bench/run.hpp"
#include "tests/support/print_method.hpp"

namespace odemark {

template <class T>
bool can_run(const AnyMethod& method, const AnyProblem& problem) {
  return method.runs<T>().solve && missing_ability(method.needs, problem.abilities).empty();
}

/// Where a bare run came to.
template <class T>
struct End {
  std::vector<T> y;
  RunReport report;
};

template <class T = double>
End<T> solve(const AnyMethod& method, const AnyProblem& problem, const Control& control) {
  End<T> end;
  for (const double x : problem.initial) end.y.push_back(static_cast<T>(x));
  end.report = method.runs<T>().solve(problem.system<T>(), control, problem.t_begin, problem.t_end, end.y);
  return end;
}

/// The last accepted step of a run that ended in a number, however the run ended.
struct LastStep {
  double from, to;
};

inline LastStep last_step(const AnyMethod& method, const AnyProblem& problem, const Control& control) {
  LastStep last{problem.t_begin, problem.t_begin};
  Trace<double> trace;
  trace.on_step = [&](double t, const double* y) {
    for (std::size_t i = 0; i < problem.size(); ++i)
      if (!std::isfinite(y[i])) return false;
    last.from = last.to, last.to = t;
    return true;
  };
  std::vector<double> y = problem.initial;
  const auto& system = problem.system<double>();
  try {
    method.runs<double>().solve_traced(system, system, control, problem.t_begin, problem.t_end, y, trace);
  } catch (const std::exception&) {  // of the problem's own making: the steps before it stay what they were
  }
  return last;
}

/// Which of its looks at a slope count: all of them, or those that its new state depends on, or that or its
/// estimate.
enum class Looks { all, of_state, of_state_and_estimate };

/// The latest place of a step, as part of it, at which it looks at a slope: that of its coefficients; 0 where
/// only its start is sure to be looked at.
inline double latest_node(const AnyMethod& method, Looks looks) {
  const Theory theory = method.theory();
  const Tableau& t = theory.tableau;
  const NystromTableau& n = theory.nystrom;
  const std::size_t stages = std::max(t.stages, n.stages);
  std::vector<bool> counts(stages, looks == Looks::all);
  const auto add = [&](const std::vector<Coefficient>& weights) {
    for (std::size_t i = 0; i < weights.size(); ++i) counts[i] = counts[i] || weights[i] != 0;
  };
  for (const auto* weights : {&t.b, &n.b_position, &n.b_velocity}) add(*weights);
  if (looks == Looks::of_state_and_estimate)
    for (const auto* weights : {&t.b_embedded, &n.b_position_embedded, &n.b_velocity_embedded}) add(*weights);
  const auto& a = t.stages > 0 ? t.a : n.a;
  for (std::size_t pass = 0; pass < stages; ++pass)  // what a stage that counts is made of
    for (std::size_t i = 0; i < stages; ++i)
      for (std::size_t j = 0; j < stages && counts[i]; ++j) {
        const bool by_matrix = !t.gamma.empty() && t.gamma[i * stages + j] != 0;
        counts[j] = counts[j] || a[i * stages + j] != 0 || by_matrix;
      }
  Coefficient latest = 0;
  for (std::size_t i = 0; i < stages; ++i) {
    if (!counts[i]) continue;
    Coefficient node = n.stages > 0 ? n.c[i] : 0;
    for (std::size_t j = 0; j < t.stages; ++j) node += t.a[i * stages + j];
    latest = std::max(latest, node);
  }
  if (theory.proof &&
      !theory.moves.empty()) {  // a splitting; with long ones the way there goes beyond the end
    Coefficient at = 0;
    for (const auto& move : theory.moves)
      if (move.what == SecondOrderMove::What::drift)
        at += move.weight;
      else
        latest = std::max(latest, at);
  }
  return double(latest);
}

/// Equal bits; every NaN is the same NaN.
template <class T>
bool same_bits(const T& a, const T& b) {
  constexpr std::size_t used = sizeof(T) == 16 ? 10 : sizeof(T);
  return (a != a && b != b) || std::memcmp(&a, &b, used) == 0;
}
template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!same_bits(a[i], b[i])) return false;
  return true;
}

/// Largest difference in units of the problem's scale; NaN if anything is NaN.
template <class T, class U>
double scaled_gap(const AnyProblem& problem, const std::vector<T>& a, const std::vector<U>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const long double gap = static_cast<long double>(a[i]) - static_cast<long double>(b[i]);
    const double scaled = static_cast<double>(gap < 0 ? -gap : gap) / problem.scale[i];
    if (!(scaled <= worst)) worst = scaled;
    if (worst != worst) return worst;
  }
  return worst;
}

inline const AnyMethod& suite_method(std::string_view id) {
  static const Registry registry{suite_methods(), {}};
  return find_method(registry, id);
}

inline AnyProblem suite_problem(std::string_view id, std::string_view settings = "") {
  return find_problem(suite_families(), id, settings);
}

/// Twenty orders in extended precision: the yardstick where no closed form is at hand.
inline std::vector<long double> fine_end(const AnyProblem& problem, long steps) {
  return solve<long double>(suite_method("taylor20"), problem, FixedSteps{steps}).y;
}

}  // namespace odemark
