// Where a curve crosses an error for good, and what that costs.
#include "reports/cheapest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/format.hpp"

namespace odemark {
namespace {

double between(double at_high, double at_low, double share) {
  return std::exp(std::log(at_high) + share * (std::log(at_low) - std::log(at_high)));
}

bool good(const CurvePoint& p, double error) { return !p.failed && p.error <= error; }

std::string second_text(const std::vector<Offer>& offers) {
  if (offers.size() < 2) return std::string(no_value);
  const double ratio = offers[1].cost / offers[0].cost;
  return fmt::format("{} × {}", offers[1].label,
                     ratio < 100 ? compact(ratio, 3) : fmt::format("{:.0f}", ratio));
}

std::vector<Cell> line(const ProblemCurves& problem, double error, Cost cost) {
  std::vector<Cell> cells{{problem.problem}, {target_text(error), Status::plain, error}};
  const auto offers = cheapest(problem, error, cost);
  if (offers.empty()) {
    const bool untimed = cost == Cost::time && !problem.timed;
    cells.push_back({untimed ? "not timed" : "no method gets there", Status::muted});
    return cells;
  }
  const Offer& first = offers[0];
  cells.push_back({first.label, Status::ok});
  cells.push_back({(first.at_most ? "≤ " : "") + cost_text(first, cost), Status::plain, rounded(first.cost)});
  cells.push_back({control_text(first), Status::plain, rounded(first.control)});
  cells.push_back({second_text(offers), offers.size() < 2 ? Status::muted : Status::plain});
  return cells;
}

}  // namespace

std::optional<Offer> offer_of(const WorkCurve& curve, double error, Cost cost) {
  const auto& points = curve.points;
  std::size_t least = points.size();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (good(points[i], error) && (least == points.size() || points[i].error < points[least].error))
      least = i;
  if (least == points.size() || !(error >= points[least].floor)) return std::nullopt;
  std::size_t first = least;  // of the unbroken stretch of good runs around the best one
  while (first > 0 && good(points[first - 1], error)) --first;
  const CurvePoint& fine = points[first];
  if (!(fine.cost(cost) > 0)) return std::nullopt;
  Offer offer{curve.label, curve.method, fine.tier, curve.adaptive, fine.cost(cost), fine.control, true};
  if (first == 0) return offer;
  const CurvePoint& coarse = points[first - 1];
  if (!(coarse.error > error) || !(coarse.cost(cost) > 0) || !(fine.error > 0)) return offer;
  const double share = std::log(coarse.error / error) / std::log(coarse.error / fine.error);
  offer.cost = between(coarse.cost(cost), fine.cost(cost), share);
  offer.control = between(coarse.control, fine.control, share);
  offer.at_most = false;
  return offer;
}

std::vector<Offer> cheapest(const ProblemCurves& problem, double error, Cost cost) {
  std::vector<Offer> offers;
  for (const WorkCurve& curve : problem.curves)
    if (auto offer = offer_of(curve, error, cost)) offers.push_back(std::move(*offer));
  std::stable_sort(offers.begin(), offers.end(),
                   [](const Offer& a, const Offer& b) { return a.cost < b.cost; });
  std::set<std::string> seen;
  std::vector<Offer> once;
  for (Offer& offer : offers)
    if (seen.insert(offer.method).second) once.push_back(std::move(offer));
  return once;
}

std::string control_text(const Offer& offer) {
  return fmt::format("{} {}", offer.adaptive ? "tol" : "dt", compact(offer.control, 2));
}

std::string cost_text(const Offer& offer, Cost cost) {
  if (cost == Cost::time) return duration(offer.cost * 1e-9, 3);
  return fmt::format("{:.0f}", std::ceil(offer.cost));
}

std::string target_text(double error) {
  return power_of_ten(static_cast<int>(std::lround(std::log10(error))));
}

Table cheapest_table(const std::vector<ProblemCurves>& problems, Cost cost) {
  const bool time = cost == Cost::time;
  Table table{time ? "cheapest-time" : "cheapest-evaluations",
              time ? "Least time for an error" : "Fewest evaluations for an error",
              "",
              {{"problem"},
               {"error", Align::right},
               {time ? "least time" : "fewest evaluations"},
               {time ? "per simulated second" : "evaluations", Align::right},
               {"with"},
               {time ? "second, times as long" : "second, times as many"}},
              {}};
  if (!time)
    table.note =
        "Interpolated between neighbouring runs of a method on logarithmic axes, never extrapolated. ≤: the "
        "coarsest run that worked is already this good. A method counts from the run on from which every "
        "finer "
        "one stays below the error, so a lucky crossing wins nothing.";
  for (const ProblemCurves& problem : problems)
    for (const double error : target_errors) table.rows.push_back(line(problem, error, cost));
  return table;
}

}  // namespace odemark
