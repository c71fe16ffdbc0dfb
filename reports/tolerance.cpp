// Least squares on logarithms, and what the rows count.
#include "reports/tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "reports/format.hpp"
#include "reports/observed_order.hpp"
#include "reports/shown_error.hpp"

namespace odemark {
namespace {

/// The estimate is of order min(order, embedded) + 1 in h and the end's error of the method's order.
std::optional<double> slope_in_theory(const Row& row) {
  if (row.embedded_order <= 0 || row.order <= 0) return std::nullopt;
  return double(row.order) / (std::min(row.order, row.embedded_order) + 1);
}

std::optional<double> slope_of(const std::vector<Calibration::Point>& points, double floor) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& p : points) {
    // looser tolerances do not control an error of the size of the solution; tighter ones meet round-off
    if (!(p.achieved > 20 * floor) || !(p.achieved < 0.1)) continue;
    const double u = std::log(p.requested), v = std::log(p.achieved);
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  if (n < 3) return std::nullopt;
  return (n * xy - x * y) / (n * xx - x * x);
}

std::string share(double part) { return fmt::format("{:.1f} %", 100 * part); }

}  // namespace

double Calibration::rejected_share() const {
  const long tried = accepted + rejected;
  return tried > 0 ? double(rejected) / double(tried) : 0;
}
double Calibration::least_ratio() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Point& p : points) least = std::min(least, p.achieved / p.requested);
  return least;
}
double Calibration::most_ratio() const {
  double most = 0;
  for (const Point& p : points) most = std::max(most, p.achieved / p.requested);
  return most;
}

std::vector<Calibration> calibrations(const std::vector<Row>& rows) {
  std::vector<Calibration> codes;
  std::vector<double> floors;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> at;
  for (const Row& row : rows) {
    if (!row.rtol || row.status == "not_applicable") continue;
    const auto [found, is_new] = at.emplace(std::tuple{row.problem, row.method, row.filter}, codes.size());
    if (is_new) {
      codes.emplace_back();
      floors.push_back(0);
      codes.back().problem = row.problem, codes.back().method = row.method;
      codes.back().provider = row.provider, codes.back().filter = row.filter;
      codes.back().expected_slope = slope_in_theory(row);
    }
    Calibration& code = codes[found->second];
    floors[found->second] =
        std::max({floors[found->second], row.truth_floor, row.sensitivity, unit_roundoff(row.scalar)});
    if (row.status != "reached_end") {
      code.failures.push_back(row.status);
      continue;
    }
    code.accepted += row.accepted, code.rejected += row.rejected;
    if (row.local) {
      code.judged += row.local->judged, code.deceived += row.local->deceived;
      code.worst_deception = std::max(code.worst_deception, row.local->worst);
    }
    if (row.errors) code.points.push_back({*row.rtol, shown_error(row)});
  }
  for (std::size_t i = 0; i < codes.size(); ++i) {
    auto& points = codes[i].points;
    std::stable_sort(points.begin(), points.end(),
                     [](const auto& a, const auto& b) { return a.requested > b.requested; });
    codes[i].slope = slope_of(points, floors[i]);
  }
  return codes;
}

Table calibration_table(const std::vector<Calibration>& codes) {
  Table table{
      "calibration",
      "What a tolerance means",
      "Scaled error at the end over the tolerance, smallest and largest over the runs that reached the end. "
      "Slope: of log error over log tolerance, between 0.1 and twenty times round-off; in theory order / "
      "order of the estimate. Deceived: accepted steps whose true error against the exact solution through "
      "their own start is above the tolerance, and the worst of them in tolerances; judged for our own "
      "methods where that local solution is known.",
      {{"problem"},
       {"code"},
       {"least", Align::right},
       {"most", Align::right},
       {"slope", Align::right},
       {"in theory", Align::right},
       {"rejected", Align::right},
       {"deceived", Align::right},
       {"worst", Align::right},
       {"failed", Align::right}},
      {}};
  const Cell blank{std::string(no_value), Status::muted};
  for (const Calibration& code : codes) {
    std::vector<Cell> cells{{code.problem}, {code.method}};
    if (code.points.empty()) {
      cells.insert(cells.end(), 2, blank);
    } else {
      cells.push_back(number_cell(code.least_ratio(), compact(code.least_ratio(), 2)));
      cells.push_back(number_cell(code.most_ratio(), compact(code.most_ratio(), 2)));
    }
    for (const auto& slope : {code.slope, code.expected_slope})
      cells.push_back(slope ? Cell{fmt::format("{:.2f}", *slope), Status::plain, *slope} : blank);
    cells.push_back({share(code.rejected_share()), Status::plain, code.rejected_share()});
    if (code.judged > 0) {
      const double deceived = double(code.deceived) / double(code.judged);
      cells.push_back({share(deceived), Status::plain, deceived});
      cells.push_back(number_cell(code.worst_deception, compact(code.worst_deception, 2)));
    } else {
      cells.insert(cells.end(), 2, blank);
    }
    cells.push_back(
        {code.failures.empty() ? "" : fmt::format("{} {}", code.failures.size(), code.failures[0])});
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace odemark
