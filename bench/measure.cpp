#include "bench/measure.hpp"

#include <cmath>

namespace odemark {

namespace {

/// The larger of two deviations; NaN counts as the worst of all (std::max would drop it).
double worse_of(double a, double b) { return a >= b || std::isnan(a) ? a : b; }

}  // namespace

RowErrors errors_at_end(const AnyProblem& problem, const Truth& truth, const std::vector<long double>& y) {
  RowErrors errors;
  const auto& values = truth.last().values;
  double squares = 0;
  bool has_relative = true;
  double left = 0;
  double relative = 0;
  for (std::size_t p = 0; p < values.size(); ++p) {
    const std::size_t i = truth.places.empty() ? p : truth.places[p];
    const long double gap = std::abs(difference(y[i], values[p]));
    const double scaled = double(gap / static_cast<long double>(problem.scale[i]));
    errors.absolute = worse_of(errors.absolute, double(gap));
    errors.scaled = worse_of(errors.scaled, scaled);
    squares += scaled * scaled;
    const long double size = std::abs(values[p].hi);
    left = worse_of(left, double(size / static_cast<long double>(problem.scale[i])));
    if (size > 0)
      relative = worse_of(relative, double(gap / size));
    else
      has_relative = false;
  }
  errors.rms = std::sqrt(squares / double(values.size()));
  if (has_relative) errors.relative = relative;
  if (left < next_to_nothing) errors.left = left;
  return errors;
}

void add_trajectory_errors(RowErrors& errors, const AnyProblem& problem, const Truth& truth,
                           const std::vector<long double>& samples) {
  const std::size_t size = problem.size();
  double worst = 0, squares = 0;
  for (std::size_t p = 0; p < truth.points.size(); ++p)
    for (std::size_t i = 0; i < size; ++i) {
      const long double gap = difference(samples[p * size + i], truth.points[p].values[i]);
      const double scaled = double(std::abs(gap) / static_cast<long double>(problem.scale[i]));
      if (std::isnan(scaled)) return;
      worst = worse_of(worst, scaled);
      squares += scaled * scaled;
    }
  errors.trajectory_max = worst;
  errors.trajectory_rms = std::sqrt(squares / double(truth.points.size() * size));
}

Watch::Watch(const AnyProblem& problem, double time_limit_seconds)
    : problem_(problem),
      initial_(problem.invariant_names.size()),
      now_(initial_),
      worst_(initial_.size(), 0),
      deadline_(std::chrono::steady_clock::now() +
                std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                    std::chrono::duration<double>(time_limit_seconds))) {
  const std::vector<long double> y(problem.initial.begin(), problem.initial.end());
  if (problem.invariants_call) problem.invariants_call(problem.value.get(), y.data(), initial_.data());
  if (problem.oscillation_call)
    oscillation_ = problem.oscillation_call(problem.value.get(), problem.initial.data());
}

bool Watch::operator()(const std::vector<long double>& y) {
  if (problem_.invariants_call) {
    problem_.invariants_call(problem_.value.get(), y.data(), now_.data());
    for (std::size_t i = 0; i < now_.size(); ++i)
      worst_[i] = worse_of(double(std::abs(now_[i] - initial_[i])), worst_[i]);
  }
  if (problem_.oscillation_call) {
    const std::vector<double> rounded(y.begin(), y.end());
    Oscillation next = problem_.oscillation_call(problem_.value.get(), rounded.data());
    // unwrapped: each step is the turn nearest to none, which holds below half a turn a step
    next.phase = oscillation_->phase + std::remainder(next.phase - oscillation_->phase, 2 * std::acos(-1.0));
    oscillation_ = next;
  }
  // asking the clock is nothing beside a step of a large problem
  return (!problem_.is_large() && (++calls_ & 255) != 0) || std::chrono::steady_clock::now() < deadline_;
}

void Watch::fill(Row& row) const {
  for (std::size_t i = 0; i < worst_.size(); ++i) {
    const double start = double(std::abs(initial_[i]));
    row.drift[std::string(problem_.invariant_names[i])] = start > 0 ? worst_[i] / start : worst_[i];
  }
}

std::optional<Oscillation> Watch::oscillation() const { return oscillation_; }

}  // namespace odemark
