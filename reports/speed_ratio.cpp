// Splits the curves of a problem by who provides them, and asks both halves for their cheapest.
#include "reports/speed_ratio.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/format.hpp"

namespace odemark {
namespace {

/// Error-controlled curves of one side; times over the whole run differ from those per second by a constant.
ProblemCurves side_of(const ProblemCurves& problem, bool own) {
  ProblemCurves side{problem.problem, problem.floor, problem.timed, {}};
  for (const WorkCurve& curve : problem.curves)
    if (curve.adaptive && (curve.provider == "odemark") == own) side.curves.push_back(curve);
  return side;
}

/// What came nearest, or what became of the runs.
std::string reason_of(const ProblemCurves& side, double error) {
  if (side.curves.empty()) return "none ran";
  const WorkCurve* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  std::string status;
  for (const WorkCurve& curve : side.curves) {
    if (const double e = smallest_error(curve); e < least) least = e, nearest = &curve;
    for (const CurvePoint& p : curve.points)
      if (p.failed) status = p.status;
  }
  if (!nearest) return "none reached the end" + (status.empty() ? "" : ": " + status);
  if (least > error) return fmt::format("nearest: {} with {}", nearest->method, scientific(least, 1));
  if (error < side.floor) return fmt::format("below what the truth can tell, {}", scientific(side.floor, 1));
  return fmt::format("not timed where it is reached ({})", nearest->method);
}

void add_side(std::vector<Cell>& cells, const std::optional<Offer>& offer, const std::string& reason,
              std::size_t count) {
  if (!offer) {
    cells.push_back({reason, Status::muted}), cells.push_back({std::string(no_value), Status::muted});
    cells.push_back({"0", Status::muted, 0});
    return;
  }
  cells.push_back({fmt::format("{} ({})", offer->label, offer->tier)});
  cells.push_back(
      {(offer->at_most ? "≤ " : "") + cost_text(*offer, Cost::time), Status::plain, rounded(offer->cost)});
  cells.push_back({fmt::format("{}", count), Status::plain, static_cast<double>(count)});
}

void add_ratio(std::vector<Cell>& cells, const std::optional<double>& ratio) {
  if (!ratio)
    cells.push_back({std::string(no_value), Status::muted});
  else
    cells.push_back({fmt::format("{:.2f}", *ratio), *ratio <= 1 ? Status::ok : Status::warn, *ratio});
}

}  // namespace

std::optional<double> SpeedRatio::ratio() const {
  if (!own || !other) return std::nullopt;
  return own->cost / other->cost;
}

std::vector<SpeedRatio> speed_ratios(const std::vector<ProblemCurves>& problems) {
  std::vector<SpeedRatio> ratios;
  for (const ProblemCurves& problem : problems) {
    if (!problem.timed) continue;
    const ProblemCurves own = side_of(problem, true), other = side_of(problem, false);
    for (const double error : ratio_errors) {
      SpeedRatio r;
      r.problem = problem.problem, r.error = error;
      const auto ours = cheapest(own, error, Cost::time), theirs = cheapest(other, error, Cost::time);
      r.own_count = ours.size(), r.other_count = theirs.size();
      for (std::size_t i = 0; i < r.everyday.size(); ++i)
        if (const auto offer = std::find_if(ours.begin(), ours.end(),
                                            [&](const Offer& o) { return o.method == everyday_methods[i]; });
            offer != ours.end())
          r.everyday[i] = *offer;
      if (ours.empty())
        r.own_reason = reason_of(own, error);
      else
        r.own = ours.front();
      if (theirs.empty())
        r.other_reason = reason_of(other, error);
      else
        r.other = theirs.front();
      ratios.push_back(std::move(r));
    }
  }
  return ratios;
}

Table speed_ratio_table(const std::vector<SpeedRatio>& ratios) {
  Table table{
      "speed-ratios",
      "Time to an error: our best over the best of the others",
      "Least time per simulated second, minimum of repeated runs, all methods at one tolerance after each "
      "other. Interpolated between neighbouring tolerances of a method on logarithmic axes, never "
      "extrapolated; ≤: the coarsest tolerance is already this good. static: right-hand side inlined "
      "into the step; erased: called through a pointer. Codes: how many get there, of which the fastest "
      "stands here. The last columns are single methods of ours over the best of the others, as one would "
      "take "
      "them without looking.",
      {{"problem"},
       {"error", Align::right},
       {"ours"},
       {"time", Align::right},
       {"codes", Align::right},
       {"best of the others"},
       {"time", Align::right},
       {"codes", Align::right},
       {"ratio", Align::right}},
      {}};
  for (const auto method : everyday_methods) table.columns.push_back({std::string(method), Align::right});
  for (const SpeedRatio& r : ratios) {
    std::vector<Cell> cells{{r.problem}, {target_text(r.error), Status::plain, r.error}};
    add_side(cells, r.own, r.own_reason, r.own_count);
    add_side(cells, r.other, r.other_reason, r.other_count);
    add_ratio(cells, r.ratio());
    for (const auto& offer : r.everyday)
      add_ratio(cells, offer && r.other ? std::optional(offer->cost / r.other->cost) : std::nullopt);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

bool compares_codes(const std::vector<ProblemCurves>& problems) {
  return std::any_of(problems.begin(), problems.end(), [](const ProblemCurves& p) {
    return p.timed && !side_of(p, true).curves.empty() && !side_of(p, false).curves.empty();
  });
}

}  // namespace odemark
