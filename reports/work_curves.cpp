// Which row belongs to which curve, and which curves stand for a family.
#include "reports/work_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <tuple>

#include "reports/cheapest.hpp"
#include "reports/numbers.hpp"
#include "reports/observed_order.hpp"
#include "reports/shown_error.hpp"

namespace odemark {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::string_view, 4> landmarks{"explicit_euler", "semi_implicit_euler", "heun", "rk4"};
constexpr std::size_t families_shown = 6;

double floor_of(const Row& row) {
  return std::max({row.truth_floor, row.sensitivity, unit_roundoff(row.scalar)});
}

CurvePoint point_of(const Row& row) {
  CurvePoint p;
  p.control = row.rtol ? *row.rtol : row.dt.value_or(nan);
  p.failed = row.status != "reached_end";
  p.error = p.failed ? nan : shown_error(row);
  p.evaluations = static_cast<double>(row.work.evaluations);
  p.time = row.timing ? row.timing->ns_per_simulated_second : nan;
  p.floor = floor_of(row);
  p.status = row.status;
  if (row.timing) p.tier = row.timing->tier;
  return p;
}

using CurveKey = std::tuple<std::string, bool, std::string>;  // method, adaptive, filter

void label_curves(std::vector<WorkCurve>& curves) {
  for (WorkCurve& curve : curves) {
    const auto twin = [&](const WorkCurve& other, bool adaptive) {
      return other.method == curve.method && other.adaptive == adaptive && &other != &curve;
    };
    const bool fixed_twin =
        std::any_of(curves.begin(), curves.end(), [&](const auto& c) { return twin(c, false); });
    const bool adaptive_twin =
        std::any_of(curves.begin(), curves.end(), [&](const auto& c) { return twin(c, true); });
    curve.label = curve.method;
    if (curve.adaptive && adaptive_twin)
      curve.label += " (adaptive, " + curve.filter + ")";
    else if (curve.adaptive && fixed_twin)
      curve.label += " (adaptive)";
  }
}

}  // namespace

std::size_t WorkCurve::failures() const {
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [](const CurvePoint& p) { return p.failed; }));
}

std::string main_scalar(const std::vector<Row>& rows) {
  const bool has_double =
      std::any_of(rows.begin(), rows.end(), [](const Row& r) { return r.scalar == "double"; });
  return has_double || rows.empty() ? "double" : rows.front().scalar;
}

std::vector<Row> main_rows(const std::vector<Row>& rows) {
  const std::string scalar = main_scalar(rows);
  const auto pick = [&](bool precision, bool compensated) {
    std::vector<Row> chosen;
    for (const Row& row : rows)
      if (row.scalar == scalar && row.compensated == compensated && (row.plan == "precision") == precision)
        chosen.push_back(row);
    return chosen;
  };
  for (const bool precision : {false, true})
    for (const bool compensated : {false, true})
      if (auto chosen = pick(precision, compensated); !chosen.empty()) return chosen;
  return {};
}

std::vector<ProblemCurves> work_curves(const std::vector<Row>& rows) {
  std::vector<ProblemCurves> problems;
  std::map<std::string, std::size_t> problem_at;
  std::map<std::string, std::map<CurveKey, std::size_t>> curve_at;
  for (const Row& row : rows) {
    if (row.status == "not_applicable" || (!row.dt && !row.rtol)) continue;
    const auto [problem, new_problem] = problem_at.emplace(row.problem, problems.size());
    if (new_problem) problems.push_back({row.problem, 0, false, {}});
    ProblemCurves& here = problems[problem->second];
    const auto [at, is_new] = curve_at[row.problem].emplace(
        CurveKey{row.method, row.rtol.has_value(), row.filter}, here.curves.size());
    if (is_new)
      here.curves.push_back({row.problem,
                             row.method,
                             family_of(row.kind, row.provider),
                             row.provider,
                             row.method,
                             row.filter,
                             row.order,
                             row.rtol.has_value(),
                             {}});
    CurvePoint p = point_of(row);
    here.timed = here.timed || std::isfinite(p.time);
    here.floor = std::max(here.floor, p.floor);
    here.curves[at->second].points.push_back(std::move(p));
  }
  for (ProblemCurves& problem : problems) {
    label_curves(problem.curves);
    for (WorkCurve& curve : problem.curves)
      std::stable_sort(curve.points.begin(), curve.points.end(),
                       [](const CurvePoint& a, const CurvePoint& b) { return a.control > b.control; });
  }
  return problems;
}

std::string family_of(const std::string& kind, const std::string& provider) {
  if (provider == "sundials") return "SUNDIALS";
  if (provider == "gsl") return "GSL";
  if (provider == "odeint") return "Boost.odeint";
  if (provider != "odemark" && !provider.empty()) return provider;
  if (kind == "velocity Verlet" || kind == "splitting") return "splitting and Verlet";
  if (kind == "step doubling" || kind == "chapter listing" || kind == "step function")
    return "listings, step doubling";
  return kind;
}

Palette report_palette(const std::vector<MethodCard>& methods, const std::vector<Row>& rows) {
  std::vector<PaletteMember> members;
  for (const MethodCard& m : methods) members.push_back({m.id, family_of(m.kind, m.provider)});
  for (const Row& row : rows) members.push_back({row.method, family_of(row.kind, row.provider)});
  return Palette(members);
}

double rounded(double x, int digits) {
  return std::isfinite(x) ? std::strtod(fmt::format("{:.{}g}", x, digits).c_str(), nullptr) : x;
}

double smallest_error(const WorkCurve& curve) {
  double least = nan;
  for (const CurvePoint& p : curve.points)
    if (std::isfinite(p.error) && !(p.error >= least)) least = p.error;
  return least;
}

std::set<std::size_t> best_of_family(const ProblemCurves& problem, bool fixed_steps_only, double error) {
  struct Best {
    std::size_t index = 0;
    double evaluations = 0, error = 0;
  };
  std::map<std::string, Best> best;
  std::set<std::size_t> shown;
  const bool has_own = std::any_of(problem.curves.begin(), problem.curves.end(),
                                   [](const WorkCurve& c) { return !c.adaptive && c.provider == "odemark"; });
  for (std::size_t i = 0; i < problem.curves.size(); ++i) {
    const WorkCurve& curve = problem.curves[i];
    if (fixed_steps_only && (curve.adaptive || (has_own && curve.provider != "odemark"))) continue;
    if (!curve.adaptive && std::find(landmarks.begin(), landmarks.end(), curve.method) != landmarks.end())
      shown.insert(i);
    const auto offer = offer_of(curve, error, Cost::evaluations);
    const double least = smallest_error(curve);
    const Best now{i, offer ? offer->cost : infinity, std::isfinite(least) ? least : infinity};
    const auto [at, is_new] = best.emplace(curve.family, now);
    if (is_new) continue;
    const Best& old = at->second;
    if (now.evaluations < old.evaluations || (now.evaluations == old.evaluations && now.error < old.error))
      at->second = now;
  }
  std::vector<Best> families;
  for (const auto& [family, winner] : best) families.push_back(winner);
  std::stable_sort(families.begin(), families.end(), [](const Best& a, const Best& b) {
    return std::tie(a.evaluations, a.error) < std::tie(b.evaluations, b.error);
  });
  for (std::size_t i = 0; i < std::min(families.size(), families_shown); ++i) shown.insert(families[i].index);
  return shown;
}

}  // namespace odemark
