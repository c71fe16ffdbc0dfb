#include "bench/step_record.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "integrators/any_method.hpp"

namespace odemark {

namespace {

const AnyMethod& judge() {
  const auto& all = suite_methods();
  return *std::find_if(all.begin(), all.end(), [](const AnyMethod& m) { return m.id == "taylor20"; });
}

std::vector<std::size_t> evenly(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t taken = std::min(count, most);
  for (std::size_t i = 0; i < taken; ++i) chosen.push_back(i * count / taken);
  return chosen;
}

}  // namespace

StepRecord::StepRecord(const AnyProblem& problem, const std::vector<long double>& initial)
    : problem_(problem), times_{problem.t_begin}, states_(initial) {}

void StepRecord::add(long double t, const std::vector<long double>& y) {
  if (times_.size() > most_steps) return;
  times_.push_back(t);
  states_.insert(states_.end(), y.begin(), y.end());
}

RowSteps StepRecord::history(std::size_t most) const {
  RowSteps steps;
  for (const std::size_t i : evenly(times_.size() - 1, most)) {
    steps.time.push_back(double(times_[i]));
    steps.step.push_back(double(times_[i + 1] - times_[i]));
  }
  return steps;
}

RowLocal StepRecord::local_errors(const ErrorControl& control, std::size_t most) const {
  RowLocal local;
  const std::size_t n = problem_.size();
  if (!(problem_.abilities & Ability::recordable)) return local;
  const auto system = problem_.system<long double>();
  const auto solve = [&](std::size_t i, long parts) -> std::optional<std::vector<long double>> {
    std::vector<long double> y(states_.begin() + std::ptrdiff_t(i * n),
                               states_.begin() + std::ptrdiff_t((i + 1) * n));
    const auto report = judge().runs<long double>().solve(system, FixedSteps{parts}, double(times_[i]),
                                                          double(times_[i + 1]), y);
    if (report.status != RunStatus::reached_end) return std::nullopt;
    return y;
  };
  for (const std::size_t i : evenly(times_.size() - 1, most)) {
    const auto rough = solve(i, 4), fine = solve(i, 8);
    if (!rough || !fine) continue;
    const std::span<const long double> before(&states_[i * n], n), after(&states_[(i + 1) * n], n);
    double error = 0, doubt = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const double weight =
          error_weight(control, k, double(std::max(std::abs(before[k]), std::abs(after[k]))));
      const double e = double(after[k] - (*fine)[k]) / weight, d = double((*rough)[k] - (*fine)[k]) / weight;
      error += e * e, doubt += d * d;
    }
    error = std::sqrt(error / double(n)), doubt = std::sqrt(doubt / double(n));
    if (!(doubt <= 1e-3) || !std::isfinite(error)) continue;
    ++local.judged;
    local.deceived += error > 1;
    local.worst = std::max(local.worst, error);
  }
  return local;
}

}  // namespace odemark
