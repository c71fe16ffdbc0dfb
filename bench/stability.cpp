// Rows of the stability table: one method on one problem, measured and in theory, side by side.
#include "bench/stability.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "bench/stability_scan.hpp"

namespace odemark {

namespace {

std::string_view name_of(Stability verdict) {
  switch (verdict) {
    case Stability::limit: return "limit";
    case Stability::unstable: return "unstable";
    case Stability::unlimited: return "unlimited";
    case Stability::unknown: break;
  }
  return "";
}

/// Why there is nothing to measure; "" where there is something.
std::string why_blank(const AnyMethod& method, const AnyProblem& problem, bool has_transition) {
  if (!problem.homogeneous) return "the problem is not linear";
  if ((method.needs & ~problem.abilities) != 0) {
    if (method.needs & ~problem.abilities & Ability::second_order) return "the method needs x'' = a(t, x, v)";
    return "the method needs what the problem does not offer";
  }
  if (has_transition) return "";
  if (!method.takes_fixed_steps) return "it chooses its own steps";
  return "the solver does not let a single step be taken out of it";
}

void fill_theory(StabilityRow& row, const AnyMethod& method, const LinearProblem& spectrum) {
  const Theory theory = method.theory ? method.theory() : Theory{};
  const StabilityLimit limit = stability_limit(theory, spectrum);
  row.theory_verdict = name_of(limit.verdict);
  row.theory_reason = limit.reason;
  if (limit.verdict == Stability::limit || limit.verdict == Stability::unstable)
    row.theory = double(limit.limit);
  for (const auto& [low, high] : limit.later_bands)
    row.theory_later_bands.emplace_back(double(low), double(high));
  for (const Coefficient t : limit.touches) row.touches.push_back(double(t));
  if (limit.verdict == Stability::unknown) return;
  const double growth = double(growth_per_step(theory, spectrum, Coefficient(row.reference_dt)));
  const bool grows = limit.verdict == Stability::unstable ||
                     (limit.verdict == Stability::limit && row.reference_dt > double(limit.limit));
  if (grows && growth > 0) row.theory_growth_per_second = growth / row.reference_dt;
}

/// The tolerance hides growth that is too slow: some methods are unstable in theory where they gain less than
/// 1e-12 a step. What has to agree with the measurement is theory seen through the same tolerance.
void fill_theory_as_seen(StabilityRow& row, const AnyMethod& method, const LinearProblem& spectrum,
                         const StepProbe& probe, const ScanRange& range) {
  const Theory theory = method.theory();
  ScanSubject subject = subject_of(probe);
  subject.growth = [&](double dt) {
    return StepGrowth{true, growth_per_step(theory, spectrum, Coefficient(dt))};
  };
  subject.noise = [](double) { return 0.0L; };
  const Scan seen = scan_step_sizes(subject, range);
  row.theory_as_seen_verdict = seen.verdict, row.theory_as_seen_bands = seen.later_bands;
  if (seen.verdict == "limit") row.theory_as_seen = seen.limit;
}

void fill_measured(StabilityRow& row, const AnyMethod& method, const LinearProblem& spectrum,
                   const StepProbe& probe) {
  ScanRange range{row.fastest_rate, row.theory.value_or(0), 0};
  for (const auto& [low, high] : row.theory_later_bands)
    range.last_expected = std::max(range.last_expected, std::isfinite(high) ? high : low);
  const Scan scan = scan_step_sizes(subject_of(probe), range);
  row.scanned_to = scan.scanned_to;
  if (!scan.failure.empty()) {
    row.verdict = "blank", row.reason = scan.failure;
    if (method.provider == "odemark")
      row.failure = scan.failure;  // a guest's failure is a finding, not our fault
    return;
  }
  row.verdict = scan.verdict, row.resolution = scan.resolution, row.later_bands = scan.later_bands;
  if (scan.verdict != "unlimited") row.measured = scan.limit;
  if (row.measured && row.theory) row.difference = *row.measured - *row.theory;
  const double growth = double(probe(row.reference_dt).growth);
  if (growth > probe.floor() && scan.verdict != "unlimited")
    row.growth_per_second = growth / row.reference_dt;
  const bool apart = row.verdict != row.theory_verdict ||
                     (row.difference && row.verdict == "limit" &&
                      std::abs(*row.difference) > std::max(1e-9 * *row.theory, row.resolution));
  if (apart && !row.theory_verdict.empty()) fill_theory_as_seen(row, method, spectrum, probe, range);
}

template <class T>
StabilityRow measured_row(const AnyMethod& method, const AnyProblem& problem) {
  StabilityRow row;
  row.problem = problem.id, row.family = problem.family, row.settings = problem.user_settings;
  row.method = method.id, row.kind = method.kind, row.provider = method.provider;
  row.scalar = std::is_same_v<T, float> ? "float" : "double";
  row.reference_dt = problem.suggested_dt;
  row.reason = why_blank(method, problem, method.runs<T>().transition != nullptr);
  row.verdict = "blank";
  if (!problem.homogeneous) return row;
  const LinearProblem spectrum = linear_problem(problem);
  row.fastest_rate = double(spectrum.fastest_rate);
  for (const auto& l : spectrum.eigenvalues) row.eigenvalues.emplace_back(double(l.real()), double(l.imag()));
  if (spectrum.grows()) row.reason = "the problem itself grows";
  if (spectrum.fastest_rate == 0) row.reason = "nothing in this problem happens at a rate of its own";
  if (row.reason.empty()) {
    fill_theory(row, method, spectrum);
    fill_measured(row, method, spectrum, StepProbe(method, problem.homogeneous->system<T>()));
  } else if (method.theory && !method.theory().blank_reason.empty()) {
    row.reason = method.theory().blank_reason;
  }
  return row;
}

}  // namespace

LinearProblem linear_problem(const AnyProblem& problem) {
  if (!problem.homogeneous) throw std::invalid_argument(problem.id + " is not linear");
  const auto& system = problem.homogeneous->system<long double>();
  const std::vector<long double> zero(system.size, 0);
  std::vector<long double> jacobian(system.size * system.size, 0);
  system.jacobian(0, zero, MatrixView<long double>{jacobian.data(), system.size});
  return linear_problem(system.size, jacobian, (problem.abilities & Ability::second_order) != 0);
}

std::vector<AnyProblem> default_stability_problems() {
  std::vector<AnyProblem> out{find_problem(suite_families(), "oscillator")};
  for (const auto* settings : {"zeta=0", "zeta=0.01", "zeta=0.1", "zeta=1", "zeta=2"})
    out.push_back(find_problem(suite_families(), "damped_spring", settings));
  for (const auto& family : suite_families())
    if (family.id == "stiff_spring")
      for (const auto& preset : family.presets) out.push_back(find_problem(suite_families(), preset.id));
  out.push_back(find_problem(suite_families(), "drag_ship"));
  return out;
}

StabilityRow measure_stability(const AnyMethod& method, const AnyProblem& problem,
                               const std::string& scalar) {
  if (scalar == "float") return measured_row<float>(method, problem);
  if (scalar == "double") return measured_row<double>(method, problem);
  throw std::invalid_argument("stability is measured in \"double\" or \"float\", not in \"" + scalar + "\"");
}

std::vector<AnyProblem> linear_problems(const std::vector<AnyProblem>& problems) {
  std::vector<AnyProblem> linear;
  std::set<std::string> seen;
  for (const auto& problem : problems)
    if (problem.homogeneous && !problem.is_large() && seen.insert(problem.id).second)
      linear.push_back(problem);
  return linear;
}

std::vector<StabilityRow> measure_stability(const std::vector<AnyMethod>& methods,
                                            const std::vector<AnyProblem>& problems,
                                            const StabilityOptions& options) {
  struct Pair {
    const AnyMethod* method;
    const AnyProblem* problem;
  };
  std::vector<Pair> wanted;
  for (const auto& problem : problems)
    for (const auto& method : methods)
      if (!options.done.contains(problem.id + "/" + std::string(method.id)))
        wanted.push_back({&method, &problem});
  const std::size_t total = methods.size() * problems.size(), before = total - wanted.size();
  std::vector<std::optional<StabilityRow>> rows(wanted.size());
  std::atomic<std::size_t> next{0};
  std::size_t handed_over = 0;
  std::exception_ptr error;
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t i; !(options.stop && options.stop->load()) && (i = next++) < wanted.size();) {
      try {
        StabilityRow row = measure_stability(*wanted[i].method, *wanted[i].problem, options.scalar);
        const std::lock_guard lock(mutex);
        rows[i] = std::move(row);
        for (; handed_over < rows.size() && rows[handed_over]; ++handed_over)
          if (options.progress) options.progress(before + handed_over + 1, total, *rows[handed_over]);
      } catch (...) {
        const std::lock_guard lock(mutex);
        error = std::current_exception();
        next = wanted.size();
      }
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < options.jobs; ++i) threads.emplace_back(work);
  work();
  for (auto& thread : threads) thread.join();
  if (error) std::rethrow_exception(error);
  std::vector<StabilityRow> measured;
  for (std::size_t i = 0; i < handed_over; ++i) measured.push_back(std::move(*rows[i]));
  return measured;
}

}  // namespace odemark
