// What is known of a solution: decimals, the bound of their error, and where both come from.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "reference/any_problem.hpp"

namespace odemark {

/// One component at one time.
struct TruthValue {
  std::string decimal;         // to a few digits beyond the certified ones
  long double hi = 0, lo = 0;  // hi is the decimal rounded, hi + lo the decimal to about 38 digits
  long double bound = 0;       // certified: |decimal - solution| is at most this
  int digits = 0;              // certified relative digits of this component; 0 where it passes through zero
};

struct TruthPoint {
  double t = 0;
  std::vector<TruthValue> values;  // one per component, or per one of Truth::places
  int digits = 0;                  // certified digits of the worst component, in units of the problem's scale
  /// Largest change of a component, in units of its scale, when one component of y(0) moves by one ulp of
  /// double (a component that starts at 0: by one ulp of its scale). No double integrator can be expected to
  /// do better.
  double sensitivity = 0;
};

/// An instant at which the state decided that something happens, and the phase of the problem from then on.
struct TruthEvent {
  std::size_t event = 0, phase = 0;
  TruthValue t;
};

/// A certificate: both origins agree to the bounds stated. They share the right-hand side and nothing else.
struct Truth {
  std::string problem;  // AnyProblem::id
  std::string origin,
      checked_by;  // "closed form", "Taylor series of order 54", ...; `points` hold what `origin` found
  bool exact_inputs =
      false;            // every decimal of the settings at full value; otherwise rounded to double first
  bool stored = false;  // read from the stored solutions
  double seconds = 0;   // spent to compute it
  int digits = 0;       // of the worst point
  std::vector<TruthPoint> points;   // ascending in t
  std::vector<TruthEvent> events;   // all up to the last point, in order
  std::vector<std::size_t> places;  // the components that `values` are of; empty: all

  const TruthPoint& last() const { return points.back(); }
};

/// y - truth without losing the digits in which they agree: the error of a result as good as a long double is
/// real.
inline long double difference(long double y, const TruthValue& truth) { return (y - truth.hi) - truth.lo; }

/// What could not be certified, in one sentence.
struct TruthUnavailable : std::runtime_error {
  TruthUnavailable(const std::string& sentence, int digits)
      : std::runtime_error(sentence), digits_reached(digits) {}
  int digits_reached;  // of the two computations that disagree; 0 where none was finished
};

struct CertifyOptions {
  int digits = 30;            // asked for, in units of the problem's scale
  bool exact_inputs = false;  // solve the problem as written, not as a double program sees it
  bool sensitivity = true;
  double time_limit_seconds = 120;
  /// "taylor", "extrapolation", "radau", "lobatto" or "closed_form"; empty: chosen from the problem.
  std::string_view first, second;
};

/// The most digits that fifty-digit arithmetic can be asked for.
inline constexpr int most_digits = 38;

/// Solves the problem twice and compares. Times are ascending and positive; they may lie beyond t_end. Throws
/// TruthUnavailable where the digits asked for are not reached, BadInput for a request that makes no sense.
Truth certify(const AnyProblem& problem, const std::vector<double>& times,
              const CertifyOptions& options = {});

/// The grid on which truths are stored: t_j = (j * t_end) / 16 in double, j = 1 .. 16; the last is t_end.
std::vector<double> common_times(const AnyProblem& problem);

/// The stored truth, or null: nothing is computed.
std::shared_ptr<const Truth> stored_truth_of(const AnyProblem& problem);

/// The truth on the common grid, for inputs rounded to double: stored if the problem is a preset as it was
/// when the solution was made; else its closed form; else certified now to 25 digits. Of a large problem: its
/// closed form at the end of the interval and at some components. Computed once; any thread may ask. Throws
/// TruthUnavailable.
std::shared_ptr<const Truth> truth_of(const AnyProblem& problem);

}  // namespace odemark
