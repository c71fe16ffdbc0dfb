#include "bench/solve.hpp"

#include <deque>

namespace odemark {

bool in_pieces(const AnyProblem& problem, const Control& control) {
  const auto& pieces = problem.pieces<double>();
  return std::holds_alternative<ErrorControl>(control) ? !pieces.empty() : pieces.jumps;
}

template <class T>
RunReport solve_problem(const AnyMethod& method, const AnyProblem& problem, const Control& control,
                        std::vector<T>& y, Trace<T>& trace, std::vector<FoundEvent>& found,
                        WorkCounts* counts) {
  const Pieces<T>& pieces = problem.pieces<T>();
  std::deque<CountingSystem<T>> counting;  // which do not move
  const auto counted = [&](const ErasedSystem<T>& system) {
    return counts ? counting.emplace_back(system, *counts).view() : system;
  };
  const ErasedSystem<T>& bare = problem.system<T>();
  const ErasedSystem<T> whole = counted(bare);
  found.clear();
  if (!in_pieces(problem, control) && pieces.events == 0)
    return method.runs<T>().solve_traced(whole, bare, control, problem.t_begin, problem.t_end, y, trace);
  std::vector<ErasedSystem<T>> phases;
  for (const auto& phase : pieces.phases) phases.push_back(counted(phase));
  return integrate_events(method.runs<T>(), pieces, whole, phases, bare, control, problem.t_begin,
                          problem.t_end, y, trace, found);
}

#define ODEMARK_FOR(T)                                                                                      \
  template RunReport solve_problem<T>(const AnyMethod&, const AnyProblem&, const Control&, std::vector<T>&, \
                                      Trace<T>&, std::vector<FoundEvent>&, WorkCounts*);
ODEMARK_FOR(float)
ODEMARK_FOR(double)
ODEMARK_FOR(long double)
#undef ODEMARK_FOR

}  // namespace odemark
