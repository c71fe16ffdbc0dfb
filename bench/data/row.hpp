// What one run of one method on one problem gave. Plain data, all text and numbers: what reports see of a
// bench.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace odemark {

inline constexpr int row_schema = 1;

/// Evaluations and solves of one run, counted on the run that the error is of.
struct RowWork {
  long rhs = 0, acceleration = 0, jacobian = 0, series = 0, lu = 0, newton = 0;
  /// Evaluations of the right-hand side in any form; a Taylor expansion of order p counts as p of them.
  long evaluations = 0;
};

/// A motion that has died to less than this, in its scale, says little by its end.
inline constexpr double next_to_nothing = 1e-3;

/// Distances from the truth at the end and over the common time grid. Absent unless the run reached the end.
struct RowErrors {
  double scaled = 0;  // max over components of |y - truth| / scale of the component: what curves are drawn of
  double absolute = 0;             // max |y - truth|
  std::optional<double> relative;  // max |y - truth| / |truth|; absent where a component of the truth is 0
  double rms = 0;                  // root mean square over the components of (y - truth) / scale
  std::optional<double> trajectory_max;  // like `scaled` and `rms`, over all times of the grid
  std::optional<double> trajectory_rms;
  std::optional<double> amplitude;  // oscillations: amplitude / true amplitude - 1 at the end
  std::optional<double> phase;  // oscillations: phase - true phase at the end, rad, unwrapped along the run
  /// The largest component of the truth at the end, in its scale; only where that is below next_to_nothing.
  std::optional<double> left;
};

/// Wall time of the same request, run again bare.
struct RowTiming {
  double minimum_seconds = 0, median_seconds = 0,
         mad_seconds = 0;  // of a whole run; median absolute deviation
  int repeats = 0;
  double ns_per_step = 0;              // minimum over accepted + rejected steps
  double ns_per_simulated_second = 0;  // minimum over t_end
  std::string tier;  // "static": right-hand side inlined; "erased": called through a pointer
};

/// DETEST's measure of an error control: each accepted step against the exact solution through its own start,
/// in units of the tolerance (T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637).
struct RowLocal {
  long judged = 0;    // accepted steps whose local solution is known well enough
  long deceived = 0;  // of those: the true local error is above the tolerance
  double worst = 0;   // largest true local error over the tolerance
};

/// Events of a run beside those of the solution, matched in order. Fixed steps notice an event at the end of
/// the step that holds it; error control locates it.
struct RowEvents {
  long found = 0, expected = 0;
  std::optional<double> worst_time_error;  // largest |t - true t| of the matched ones, in the unit of t
};

/// The sizes of accepted steps along a run, thinned out: step[i] was taken at time[i].
struct RowSteps {
  std::vector<double> time, step;
};

struct Row {
  // identity
  std::string id;    // plan/problem/method/scalar[+compensated]/steps=N or rtol=X: unique in a results file
  std::string plan;  // which part of a suite asked for it: "convergence", "work_precision", "precision", ...
  std::string problem, family, settings;  // settings: what the user set
  std::string method, kind, provider;
  int order = 0, embedded_order = 0;
  /// Where theory leaves less than that order on this problem: what (0: nothing), and why.
  std::optional<int> expected_order;
  std::string expected_because;
  std::string scalar;  // "float", "double" or "long_double"
  bool compensated = false;
  std::optional<long> steps;         // fixed steps ...
  std::optional<double> dt;          // ... and their size
  std::optional<double> rtol, atol;  // or error control
  std::string filter;                // of the step controller

  // what happened
  std::string status, reason;
  long accepted = 0, rejected = 0;
  double t_end = 0, t_reached = 0;
  RowWork work;

  // how good
  std::optional<RowErrors> errors;
  double truth_floor = 0;  // no error below this is claimed: the truth's own bound, scaled
  double sensitivity = 0;  // scaled change of the end when y0 moves by one ulp of the scalar
  double truth_digits = 0;
  std::map<std::string, double>
      drift;  // largest change of each invariant over the run, relative to its start

  std::optional<RowEvents> events;  // of problems that have any

  // how honest, where it was asked for
  std::optional<RowLocal> local;
  std::optional<RowSteps> history;

  // how fast
  std::optional<RowTiming> timing;

  // proof
  std::string state_hash;  // FNV-1a of the bits of the final state, 16 hex digits; the timed run had the same
};

/// Where and with what a results file was made; its first line.
struct RunHeader {
  int schema = row_schema;
  std::string suite, version, revision, date;
  std::string compiler, flags, build_type, processor, system;
  int cores = 0;
  std::map<std::string, std::string> providers;  // "sundials" -> "6.4.1", ...
  std::vector<std::string> footnotes;            // of `odemark doctor`: what affects these numbers
};

}  // namespace odemark
