#include "reference/truth_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "reference/bad_input.hpp"
#include "reference/collocation_truth.hpp"
#include "reference/extrapolation_truth.hpp"
#include "reference/taylor_truth.hpp"

namespace odemark {

namespace {

constexpr std::array<std::string_view, 5> names{"closed_form", "taylor", "extrapolation", "radau", "lobatto"};

/// |J^32|^(1/32) in the largest-row-sum norm: close enough to the spectral radius, blind to units.
double spectral_radius(std::vector<double> matrix, std::size_t n) {
  double log2_size = 0, power = 1;
  for (int squaring = 0;; ++squaring) {
    double norm = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double row = 0;
      for (std::size_t j = 0; j < n; ++j) row += std::abs(matrix[j * n + i]);
      norm = std::max(norm, row);
    }
    if (!(norm > 0) || !std::isfinite(norm)) return 0;
    log2_size += std::log2(norm) / power;
    if (squaring == 5) return std::exp2(log2_size);
    for (double& entry : matrix) entry /= norm;
    std::vector<double> square(n * n, 0.0);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = 0; i < n; ++i) square[j * n + i] += matrix[k * n + i] * matrix[j * n + k];
    matrix = std::move(square);
    power *= 2;
  }
}

double spectral_radius(const WideSystem& system, const Wide& t, const std::vector<Wide>& y) {
  const std::size_t n = y.size();
  std::vector<Wide> jacobian(n * n);
  system.jacobian(t, y.data(), jacobian.data());
  std::vector<double> matrix;
  for (const Wide& entry : jacobian) matrix.push_back(static_cast<double>(entry));
  return spectral_radius(std::move(matrix), n);
}

}  // namespace

TruthOrigin truth_origin(std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw BadInput("there is no way \"" + std::string(name) + "\" to a truth" +
                   suggestion(name, {names.begin(), names.end()}));
  return TruthOrigin(found - names.begin());
}

std::unique_ptr<TruthSolver> make_truth_solver(TruthOrigin origin, double exponent,
                                               const std::vector<double>& scale) {
  RunTolerance tolerance{exponent, scale};
  switch (origin) {
    case TruthOrigin::taylor: return std::make_unique<TaylorTruth>(std::move(tolerance));
    case TruthOrigin::extrapolation: return std::make_unique<ExtrapolationTruth>(std::move(tolerance));
    case TruthOrigin::radau:
      return std::make_unique<CollocationTruth>(CollocationTruth::Kind::radau, std::move(tolerance));
    case TruthOrigin::lobatto:
      return std::make_unique<CollocationTruth>(CollocationTruth::Kind::lobatto, std::move(tolerance));
    case TruthOrigin::closed_form: break;
  }
  throw std::logic_error("a closed form is no solver");
}

Workload survey(const WideProblem& problem, const Wide& end, const std::vector<double>& scale) {
  Workload work;
  for (const auto& entry : problem.phases.front().tape.entries) {
    work.entries += 1;
    work.evaluation += entry.op == TapeOp::square_root                                  ? 10
                       : entry.op > TapeOp::square_root && entry.op != TapeOp::absolute ? 100
                                                                                        : 1;
    if (entry.op >= TapeOp::multiply && entry.op != TapeOp::negate) work.products += 1;
    if (entry.op == TapeOp::absolute) work.kinks = true;
  }
  CollocationTruth scout(CollocationTruth::Kind::radau, {-5, scale}, 5);
  constexpr long limit = 1500;
  RunBudget budget;
  budget.steps_left = limit;
  Wide t = 0;
  std::vector<Wide> y = problem.initial;
  std::size_t phase = 0;
  try {
    while (t < end) {
      while (phase < problem.switch_times.size() && problem.switch_times[phase] <= t) ++phase;
      const WideSystem system{&problem, &problem.phases[phase]};
      scout.enter(system);
      const bool switching = phase < problem.switch_times.size() && problem.switch_times[phase] < end;
      const Wide stop = switching ? problem.switch_times[phase] : end;
      while (t < stop) {
        const double radius = spectral_radius(system, t, y);
        const Wide before = t;
        scout.attempt(t, y, stop, budget);
        const double after = t > before ? spectral_radius(system, t, y) : radius;
        work.stiffness += (radius + after) / 2 * static_cast<double>(Wide(t - before));
      }
    }
  } catch (const RunFailed&) {
    // too long, or a kink in its way: what was seen is taken for the rest
  }
  work.steps = double(limit - std::max(0L, budget.steps_left));
  if (t > 0 && t < end) {
    const double rest = static_cast<double>(Wide(end / t));
    work.steps *= rest, work.stiffness *= rest;
  }
  return work;
}

double expected_seconds(TruthOrigin origin, const Workload& work, std::size_t size, double exponent) {
  const double operation = 6e-8, digits = -exponent, n = double(size);
  switch (origin) {
    case TruthOrigin::closed_form: return 0;
    case TruthOrigin::taylor: {
      const double order = 1.2 * digits + 4;
      return std::max(1.2 * work.steps, 3 * work.stiffness / order) *
             (order * order / 2 * work.products + order * work.entries) * 1.5 * operation;
    }
    case TruthOrigin::extrapolation:
      return std::max(3.5 * work.steps, 4 * work.stiffness) * 156 * (work.evaluation + 2 * n) * operation;
    case TruthOrigin::radau:
    case TruthOrigin::lobatto: {
      const double s = 21, wide = s * s * n + s * work.evaluation, jacobians = s * work.evaluation * (1 + n);
      return (origin == TruthOrigin::radau ? 3.5 : 4.3) * work.steps *
             (7 * wide * operation + 2 * jacobians * operation + std::pow(s * n, 3) * 1e-9);
    }
  }
  return 0;
}

std::pair<TruthOrigin, TruthOrigin> choose_origins(const WideProblem& problem, const Workload& work,
                                                   double exponent, const CertifyOptions& options) {
  using enum TruthOrigin;
  constexpr std::array<std::pair<TruthOrigin, TruthOrigin>, 7> pairs{{{closed_form, taylor},
                                                                      {closed_form, radau},
                                                                      {closed_form, extrapolation},
                                                                      {closed_form, lobatto},
                                                                      {taylor, extrapolation},
                                                                      {taylor, radau},
                                                                      {radau, lobatto}}};
  if (!options.first.empty() && !options.second.empty()) {
    const auto first = truth_origin(options.first), second = truth_origin(options.second);
    if (first == second)
      throw BadInput("a truth needs two different ways: give another one than " + std::string(options.first));
    if (second == closed_form) throw BadInput("a closed form comes first: swap the two ways");
    if (first == closed_form && !problem.exact) throw BadInput("this problem has no closed form");
    return {first, second};
  }
  const auto asked = [&](const auto& pair) {
    return (options.first.empty() || pair.first == truth_origin(options.first)) &&
           (options.second.empty() || pair.second == truth_origin(options.second));
  };
  double best = std::numeric_limits<double>::infinity();
  std::pair<TruthOrigin, TruthOrigin> chosen{closed_form, closed_form};
  for (const auto& pair : pairs) {
    const bool closed = pair.first == closed_form;
    if (!asked(pair) || (closed && !problem.exact)) continue;
    if (!closed && problem.exact && options.first.empty()) continue;
    // only Taylor series find a kink; extrapolation would step over it even if it were told
    if (work.kinks && (pair.second == extrapolation || !(pair.first == taylor || pair.second == taylor)))
      continue;
    double seconds = expected_seconds(pair.first, work, problem.size, exponent) +
                     expected_seconds(pair.second, work, problem.size, exponent);
    // Radau and Lobatto share Newton's method: rather two ways that share nothing, where time allows it
    if (pair.first == radau) seconds += options.time_limit_seconds / 8;
    if (!(seconds >= best)) best = seconds, chosen = pair;
  }
  if (chosen.first == chosen.second) throw BadInput("no two ways to this truth fit what was asked for");
  return chosen;
}

}  // namespace odemark
