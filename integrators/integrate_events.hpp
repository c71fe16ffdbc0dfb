// Runs over pieces: from switch to switch by the clock, and from event to event, which the state decides.
#pragma once

#include "integrators/any_method.hpp"

namespace odemark {

/// A problem in smooth pieces. In each phase the right-hand side is smooth. Phase n + 1 begins at
/// switch_times[n] or where an event says so. A view, like ErasedSystem. An event happens where its value
/// falls from above 0 to 0 or below; its jump is done there. Jumps and switch times do not mix.
template <class T>
struct Pieces {
  std::vector<ErasedSystem<T>> phases;  // [0] at the start
  std::vector<const void*> values;      // what the calls below take, one per phase
  std::vector<double> switch_times;     // ascending
  std::size_t events = 0;               // how many event values there are
  bool jumps = false;                   // events change the state or the phase; else they are kinks
  void (*values_call)(const void* self, T t, const T* y, T* g) = nullptr;
  /// Changes y as the event does and returns the next phase, given the present one.
  std::size_t (*after_call)(const void* self, std::size_t event, T t, T* y, std::size_t phase) = nullptr;

  bool empty() const { return switch_times.empty() && events == 0; }
};

struct FoundEvent {
  std::size_t event;
  double t;
};

/// More than any problem of the suite has; a run that meets more is chattering and ends as step_limit.
inline constexpr std::size_t most_events = 10'000;

/// One run of `whole`, the system that reads the clock itself, whose pieces are known.
/// Error-controlled runs stop at every switch and every event: at an event where a side run of the same
/// method from the last accepted state brackets it to a few ulps of t, its evaluations counted like all
/// others. Once a step the slope is asked for, because a dip below 0 and back inside a step shows only there.
/// Fixed steps step over both, as a game does: switches go unnoticed, jumps are done at the end of the step
/// in which the value changed its sign. `whole` and `counted` (one per phase, like pieces.phases) may count;
/// `bare` serves samples between steps.
template <class T>
RunReport integrate_events(const MethodRuns<T>& runs, const Pieces<T>& pieces, const ErasedSystem<T>& whole,
                           const std::vector<ErasedSystem<T>>& counted, const ErasedSystem<T>& bare,
                           const Control& control, double t0, double t1, std::vector<T>& y, Trace<T>& trace,
                           std::vector<FoundEvent>& found);

}  // namespace odemark
