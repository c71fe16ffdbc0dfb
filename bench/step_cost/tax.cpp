#include "bench/step_cost/tax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

namespace odemark {

namespace {

double median(std::vector<double> v) {
  if (v.empty()) return 0;
  const auto middle = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2);
  std::nth_element(v.begin(), middle, v.end());
  return *middle;
}

double ns_per_step(const std::function<double(long)>& loop, long steps, double& result) {
  const auto begin = std::chrono::steady_clock::now();
  result = loop(steps);
  return 1e9 * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() /
         double(steps);
}

}  // namespace

std::vector<TaxResult> measure_tax(const std::vector<TaxCell>& cells, int rounds, long steps) {
  std::mt19937 shuffle(12345);
  std::vector<TaxResult> results;
  for (const auto& cell : cells) {
    std::vector<double> times[3], over_hand, over_odeint;
    double ends[3] = {};
    const std::function<double(long)>* loops[3] = {&cell.hand, &cell.engine, &cell.odeint};
    for (int round = -1; round < rounds; ++round) {  // the first one warms up
      std::array<std::size_t, 3> order{0, 1, 2};
      std::shuffle(order.begin(), order.end(), shuffle);
      double now[3] = {};
      for (const std::size_t which : order)
        if (*loops[which]) now[which] = ns_per_step(*loops[which], steps, ends[which]);
      if (round < 0) continue;
      for (std::size_t which = 0; which < 3; ++which)
        if (*loops[which]) times[which].push_back(now[which]);
      over_hand.push_back(now[1] / now[0]);
      if (now[2] > 0) over_odeint.push_back(now[1] / now[2]);
    }
    TaxResult r{cell.problem,     cell.method,       median(times[0]),   median(times[1]),
                median(times[2]), median(over_hand), median(over_odeint)};
    r.same_result = std::abs(ends[0] - ends[1]) <= 1e-6 * (1 + std::abs(ends[0]));
    results.push_back(r);
  }
  return results;
}

std::vector<std::string> tax_faults(const std::vector<TaxResult>& results) {
  std::vector<std::string> faults;
  for (const auto& r : results) {
    if (!r.same_result)
      faults.push_back(
          fmt::format("{}/{}: hand loop and engine end in different places", r.problem, r.method));
    if (!(r.engine_over_hand <= 1.10))
      faults.push_back(fmt::format("{}/{}: {:.2f} of the hand-written loop, goal 1.10", r.problem, r.method,
                                   r.engine_over_hand));
    if (r.odeint_ns > 0 && !(r.engine_over_odeint <= 1.03))
      faults.push_back(fmt::format("{}/{}: {:.2f} of Boost.odeint's array stepper, goal 1.03", r.problem,
                                   r.method, r.engine_over_odeint));
  }
  return faults;
}

std::string tax_table(const std::vector<TaxResult>& results) {
  std::string text = fmt::format("{:<14} {:<18} {:>9} {:>9} {:>9} {:>12} {:>14}\n", "problem", "method",
                                 "hand ns", "engine ns", "odeint ns", "engine/hand", "engine/odeint");
  for (const auto& r : results)
    text +=
        fmt::format("{:<14} {:<18} {:>9.2f} {:>9.2f} {:>9} {:>12.3f} {:>14}\n", r.problem, r.method,
                    r.hand_ns, r.engine_ns, r.odeint_ns > 0 ? fmt::format("{:.2f}", r.odeint_ns) : "-",
                    r.engine_over_hand, r.odeint_ns > 0 ? fmt::format("{:.3f}", r.engine_over_odeint) : "-");
  return text;
}

}  // namespace odemark
