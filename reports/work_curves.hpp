// Rows sorted into curves: one method on one problem under one kind of control, from coarse to fine.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "bench/data/pictures.hpp"
#include "bench/data/row.hpp"
#include "reports/palette.hpp"

namespace odemark {

enum class Cost { evaluations, time };

struct CurvePoint {
  double control = 0;      // dt, s; or the relative tolerance
  double error = 0;        // scaled, at the end; NaN: the run did not reach it, or there is no truth
  double evaluations = 0;  // of the right-hand side over the run
  double time = 0;         // ns per simulated second; NaN: not timed
  double floor = 0;        // no error below it means anything
  bool failed = false;
  std::string status, tier;

  double cost(Cost kind) const { return kind == Cost::evaluations ? evaluations : time; }
};

struct WorkCurve {
  std::string problem, method, family, provider;
  std::string label;  // the method's id; with "(adaptive)" where it is also run with fixed steps
  std::string filter;
  int order = 0;
  bool adaptive = false;
  std::vector<CurvePoint> points;

  std::size_t failures() const;
};

struct ProblemCurves {
  std::string problem;
  double floor = 0;  // the highest of the curves: truth, sensitivity to the last bit of y0, unit roundoff
  bool timed = false;
  std::vector<WorkCurve> curves;
};

/// The number type that a report's main pictures are of: double if any run used it, else that of the first
/// row.
std::string main_scalar(const std::vector<Row>& rows);
/// The rows of the main pictures: that number type, plain sums, and not those of the plan "precision" unless
/// there is nothing else.
std::vector<Row> main_rows(const std::vector<Row>& rows);

/// In the order of their first rows. Rows that were not applicable make no curve.
std::vector<ProblemCurves> work_curves(const std::vector<Row>& rows);

/// What a legend groups a method under: its kind, or who provides it.
std::string family_of(const std::string& kind, const std::string& provider);

/// One look per method for a whole report: methods of the registry first, then others that have rows.
Palette report_palette(const std::vector<MethodCard>& methods, const std::vector<Row>& rows);

/// Shown by default: the four methods that everybody knows, and of each of the best six families the curve
/// with the fewest evaluations to `error` (or, if none gets there, the smallest error). With fixed steps only
/// our own methods stand for families: other libraries' are the same formulas. Indices into problem.curves.
std::set<std::size_t> best_of_family(const ProblemCurves& problem, bool fixed_steps_only,
                                     double error = 1e-6);

/// To the digits that a picture or a sorting script needs: a page holds thousands of numbers.
double rounded(double x, int digits = 5);

/// The smallest error of a curve; NaN if it has none.
double smallest_error(const WorkCurve& curve);

}  // namespace odemark
