// A problem in fifty-digit arithmetic: what truths are computed from.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "integrators/tape.hpp"
#include "reference/any_problem.hpp"
#include "reference/wide.hpp"

namespace odemark {

/// The right-hand side between two switch times. It is smooth there but for kinks of abs.
struct WidePhase {
  std::shared_ptr<const void> value;  // the family held in this phase
  Tape<Wide> tape;                    // of its rhs
};

/// What the state decides; see Pieces in integrators/integrate_events.hpp.
struct WideEvents {
  std::size_t count = 0;
  bool jumps = false;
  Wide look_every;  // no two events cancel within this time
  void (*values)(const void*, const Wide& t, const Wide* y, Wide* g) = nullptr;  // of a phase's value
  std::size_t (*after)(const void*, std::size_t event, const Wide& t, Wide* y, std::size_t phase) = nullptr;
};

/// An event of a solution; `phase` is the one after it.
struct WideEvent {
  std::size_t event = 0, phase = 0;
  Wide t;
};

struct WideProblem {
  std::size_t size = 0;
  Wide t_end;
  std::vector<Wide> initial, switch_times;
  std::vector<WidePhase> phases;  // one more than switch times, or as many as events need
  WideEvents events;
  std::shared_ptr<const void> value;  // Family<double>, or Family<Wide> for exact inputs
  void (*rhs)(const void*, const Wide& t, const Wide* y, Wide* dydt) = nullptr;  // of a phase's value
  void (*jacobian)(const void*, const Wide& t, const Wide* y, Wide* column_major) = nullptr;  // likewise
  void (*exact)(const void*, const Wide& t, const Wide* y0, Wide* y) = nullptr;  // null: no closed form
  /// The events of the closed form up to t; their phases are not told.
  void (*exact_events)(const void*, const Wide& t, const Wide* y0, std::vector<WideEvent>&) = nullptr;
  void (*invariants)(const void*, const Wide* y, Wide* out) = nullptr;  // null: none known
};

/// A closed form at some components, of a state that starts as the family says to the last digit.
struct SampledSolution {
  std::vector<Wide> y;
  /// How far each moves at most where every component of the initial state moves by at most 1, or one does.
  std::vector<double> spread, reach;
};

struct WideFamily {
  std::string_view id;
  /// The problem that a double integrator sees: parameters and initial state rounded to double, then exact.
  WideProblem (*rounded)(const AnyProblem&) = nullptr;
  /// The problem as written: every decimal of the settings at its full value. Throws BadInput like `create`.
  WideProblem (*as_written)(const AnyProblem&) = nullptr;
  /// Null where the closed form needs the whole state.
  SampledSolution (*sampled)(const AnyProblem&, const Wide& t,
                             const std::vector<std::size_t>& places) = nullptr;
};

const std::vector<WideFamily>& suite_wide_families();

}  // namespace odemark
