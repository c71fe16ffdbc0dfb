#include "bench/measured_facts.hpp"

#include <fmt/format.h>

#include "bench/stability.hpp"

namespace odemark {

namespace {

/// Limits by growth rate, with what counts as agreement there.
void add_limit(const AnyMethod& method, const std::string& problem, const std::string& name,
               const std::string& scalar, std::vector<MeasuredFact>& out) {
  const StabilityRow row = measure_stability(method, find_problem(suite_families(), problem), scalar);
  if (row.verdict == "blank" && row.failure.empty()) return;
  MeasuredFact fact;
  fact.fact = name, fact.scalar = scalar;
  const double rate = row.fastest_rate;
  const auto scaled = [rate](const std::optional<double>& dt) {
    return dt ? std::optional<double>(*dt * rate) : std::nullopt;
  };
  fact.theory = scaled(row.theory), fact.measured = scaled(row.measured);
  fact.difference = scaled(row.difference), fact.bound = row.resolution * rate;
  const auto faults = stability_faults({row});
  fact.agrees = faults.empty();
  fact.note = fmt::format("{} by growth rate{}", row.verdict, faults.empty() ? "" : ": " + faults.front());
  if (row.theory_as_seen)
    fact.note += fmt::format("; grows too slowly to be seen below {:.6g}", *row.theory_as_seen * rate);
  out.push_back(std::move(fact));
}

}  // namespace

std::vector<MeasuredFact> measure_facts(const AnyMethod& method) {
  std::vector<MeasuredFact> out;
  for (const std::string scalar : {"double", "float"}) {
    for (auto& fact : detail::measure_linear(method, scalar)) out.push_back(std::move(fact));
    for (auto& fact : detail::measure_nonlinear(method, scalar)) out.push_back(std::move(fact));
  }
  add_limit(method, "dahlquist", "real_interval", "double", out);
  add_limit(method, "oscillator", "oscillator_limit", "double", out);
  return out;
}

std::vector<std::string> measured_faults(const FactSheet& sheet) {
  std::vector<std::string> faults;
  for (const auto& m : sheet.measured)
    if (!m.agrees)
      faults.push_back(fmt::format("{}: {} in {} is off by {:.3g}, allowed {:.3g}; {}", sheet.id, m.fact,
                                   m.scalar, m.difference.value_or(0), m.bound.value_or(0), m.note));
  return faults;
}

}  // namespace odemark
