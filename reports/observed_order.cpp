// Local slopes, the asymptotic window among them, least squares inside it, and the departure below it.
#include "reports/observed_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string_view>

#include "reports/format.hpp"
#include "reports/shown_error.hpp"

namespace odemark {
namespace {

bool is_usable(const Rung& rung, const OrderOptions& options) {
  return rung.error >= options.floor_factor * rung.floor && rung.error <= options.largest_error;
}

double error_of_run(const Row& row) { return row.status == "reached_end" ? shown_error(row) : absent; }

void add_rungs(ObservedOrder& order, const std::vector<Row>& curve, const OrderOptions& options) {
  std::map<double, const Row*, std::greater<>> by_dt;
  for (const Row& row : curve)
    if (row.steps && row.dt && *row.dt > 0 && std::isfinite(*row.dt) && row.status != "not_applicable")
      by_dt.emplace(*row.dt, &row);
  for (const auto& [dt, row] : by_dt) {
    const double error = error_of_run(*row);
    if (!std::isfinite(error) || error < 0) {
      ++order.gaps;
      continue;
    }
    Rung rung{dt, error};
    rung.floor = 8 * unit_roundoff(row->scalar);
    for (const double bound : {row->truth_floor, row->sensitivity})
      if (!(bound <= rung.floor)) rung.floor = bound;  // an unknown bound hides everything
    rung.usable = is_usable(rung, options);
    order.usable += rung.usable;
    order.rungs.push_back(rung);
  }
}

double local_slope(const Rung& coarse, const Rung& fine) {
  return std::log(coarse.error / fine.error) / std::log(coarse.dt / fine.dt);
}

struct Window {
  std::size_t first = 0, count = 0;  // rungs
};

constexpr double least_slope = 0.25;  // flatter, or rising as dt falls, is round-off and no convergence

/// The longest run of usable rungs whose neighbouring slopes agree; of equal ones that of the smallest dt.
Window find_window(const std::vector<Rung>& rungs, const OrderOptions& options) {
  Window best;
  for (std::size_t first = 0; first < rungs.size(); ++first) {
    std::size_t end = first;
    while (end < rungs.size() && rungs[end].usable) {
      if (end > first && !(local_slope(rungs[end - 1], rungs[end]) >= least_slope)) break;
      if (end >= first + 2 && !(std::abs(local_slope(rungs[end - 2], rungs[end - 1]) -
                                         local_slope(rungs[end - 1], rungs[end])) <= options.slope_scatter))
        break;
      ++end;
    }
    if (end - first >= best.count && end > first) best = {first, end - first};
  }
  return best;
}

void fit(ObservedOrder& order, const Window& window) {
  const auto n = static_cast<double>(window.count);
  const auto begin = order.rungs.begin() + static_cast<std::ptrdiff_t>(window.first);
  const auto end = begin + static_cast<std::ptrdiff_t>(window.count);
  double x_mean = 0, y_mean = 0;
  for (auto r = begin; r != end; ++r) x_mean += std::log(r->dt) / n, y_mean += std::log(r->error) / n;
  double xx = 0, xy = 0;
  for (auto r = begin; r != end; ++r) {
    const double x = std::log(r->dt) - x_mean;
    xx += x * x, xy += x * (std::log(r->error) - y_mean);
  }
  const double slope = xy / xx;
  double residual = 0;
  for (auto r = begin; r != end; ++r) {
    const double off = std::log(r->error) - y_mean - slope * (std::log(r->dt) - x_mean);
    residual += off * off;
  }
  order.slope = slope;
  order.standard_error = std::sqrt(residual / (n - 2) / xx);
  order.log_error_at_1 = y_mean - slope * x_mean;
  order.points = static_cast<int>(window.count);
  order.dt_max = begin->dt, order.dt_min = std::prev(end)->dt;
}

/// Whether the local slopes of the window still move towards the claimed order as dt falls.
bool approaches(const ObservedOrder& order, const Window& window) {
  const auto& rungs = order.rungs;
  const std::size_t last = window.first + window.count - 1;
  const double coarse = local_slope(rungs[window.first], rungs[window.first + 1]);
  const double fine = local_slope(rungs[last - 1], rungs[last]);
  return std::abs(fine - order.claimed) < std::abs(coarse - order.claimed) - 0.05;
}

std::string why_inconclusive(const ObservedOrder& order, double largest_error) {
  const std::string gaps = order.gaps ? fmt::format(", {} runs gave no error", order.gaps) : "";
  if (order.usable >= 3)
    return fmt::format("on no part of the ladder does the error fall with neighbouring slopes that agree{}",
                       gaps);
  const auto above = std::count_if(order.rungs.begin(), order.rungs.end(),
                                   [&](const Rung& r) { return !r.usable && r.error > largest_error; });
  const auto below = static_cast<long>(order.rungs.size()) - order.usable - above;
  return fmt::format("not measurable in {}: {} usable rungs ({} too close to round-off, {} too large{})",
                     order.id.scalar, order.usable, below, above, gaps);
}

}  // namespace

double unit_roundoff(std::string_view scalar) {
  if (scalar == "float") return std::ldexp(1.0, -24);
  if (scalar == "long_double") return std::ldexp(1.0, -std::numeric_limits<long double>::digits);
  return std::ldexp(1.0, -53);
}

std::string case_name(const CurveId& id) {
  std::string name = id.problem + "/" + id.method;
  if (id.compensated) return name + " [" + id.scalar + ", compensated]";
  return id.scalar == "double" ? name : name + " [" + id.scalar + "]";
}

CurveId curve_of(const Row& row) { return {row.problem, row.method, row.scalar, row.compensated}; }

ObservedOrder observed_order(const std::vector<Row>& curve, const OrderOptions& options) {
  ObservedOrder order;
  if (curve.empty()) {
    order.reason = "no runs";
    return order;
  }
  order.id = curve_of(curve.front());
  const Row& first = curve.front();
  order.stated = first.order, order.because = first.expected_because;
  order.claimed = first.expected_order.value_or(first.order);
  add_rungs(order, curve, options);
  const Window window = find_window(order.rungs, options);
  const auto wished = static_cast<std::size_t>(std::max(options.least_slopes, 2)) + 1;
  const std::size_t needed = order.usable == 3 ? 3 : wished;
  if (order.usable < 3 || window.count < needed) {
    order.reason = why_inconclusive(order, options.largest_error);
    return order;
  }
  fit(order, window);
  if (first.expected_order == 0) {
    order.reason = fmt::format("no order is to be expected: {}", order.because);
    return order;
  }
  order.verdict = judge_order(*order.slope, order.claimed, options.slack);
  const bool moving = approaches(order, window);
  if (order.verdict == OrderVerdict::fails)
    order.reason = moving ? "below the claimed order, still rising as dt falls" : "below the claimed order";
  if (order.verdict == OrderVerdict::exceeds)
    order.reason = moving ? "above the claimed order, still falling as dt falls: pre-asymptotic"
                          : "above the claimed order: superconvergent here, look at the end point";
  return order;
}

RoundoffOnset roundoff_onset(const ObservedOrder& order) {
  RoundoffOnset onset;
  onset.id = order.id;
  if (order.rungs.empty()) {
    onset.reason = "no run gave an error";
    return onset;
  }
  const auto least = std::min_element(order.rungs.begin(), order.rungs.end(),
                                      [](const Rung& a, const Rung& b) { return a.error < b.error; });
  onset.error_minimum = least->error, onset.dt_at_minimum = least->dt;
  onset.beyond_ladder = std::next(least) == order.rungs.end();
  if (!order.slope) {
    if (!onset.beyond_ladder) onset.dt = least->dt;
    onset.reason = onset.dt ? "the dt of the smallest error: no order line to depart from"
                            : "smaller steps still help at the end of the ladder";
    return onset;
  }
  double last_dt = *order.dt_min, last_excess = 0;  // ln(error / line)
  for (const Rung& rung : order.rungs) {
    if (rung.dt >= *order.dt_min || !(rung.error > 0)) continue;
    const double excess = std::log(rung.error) - order.log_error_at_1 - *order.slope * std::log(rung.dt);
    if (excess >= std::log(2.0)) {
      const double share = std::clamp((std::log(2.0) - last_excess) / (excess - last_excess), 0.0, 1.0);
      onset.dt = last_dt * std::pow(rung.dt / last_dt, share);
      return onset;
    }
    last_dt = rung.dt, last_excess = excess;
  }
  onset.reason = "the error follows its order line to the end of the ladder";
  return onset;
}

std::vector<ObservedOrder> observed_orders(const std::vector<Row>& rows, const OrderOptions& options) {
  std::vector<std::vector<Row>> curves;
  std::map<CurveId, std::size_t> index;
  for (const Row& row : rows) {
    if (!row.steps || row.status == "not_applicable") continue;
    const auto [at, is_new] = index.emplace(curve_of(row), curves.size());
    if (is_new) curves.emplace_back();
    curves[at->second].push_back(row);
  }
  std::vector<ObservedOrder> orders;
  for (const auto& curve : curves) orders.push_back(observed_order(curve, options));
  return orders;
}

}  // namespace odemark
