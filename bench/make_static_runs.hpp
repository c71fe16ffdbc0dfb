// Instantiates methods on one family, right-hand side inlined.
#pragma once

#include <algorithm>

#include "bench/family_system.hpp"
#include "bench/static_run.hpp"
#include "integrators/erase_method.hpp"

namespace odemark {

template <class F, const auto& method>
RunReport solve_static(const void* values, const Control& control, double t0, double t1, double* y) {
  using P = FamilySystem<F, double>;
  const P system{*static_cast<const F*>(values)};
  typename P::State state;
  std::copy_n(y, F::size, state.begin());
  const RunReport report = solve<method>(system, control, t0, t1, state);
  std::copy_n(state.begin(), F::size, y);
  return report;
}

template <class F, const auto& method>
void add_static_run(std::vector<StaticRun>& runs) {
  if constexpr (Applicable<method, FamilySystem<F, double>>)
    if (missing_ability(KindOf<method>::needs, abilities_of<F>()).empty())
      runs.push_back({F::id, method.id, solve_static<F, method>});
}

template <class F, const auto&... methods>
void add_static_runs(std::vector<StaticRun>& runs) {
  (add_static_run<F, methods>(runs), ...);
}

}  // namespace odemark
