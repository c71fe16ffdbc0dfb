// Bare runs of erased methods, and how their results are compared.
#pragma once

#include <cstring>
#include <ostream>

#include "bench/registry.hpp"
#include "bench/run.hpp"

namespace odemark {

inline void PrintTo(const AnyMethod& method, std::ostream* out) { *out << method.id; }

/// Kinds whose steps can end because an equation has no solution that they find.
inline bool solves_equations(const AnyMethod& method) {
  for (const std::string_view kind :
       {"diagonally implicit Runge-Kutta", "fully implicit Runge-Kutta", "variable-order Radau IIA",
        "Rosenbrock", "implicit multistep", "linearly implicit extrapolation", "variable-order BDF",
        "average vector field"})
    if (method.kind == kind) return true;
  return false;
}

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
