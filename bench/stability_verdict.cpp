// What the stability rows are for: the gate that compares them with theory, and the answer for one dt.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bench/stability.hpp"
#include "bench/stability_growth.hpp"

namespace odemark {

namespace {

bool agrees(const StabilityRow& row, const std::string& verdict, const std::optional<double>& limit) {
  if (row.verdict != verdict) return false;
  if (verdict != "limit") return true;
  return row.measured && limit && std::abs(*row.measured - *limit) <= std::max(1e-9 * *limit, row.resolution);
}

std::string in_words(const std::string& verdict, const std::optional<double>& limit) {
  return verdict == "limit" ? fmt::format("a limit of {:.12g} s", limit.value_or(0)) : '"' + verdict + '"';
}

/// Bands that a scan of that density had to see, and whether it saw them.
void compare_bands(const StabilityRow& row, const std::string& who, std::vector<std::string>& faults) {
  const auto close = [&](double a, double b) { return std::abs(a - b) <= 1e-6 * b + 10 * row.resolution; };
  const auto& expected =
      row.theory_as_seen_verdict.empty() ? row.theory_later_bands : row.theory_as_seen_bands;
  for (const auto& expected_band : expected) {
    const double low = expected_band.first, high = expected_band.second;
    if (low > row.scanned_to || high - low < 0.01 * low + 0.04 / row.fastest_rate) continue;
    const double end = std::min(high, row.scanned_to);
    if (std::none_of(row.later_bands.begin(), row.later_bands.end(),
                     [&](const auto& band) { return close(band.first, low) && close(band.second, end); }))
      faults.push_back(
          fmt::format("{}: theory has it stable again from dt = {:.9g} s to {:.9g} s, the stepper is not",
                      who, low, high));
  }
  for (const auto& seen : row.later_bands)
    if (std::none_of(expected.begin(), expected.end(), [&](const auto& band) {
          return close(seen.first, band.first) && close(seen.second, std::min(band.second, row.scanned_to));
        }))
      faults.push_back(fmt::format(
          "{}: the stepper is stable again from dt = {:.9g} s to {:.9g} s, which theory does not have", who,
          seen.first, seen.second));
}

void compare_growth(const StabilityRow& row, const std::string& who, std::vector<std::string>& faults) {
  const double floor = (row.scalar == "float" ? 1e-5 : 1e-13) / row.reference_dt;
  const double measured = row.growth_per_second.value_or(0),
               theory = row.theory_growth_per_second.value_or(0);
  if (!(std::abs(measured - theory) <= 1e-6 * theory + floor))
    faults.push_back(fmt::format("{}: at dt = {:.6g} s it grows by {:.9g} a second, in theory by {:.9g}", who,
                                 row.reference_dt, measured, theory));
}

long fewest_substeps(const StepProbe& probe, double rate, double dt, double limit) {
  const auto stable = [&](long n) {
    return probe(dt / double(n)).growth <= static_cast<long double>(probe.tolerance(rate * dt / double(n)));
  };
  const double bound = std::ceil(dt / limit);
  // a smaller number may lie in a later band: look, unless there are too many to look at
  const long last = bound < 1e15 ? long(bound) : std::numeric_limits<long>::max();
  for (long n = 1; n < std::min(last, 10000L); ++n)
    if (stable(n)) return n;
  long n = last;
  while (n < last + 2 && !stable(n)) ++n;  // dt / n may land on the limit itself
  return n;
}

}  // namespace

std::vector<std::string> stability_faults(const std::vector<StabilityRow>& rows) {
  std::vector<std::string> faults;
  for (const auto& row : rows) {
    const std::string who =
        row.method + " on " + row.problem + (row.scalar == "double" ? "" : " in " + row.scalar);
    if (!row.failure.empty()) {
      faults.push_back(who + ": " + row.failure);
      continue;
    }
    if (row.verdict == "blank" || row.theory_verdict.empty()) continue;
    if (!agrees(row, row.theory_verdict, row.theory) &&
        !(!row.theory_as_seen_verdict.empty() &&
          agrees(row, row.theory_as_seen_verdict, row.theory_as_seen))) {
      faults.push_back(fmt::format("{}: measured {}, theory says {}", who,
                                   in_words(row.verdict, row.measured),
                                   in_words(row.theory_verdict, row.theory)));
      continue;
    }
    compare_bands(row, who, faults);
    compare_growth(row, who, faults);
  }
  return faults;
}

DtVerdict check_dt(const AnyMethod& method, const AnyProblem& problem, double dt) {
  if (!(dt > 0 && std::isfinite(dt))) throw std::invalid_argument("dt must be a positive number of seconds");
  const StabilityRow row = measure_stability(method, problem);
  DtVerdict out;
  if (row.verdict == "blank") {
    out.verdict = "blank", out.reason = row.reason;
    return out;
  }
  const StepProbe probe(method, problem.homogeneous->system<double>());
  const long double growth = probe(dt).growth;
  out.growth_per_second = double(growth) / dt;
  out.unlimited = row.verdict == "unlimited";
  out.limit = row.measured;
  if (out.limit) out.margin = *out.limit / dt;
  // where every dt is unstable, growth below the tolerance is a slow explosion, not a stable step
  const bool stable =
      row.verdict != "unstable" && growth <= static_cast<long double>(probe.tolerance(row.fastest_rate * dt));
  out.verdict = stable ? "stable" : "unstable";
  if (stable)
    out.substeps = 1;
  else if (row.verdict == "limit")
    out.substeps = fewest_substeps(probe, row.fastest_rate, dt, *row.measured);
  else
    out.reason = "it is unstable at every dt: a smaller one only grows more slowly";
  return out;
}

}  // namespace odemark
