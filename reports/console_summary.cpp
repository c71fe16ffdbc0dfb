// The console table of `odemark run`.
#include "reports/console_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "reports/cheapest.hpp"
#include "reports/convergence.hpp"
#include "reports/failures.hpp"
#include "reports/format.hpp"
#include "reports/observed_order.hpp"
#include "reports/speed_ratio.hpp"
#include "reports/stability_page.hpp"
#include "reports/table.hpp"
#include "reports/work_curves.hpp"

namespace odemark {

namespace {

constexpr std::size_t most_lines = 10;
constexpr double target = 1e-6;

/// One method per problem: in turn the cheapest to 1e-6 that has fixed steps, and the methods everybody
/// knows.
const WorkCurve* choose(const ProblemCurves& problem, std::size_t turn) {
  constexpr std::string_view known[] = {"rk4", "explicit_euler", "heun", "semi_implicit_euler"};
  if (turn % 2 == 1)
    for (std::size_t i = 0; i < std::size(known); ++i)
      for (const WorkCurve& curve : problem.curves)
        if (!curve.adaptive && curve.method == known[(turn / 2 + i) % std::size(known)]) return &curve;
  for (const Offer& offer : cheapest(problem, target, problem.timed ? Cost::time : Cost::evaluations))
    for (const WorkCurve& curve : problem.curves)
      if (curve.label == offer.label) return &curve;
  return problem.curves.empty() ? nullptr : &problem.curves.front();
}

std::string error_text(const WorkCurve& curve, std::size_t index) {
  if (index >= curve.points.size()) return "";
  const CurvePoint& p = curve.points[index];
  const std::string error = p.failed                 ? p.status
                            : std::isfinite(p.error) ? scientific(p.error, 2)
                                                     : std::string("no truth");
  return fmt::format("{} at {} {}", error, curve.adaptive ? "tol" : "dt", compact(p.control, 2));
}

std::string order_text(const WorkCurve& curve, const std::vector<ObservedOrder>& orders) {
  if (curve.adaptive) return "chooses its own steps";
  for (const ObservedOrder& order : orders)
    if (order.id.problem == curve.problem && order.id.method == curve.method)
      return order.slope
                 ? fmt::format("{:.2f} ({}) {}", *order.slope, order.claimed, to_string(order.verdict))
                 : fmt::format("– ({}) {}", order.claimed, to_string(order.verdict));
  return "";
}

void add_line(Table& table, const ProblemCurves& problem, const WorkCurve& curve,
              const std::vector<ObservedOrder>& orders) {
  const Cost cost = problem.timed ? Cost::time : Cost::evaluations;
  const auto offer = offer_of(curve, target, cost);
  const std::size_t finest = curve.points.size() - 1;
  table.rows.push_back(
      {{problem.problem},
       {curve.label},
       {error_text(curve, finest / 3)},
       {finest > finest / 3 ? error_text(curve, finest - finest / 3) : ""},
       {order_text(curve, orders)},
       {offer ? (offer->at_most ? "≤ " : "") + cost_text(*offer, cost) : std::string(no_value)}});
}

std::string counts(const std::vector<Row>& rows, const std::vector<StabilityRow>& stability,
                   const std::vector<ObservedOrder>& orders) {
  const OrderCounts c = count_orders(orders);
  std::string text = fmt::format("orders: {} hold, {} fail, {} exceed, {} inconclusive", c.holds, c.fails,
                                 c.exceeds, c.inconclusive);
  if (!stability.empty()) {
    const StabilityCounts s = count_stability(stability);
    text += fmt::format("; stability: {} limits agree with theory, {} differ", s.agrees, s.differs);
  }
  const auto failures = failures_by_status(rows);
  const int failed = std::accumulate(failures.begin(), failures.end(), 0,
                                     [](int sum, const auto& entry) { return sum + entry.second; });
  const auto made =
      std::count_if(rows.begin(), rows.end(), [](const Row& r) { return r.status != "not_applicable"; });
  text += fmt::format("\n{} of {} runs reached the end", made - failed, made);
  std::string why;
  for (const auto& [status, count] : failures)
    why += fmt::format("{}{} {}", why.empty() ? "" : ", ", count, status);
  return text + (why.empty() ? "\n" : fmt::format("; {}\n", why));
}

/// The suite that compares codes at their tolerances answers with its ratios.
std::optional<std::string> ratio_text(const std::vector<Row>& rows,
                                      const std::vector<ProblemCurves>& problems) {
  const bool adaptive_only = std::all_of(rows.begin(), rows.end(), [](const Row& r) { return r.rtol; });
  if (!adaptive_only || !compares_codes(problems)) return std::nullopt;
  return "\n" + to_text(speed_ratio_table(speed_ratios(problems))) + "\n";
}

}  // namespace

std::string console_summary(const std::vector<Row>& all_rows, const std::vector<StabilityRow>& stability) {
  const auto rows = main_rows(all_rows);
  const auto problems = work_curves(rows);
  const auto orders = observed_orders(rows);
  Table table{"", "", "", {}, {}};
  const bool timed = std::any_of(problems.begin(), problems.end(), [](const auto& p) { return p.timed; });
  table.columns = {
      {"problem"},         {"method"},
      {"error"},           {"error, smaller steps"},
      {"order (claimed)"}, {timed ? "time to 1e-6 per simulated s" : "evaluations to 1e-6", Align::right}};
  for (std::size_t i = 0; i < problems.size() && table.rows.size() < most_lines; ++i) {
    const bool few = problems.size() * 2 <= most_lines;
    const WorkCurve* first = choose(problems[i], few ? 0 : i);
    if (first) add_line(table, problems[i], *first, orders);
    const WorkCurve* second = few ? choose(problems[i], 2 * i + 1) : nullptr;
    if (second && second != first) add_line(table, problems[i], *second, orders);
  }
  std::string text = table.rows.empty() ? "" : to_text(table) + "\n";
  if (problems.size() > most_lines)
    text += fmt::format("{} more problems are in the report\n", problems.size() - most_lines);
  if (const auto ratios = ratio_text(rows, problems)) text += *ratios;
  return text + counts(all_rows, stability, orders);
}

}  // namespace odemark
