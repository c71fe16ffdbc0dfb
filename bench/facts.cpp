// Facts under the names that they have in JSON and on pages.
#include "bench/facts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace odemark {

namespace {

template <class T>
FactValue plain(const T& value) {
  return value;
}
FactValue plain(const Coefficient& x) { return double(x); }
FactValue plain(const PowerLaw& law) { return FactPower{double(law.coefficient), law.power}; }
FactValue plain(const Intervals& intervals) {
  FactIntervals out;
  for (const auto& [low, high] : intervals) out.emplace_back(double(low), double(high));
  return out;
}
FactValue plain(const std::map<Coefficient, Coefficient>& numbers) {
  FactNumbers out;
  for (const auto& [name, value] : numbers)
    out.emplace_back(fmt::format("{:g}", double(name)), double(value));
  return out;
}
FactValue plain(const std::map<std::string, Coefficient>& numbers) {
  FactNumbers out;
  for (const auto& [name, value] : numbers) out.emplace_back(name, double(value));
  return out;
}

class Lines {
 public:
  template <class T>
  void operator()(std::string key, const Fact<T>& fact) {
    lines_.push_back({std::move(key), fact ? plain(*fact) : FactValue{}, fact.reason});
  }
  std::vector<FactLine> take() { return std::move(lines_); }

 private:
  std::vector<FactLine> lines_;
};

std::vector<FactLine> lines_of(const MethodFacts& f) {
  Lines add;
  add("stages", f.stages), add("order", f.order), add("embedded_order", f.embedded_order);
  add("stage_order", f.stage_order), add("fsal", f.fsal);
  add("evaluations_per_step", f.evaluations_per_step),
      add("linear_solves_per_step", f.linear_solves_per_step);
  add("error_constant", f.error_constant);
  const StabilityFacts& s = f.stability;
  add("real_interval", s.real_interval), add("real_islands", s.real_islands);
  add("imaginary_interval", s.imaginary_interval);
  add("imaginary_interval_eps_1e-3", s.imaginary_interval_eps), add("imaginary_bands", s.imaginary_bands);
  add("log_amplification", s.log_amplification), add("phase_error", s.phase_error);
  add("r_infinity", s.r_infinity), add("a_stable", s.a_stable), add("a_alpha_degrees", s.a_alpha_degrees);
  add("l_stable", s.l_stable), add("stiffly_accurate", f.stiffly_accurate);
  add("algebraically_stable", f.algebraically_stable), add("symplectic", f.symplectic);
  add("symmetric", f.symmetric), add("ssp_coefficient", f.ssp_coefficient);
  add("oscillator_limit", f.oscillator_limit), add("oscillator_windows", f.oscillator_windows);
  add("damped_limit", f.damped_limit);
  if (f.embedded_order) {
    const StabilityFacts& e = f.embedded;
    add("embedded_error_constant", f.embedded_error_constant);
    add("embedded_real_interval", e.real_interval), add("embedded_imaginary_interval", e.imaginary_interval);
    add("embedded_r_infinity", e.r_infinity), add("embedded_a_stable", e.a_stable);
    add("embedded_l_stable", e.l_stable);
  }
  add("controller_spectral_radius", f.controller_spectral_radius);
  add("internal_amplification", f.internal_amplification), add("zero_stable", f.zero_stable);
  add("step_ratio_limit", f.step_ratio_limit);
  return add.take();
}

MethodFacts facts_of(const AnyMethod& method) {
  return method_facts(method.theory ? method.theory() : Theory{}, method.order, method.embedded_order);
}

}  // namespace

FactSheet fact_sheet(const AnyMethod& method) {
  FactSheet sheet;
  sheet.id = method.id, sheet.family = method.kind, sheet.provider = method.provider;
  sheet.source = method.source, sheet.advice = method.advice;
  sheet.name = sheet.id;
  std::replace(sheet.name.begin(), sheet.name.end(), '_', ' ');
  sheet.facts = lines_of(facts_of(method));
  return sheet;
}

std::vector<std::string> claim_faults(const AnyMethod& method) {
  std::vector<std::string> faults;
  const MethodFacts f = facts_of(method);
  const auto compare = [&](const char* what, const Fact<int>& found, int claimed) {
    if (found && claimed > 0 && *found != claimed)
      faults.push_back(fmt::format("{}: {} {} is claimed, its coefficients have {} ({})", method.id, what,
                                   claimed, *found, found.reason));
  };
  compare("order", f.order, method.order);
  compare("embedded order", f.embedded_order, method.embedded_order);
  if (f.zero_stable && !*f.zero_stable)
    faults.push_back(
        fmt::format("{}: a root of rho lies outside the unit circle, or twice on it", method.id));
  return faults;
}

}  // namespace odemark
