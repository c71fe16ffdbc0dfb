// A suite problem in fifty digits, with states around its solution to look at it from.
#pragma once

#include <random>

#include "reference/truth_wide.hpp"
#include "tests/support/runs.hpp"

namespace odemark {

/// Without the large ones, which no fifty digits are spent on: large_test.cpp has their properties, and shows
/// that the first preset of each of their families is here.
inline const std::vector<AnyProblem>& every_preset() {
  static const std::vector<AnyProblem> all = [] {
    std::vector<AnyProblem> made;
    for (const auto& id : problem_ids(suite_families())) made.push_back(suite_problem(id));
    std::erase_if(made, [](const AnyProblem& problem) { return problem.is_large(); });
    return made;
  }();
  return all;
}

inline const WidePhase& phase_at(const WideProblem& wide, const Wide& t) {
  std::size_t phase = 0;
  while (phase < wide.switch_times.size() && t >= wide.switch_times[phase]) ++phase;
  return wide.phases[phase];
}

/// The phase that the solution is in at t, where events decide it.
inline const WidePhase& phase_at(const AnyProblem& problem, const WideProblem& wide, const Wide& t) {
  if (!wide.events.jumps) return phase_at(wide, t);
  std::size_t phase = 0;
  for (const auto& event : truth_of(problem)->events)
    if (Wide(event.t.decimal) <= t) phase = event.phase;
  return wide.phases[phase];
}

struct Place {
  double t;
  std::vector<double> y;
};

/// The start, and places within a tenth of a scale of it at other times, in double so that every number type
/// sees the same ones.
inline std::vector<Place> places_of(const AnyProblem& problem, int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-0.1, 0.1), time(0, 1);
  std::vector<Place> places{{problem.t_begin, problem.initial}};
  while (int(places.size()) < count) {
    Place place{problem.t_end * time(random), problem.initial};
    for (std::size_t i = 0; i < place.y.size(); ++i) place.y[i] += problem.scale[i] * unit(random);
    places.push_back(place);
  }
  return places;
}

template <class T>
std::vector<T> converted(const std::vector<double>& y) {
  return {y.begin(), y.end()};
}

inline double to_double(const Wide& x) { return static_cast<double>(x); }

}  // namespace odemark
