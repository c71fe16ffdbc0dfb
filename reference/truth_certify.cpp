#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>

#include "reference/bad_input.hpp"
#include "reference/truth_choice.hpp"
#include "reference/truth_compare.hpp"
#include "reference/truth_run.hpp"
#include "reference/truth_wide.hpp"

namespace odemark {

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Computation {
  const WideProblem& problem;
  TruthOrigin origin;
  std::string name;
  WideTrajectory states;
  std::vector<WideEvent> events;
  std::vector<Wide> kinks;
  double look_share = 1;  // two computations look for events at different times

  void compute(const std::vector<Wide>& start, const std::vector<Wide>& times, double exponent,
               const std::vector<double>& scale, const std::vector<Wide>& stops, RunBudget& budget) {
    if (origin == TruthOrigin::closed_form) {
      name = "closed form";
      take(run_closed_form(problem, start, times));
      return;
    }
    kinks.clear();
    const auto solver = make_truth_solver(origin, exponent, scale);
    name = solver->name();
    take(run(*solver, problem, start, times, stops, budget, look_share));
    for (const Wide& kink : solver->kinks())  // met again and again while an event is located
      if (std::none_of(kinks.begin(), kinks.end(),
                       [&](const Wide& k) { return abs(k - kink) <= Wide("1e-25") * abs(k); }))
        kinks.push_back(kink);
  }
  void take(WideRun&& done) { states = std::move(done.states), events = std::move(done.events); }
};

/// One ulp of double at y, or of the scale where y is 0.
double ulp(double y, double scale) {
  const double at = y == 0 ? scale : std::abs(y);
  return std::nextafter(at, std::numeric_limits<double>::infinity()) - at;
}

/// Fills the sensitivities: a perturbation small enough to act linearly, measured and scaled to one ulp.
void measure_sensitivity(const AnyProblem& problem, const Computation& done, const std::vector<Wide>& times,
                         RunBudget budget, Truth& truth) {
  for (auto& point : truth.points) point.sensitivity = 0;
  try {
    for (std::size_t i = 0; i < done.problem.size; ++i) {
      const double at = static_cast<double>(done.problem.initial[i]);
      const double scale = problem.scale[i] > 0 ? problem.scale[i] : 1;
      const double nudge = 1e-10 * std::max(std::abs(at), at == 0 ? scale : 0.0);
      Computation nudged{done.problem, done.origin, {}, {}, {}, {}, 1};
      auto start = done.problem.initial;
      start[i] += Wide(nudge);
      nudged.compute(start, times, -18, problem.scale, {}, budget);
      for (std::size_t p = 0; p < times.size(); ++p)
        for (std::size_t c = 0; c < done.problem.size; ++c) {
          const double moved = static_cast<double>(abs(nudged.states[p][c] - done.states[p][c]));
          const double change =
              moved / nudge * ulp(at, scale) / (problem.scale[c] > 0 ? problem.scale[c] : 1);
          truth.points[p].sensitivity = std::max(truth.points[p].sensitivity, change);
        }
    }
  } catch (const RunFailed&) {
    for (auto& point : truth.points) point.sensitivity = std::numeric_limits<double>::quiet_NaN();
  }
}

std::string in_words(const AnyProblem& problem, const CertifyOptions& options) {
  return std::to_string(options.digits) + " digits of " + problem.id + " could not be certified";
}

std::string short_number(double x) {
  std::ostringstream text;
  text << x;
  return text.str();
}

}  // namespace

WideProblem widened(const AnyProblem& problem, bool exact_inputs) {
  if (problem.is_large())
    throw TruthUnavailable(problem.id + " has " + std::to_string(problem.size()) +
                               " components: in fifty digits at most " +
                               std::to_string(largest_compared_size) + " are solved for",
                           0);
  for (const auto& family : suite_wide_families())
    if (family.id == problem.family)
      return exact_inputs ? family.as_written(problem) : family.rounded(problem);
  throw TruthUnavailable("the family " + std::string(problem.family) +
                             " is not part of the suite, so its right-hand side in fifty digits is not known",
                         0);
}

Truth certify_wide(const AnyProblem& problem, const WideProblem& first, const WideProblem& second,
                   const std::vector<Wide>& times, const CertifyOptions& options) {
  const auto begin = Clock::now();
  const auto deadline = begin + std::chrono::duration_cast<Clock::duration>(
                                    std::chrono::duration<double>(std::min(options.time_limit_seconds, 1e9)));
  const Workload work = survey(first, times.back(), problem.scale);
  double exponent = -options.digits - 4;
  const auto [one, two] = choose_origins(first, work, exponent, options);
  Computation a{first, one, {}, {}, {}, {}, 1}, b{second, two, {}, {}, {}, {}, 0.375};
  Truth truth;
  truth.problem = problem.id, truth.exact_inputs = options.exact_inputs, truth.digits = -1;
  const auto attempt = [&](double at, Clock::time_point until) {
    RunBudget budget{until};
    a.compute(first.initial, times, at, problem.scale, {}, budget);
    b.compute(second.initial, times, at, problem.scale, a.kinks, budget);
    truth.origin = a.name, truth.checked_by = b.name;
    truth.points.clear();
    for (std::size_t p = 0; p < times.size(); ++p)
      truth.points.push_back(compare(times[p], a.states[p], b.states[p], problem.scale));
    truth.events = compare(a.events, b.events);
    truth.digits = truth.points.front().digits;
    for (const auto& point : truth.points) truth.digits = std::min(truth.digits, point.digits);
  };
  std::string failure;
  try {
    constexpr double tightest = -45;
    for (int round = 0; round < 3; ++round) {
      const int before = truth.digits;
      attempt(exponent, deadline);
      if (truth.digits >= options.digits || exponent <= tightest) break;
      if (round > 0 && truth.digits <= before + 1) break;  // tightening does not help
      exponent = std::max(tightest, exponent - (options.digits - truth.digits) - 2);
    }
  } catch (const RunFailed& why) {
    failure = why.what();
  }
  if (truth.digits < 0) {  // how far is it from what was asked?
    try {
      attempt(-14, Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(0.3 * options.time_limit_seconds)));
    } catch (const RunFailed& why) {
      throw TruthUnavailable(
          in_words(problem, options) + " within " + short_number(options.time_limit_seconds) +
              " s: " + (failure.empty() ? why.what() : failure) + "; no digits were reached",
          0);
    }
  }
  if (truth.digits < options.digits)
    throw TruthUnavailable(in_words(problem, options) + (failure.empty() ? "" : ": " + failure) + "; " +
                               a.name + " and " + b.name + " agree to " + std::to_string(truth.digits),
                           truth.digits);
  if (options.sensitivity) measure_sensitivity(problem, a, times, RunBudget{deadline}, truth);
  truth.seconds = since(begin);
  return truth;
}

Truth unchecked_closed_form(const AnyProblem& problem, const WideProblem& wide,
                            const std::vector<Wide>& times) {
  const auto begin = Clock::now();
  Computation a{wide, TruthOrigin::closed_form, {}, {}, {}, {}, 1};
  RunBudget budget;
  try {
    a.compute(wide.initial, times, 0, problem.scale, {}, budget);
  } catch (const RunFailed& why) {
    throw TruthUnavailable("the solution of " + problem.id + " is not known: " + why.what(), 0);
  }
  Truth truth;
  truth.problem = problem.id, truth.origin = a.name;
  truth.checked_by =
      "nothing: no second computation came to its end; the formula is tested against the right-hand side";
  truth.digits = most_digits;
  for (const auto& event : a.events)
    truth.events.push_back({event.event, event.phase, truth_value(event.t, Wide("1e-30") * abs(event.t))});
  for (std::size_t p = 0; p < times.size(); ++p) {
    TruthPoint point;
    point.t = static_cast<double>(times[p]);
    for (std::size_t i = 0; i < wide.size; ++i) {
      const Wide scale(problem.scale[i] > 0 ? problem.scale[i] : 1), size = abs(a.states[p][i]);
      point.values.push_back(truth_value(a.states[p][i], Wide("1e-30") * (size > scale ? size : scale)));
    }
    point.digits = digits_in_scale(point.values, problem.scale);
    truth.digits = std::min(truth.digits, point.digits);
    truth.points.push_back(std::move(point));
  }
  measure_sensitivity(problem, a, times, budget, truth);
  truth.seconds = since(begin);
  return truth;
}

void check_digits(int digits) {
  if (digits < 1) throw BadInput("ask for at least one digit");
  if (digits > most_digits)
    throw BadInput(std::to_string(digits) + " digits are too many: at most " + std::to_string(most_digits) +
                   " can be asked for; a solution that is known to more says how many");
}

Truth certify(const AnyProblem& problem, const std::vector<double>& times, const CertifyOptions& options) {
  if (times.empty()) throw BadInput("a truth needs at least one time");
  double before = 0;
  for (const double t : times) {
    if (!std::isfinite(t) || !(t > before))
      throw BadInput("the times of a truth must be finite, positive and ascending: " + short_number(t) +
                     " is not");
    before = t;
  }
  check_digits(options.digits);
  const WideProblem wide = widened(problem, options.exact_inputs);
  return certify_wide(problem, wide, wide, {times.begin(), times.end()}, options);
}

}  // namespace odemark
