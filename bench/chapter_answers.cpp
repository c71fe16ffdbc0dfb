// Judges the seven claims from the measured numbers, by a rule for each.
#include <algorithm>
#include <stdexcept>

#include "bench/chapter_lab.hpp"

namespace odemark::chapter {

namespace {

const LimitLine& limit_of(const ChapterData& data, std::string_view problem, std::string_view method) {
  const auto found = std::find_if(data.limits.begin(), data.limits.end(), [&](const LimitLine& line) {
    return line.problem == problem && line.method == method;
  });
  if (found == data.limits.end()) throw std::logic_error("no such limit was measured");
  return *found;
}

/// Both faces were seen: a lasting oscillation, and growth.
Answer two_faces(const ChapterData& data) {
  const auto seen = [&](Behaviour behaviour) {
    return std::any_of(data.faces.begin(), data.faces.end(),
                       [&](const FaceRun& run) { return run.behaviour == behaviour; });
  };
  return seen(Behaviour::oscillates_for_ever) && seen(Behaviour::grows) ? Answer::holds
                                                                        : Answer::does_not_hold;
}

/// Euler has a limit on the ship, so that a smaller dt cures it; on the undamped spring no dt does.
Answer smaller_removes(const ChapterData& data) {
  const bool cured = limit_of(data, "drag_ship", "explicit_euler").dt.has_value();
  const bool incurable = !limit_of(data, "oscillator", "explicit_euler").dt;
  return !cured ? Answer::does_not_hold : incurable ? Answer::holds_with_limits : Answer::holds;
}

/// In single precision every method's error rises again below some dt.
Answer not_always_better(const ChapterData& data) {
  const auto turns = [](const ErrorCurve& c) { return c.scalar != "float" || c.minimum_inside; };
  if (std::all_of(data.errors.begin(), data.errors.end(), turns)) return Answer::holds;
  return std::any_of(data.errors.begin(), data.errors.end(), [](const auto& c) { return c.minimum_inside; })
             ? Answer::holds_with_limits
             : Answer::does_not_hold;
}

/// Larger limits than Euler's, per step and per evaluation, on every problem.
Answer more_stable(const ChapterData& data) {
  bool some = false, all = true;
  for (const LimitLine& line : data.limits) {
    if (line.method != "heun" && line.method != "rk4") continue;
    const LimitLine& euler = limit_of(data, line.problem, "explicit_euler");
    const bool larger = line.number > euler.number * (1 + 1e-6);
    some = some || larger;
    all = all && larger && line.number_per_evaluation >= euler.number_per_evaluation;
  }
  return all ? Answer::holds : some ? Answer::holds_with_limits : Answer::does_not_hold;
}

/// Within a tenth of the amplitude for five periods at some measured dt, and no dearer for the same error.
Answer practically_identical(const ChapterData& data) {
  const auto within = [](const DoublingLine& d) {
    constexpr double periods = 5;
    return !d.differ_10_percent || *d.differ_10_percent > periods;
  };
  const bool somewhere = std::any_of(data.doublings.begin(), data.doublings.end(), within);
  const bool everywhere = std::all_of(data.doublings.begin(), data.doublings.end(), within);
  const bool saves = std::all_of(data.equal_cost.begin(), data.equal_cost.end(),
                                 [](const EqualCostLine& e) { return e.heun_error <= e.rk4_error; });
  return !somewhere ? Answer::does_not_hold : everywhere && saves ? Answer::holds : Answer::holds_with_limits;
}

/// The smallest error at every dt that was compared; with limits where something else is cheaper.
Answer best_for_a_step(const ChapterData& data) {
  for (const SameStep& line : data.same_step)
    for (const auto& [method, error] : line.errors)
      if (error < line.errors.back().second) return Answer::does_not_hold;
  const bool beaten = std::any_of(data.crossovers.begin(), data.crossovers.end(), [](const Crossover& c) {
    return c.dear == "rk4" && (c.error || c.winner != "rk4");
  });
  return beaten ? Answer::holds_with_limits : Answer::holds;
}

/// The listing's local error stays within its tolerance; with limits if only the correct controller's does.
Answer within_a_limit(const ChapterData& data) {
  const auto kept = [&](std::string_view method, bool smooth_only) {
    return std::all_of(data.adaptive.begin(), data.adaptive.end(), [&](const AdaptiveRun& run) {
      return run.method != method || (smooth_only && run.has_switch) || run.worst_local <= 1;
    });
  };
  if (kept("chapter_adaptive_euler", false)) return Answer::holds;
  return kept("step_doubling_euler", true) ? Answer::holds_with_limits : Answer::does_not_hold;
}

}  // namespace

Answer answer(int claim, const ChapterData& data) {
  switch (claim) {
    case 1: return two_faces(data);
    case 2: return smaller_removes(data);
    case 3: return not_always_better(data);
    case 4: return more_stable(data);
    case 5: return practically_identical(data);
    case 6: return best_for_a_step(data);
    case 7: return within_a_limit(data);
  }
  throw std::logic_error("the chapter makes seven claims");
}

}  // namespace odemark::chapter
