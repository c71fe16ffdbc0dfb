#include "bench/problem_sheets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/pictures.hpp"
#include "integrators/linear_stability.hpp"
#include "reference/truth.hpp"

namespace odemark {

namespace {

/// One for each kind of limit: on the real axis, on the imaginary one, on both, and none.
constexpr std::array<std::string_view, 8> shown_methods{
    "explicit_euler",      "heun",          "rk4", "dormand_prince54", "dop853", "adams_bashforth3",
    "semi_implicit_euler", "implicit_euler"};

std::vector<std::string> offers_of(const AnyProblem& problem) {
  std::vector<std::string> offers;
  const auto add = [&](bool has, const char* text) {
    if (has) offers.emplace_back(text);
  };
  add(problem.has_exact, "closed form");
  add(problem.has_written_jacobian, "Jacobian by hand");
  add(problem.abilities & Ability::second_order, "second order: x'' = a(t, x, x')");
  add(problem.abilities & Ability::separable, "force without velocity");
  add(problem.abilities & Ability::linear_part, "linear part");
  add(problem.abilities & Ability::rotation, "rotation of a rigid body");
  add(!problem.switch_times.empty(), "says when it switches");
  add(!problem.event_names.empty(), "says where events happen");
  return offers;
}

/// The Jacobian at one time of the solution, in the phase that it is in.
LinearProblem spectrum_at(const AnyProblem& problem, const Truth& truth, double t,
                          const std::vector<double>& y) {
  const auto& pieces = problem.pieces<double>();
  std::size_t phase = 0;
  if (!pieces.switch_times.empty())
    while (phase < pieces.switch_times.size() && pieces.switch_times[phase] < t) ++phase;
  for (const auto& event : truth.events)
    if (pieces.jumps && event.t.hi <= static_cast<long double>(t)) phase = event.phase;
  const std::size_t n = problem.size();
  std::vector<double> matrix(n * n);
  pieces.phases[phase].jacobian(t, y, MatrixView<double>{matrix.data(), n});
  return linear_problem(n, {matrix.begin(), matrix.end()},
                        (problem.abilities & Ability::second_order) && n == 2);
}

void add_spectra(SheetPreset& sheet, const Registry& registry, const AnyProblem& problem,
                 const Truth& truth) {
  if (problem.size() > 64) return;  // the cube of it, at every time
  std::vector<LinearProblem> spectra{spectrum_at(problem, truth, problem.t_begin, problem.initial)};
  for (const auto& point : truth.points) {
    std::vector<double> y;
    for (const auto& value : point.values) y.push_back(double(value.hi));
    spectra.push_back(spectrum_at(problem, truth, point.t, y));
  }
  for (auto& spectrum : spectra) {
    double slowest = 0, fastest = 0;
    for (const auto& z : spectrum.eigenvalues) {
      const double re = double(z.real()), im = double(std::abs(z.imag()));
      sheet.fastest_decay = std::max(sheet.fastest_decay, -re);
      sheet.fastest_growth = std::max(sheet.fastest_growth, re);
      sheet.fastest_turn = std::max(sheet.fastest_turn, im);
      if (re < 0) fastest = std::max(fastest, -re), slowest = slowest > 0 ? std::min(slowest, -re) : -re;
    }
    if (fastest > slowest)
      sheet.stiffness_ratio = std::max(sheet.stiffness_ratio.value_or(1), fastest / slowest);
    std::erase_if(spectrum.eigenvalues,
                  [](const auto& z) { return z.real() > 0; });  // growth is no instability
  }
  for (const auto id : shown_methods)
    for (const auto& method : registry.methods) {
      if (method.id != id || !method.theory || !missing_ability(method.needs, problem.abilities).empty())
        continue;
      const Theory theory = method.theory();
      SheetLimit limit{std::string(id), {}};
      bool known = true;
      for (const auto& spectrum : spectra) {
        if (spectrum.eigenvalues.empty()) continue;
        const StabilityLimit one = stability_limit(theory, spectrum);
        if (one.verdict == Stability::unknown) known = false;
        const double dt = one.verdict == Stability::limit ? double(one.limit) : 0;
        if (one.verdict == Stability::limit || one.verdict == Stability::unstable)
          limit.dt = std::min(limit.dt.value_or(dt), dt);
      }
      if (known) sheet.limits.push_back(std::move(limit));
    }
}

SheetPreset sheet_of(const Registry& registry, const AnyProblem& problem, const Preset& preset) {
  SheetPreset sheet;
  sheet.id = problem.id, sheet.settings = std::string(preset.settings),
  sheet.about = std::string(preset.about);
  sheet.t_end = problem.t_end, sheet.suggested_dt = problem.suggested_dt;
  try {
    const auto truth = truth_of(problem);
    sheet.digits = truth->digits, sheet.origin = truth->origin, sheet.checked_by = truth->checked_by;
    sheet.sensitivity = truth->last().sensitivity, sheet.events = long(truth->events.size());
    add_spectra(sheet, registry, problem, *truth);
  } catch (const TruthUnavailable& e) {
    sheet.origin = e.what();
  }
  return sheet;
}

}  // namespace

std::string range_text(const Range& r) {
  const std::string whole = r.whole ? ", whole" : "";
  if (std::isinf(r.lowest) && std::isinf(r.highest)) return "any" + whole;
  if (std::isinf(r.highest)) return fmt::format("{} {:g}{}", r.open_below ? ">" : ">=", r.lowest, whole);
  if (std::isinf(r.lowest)) return fmt::format("{} {:g}{}", r.open_above ? "<" : "<=", r.highest, whole);
  return fmt::format("{}{:g}, {:g}{}{}", r.open_below ? "(" : "[", r.lowest, r.highest,
                     r.open_above ? ")" : "]", whole);
}

ProblemSheet problem_sheet(const Registry& registry, const AnyFamily& family, bool with_scene) {
  ProblemSheet sheet;
  sheet.id = std::string(family.id), sheet.title = std::string(family.title);
  sheet.equations = std::string(family.equations), sheet.source = std::string(family.source);
  for (const auto& c : family.components) sheet.components.emplace_back(c.name, c.unit);
  sheet.invariants.assign(family.invariant_names.begin(), family.invariant_names.end());
  sheet.events.assign(family.event_names.begin(), family.event_names.end());
  for (const auto& preset : family.presets) {
    const AnyProblem problem = family.create(preset, {});
    if (sheet.presets.empty()) {
      sheet.offers = offers_of(problem);
      for (const auto& p : family.parameters) {
        double value = p.value;
        for (const auto& set : problem.parameters)
          if (set.name == p.name) value = set.value;
        sheet.parameters.push_back({std::string(p.name), std::string(p.unit), std::string(p.meaning),
                                    range_text(p.range), value, p.shorthand});
      }
      if (with_scene) sheet.scene = make_scene(registry, problem, true);
    }
    sheet.presets.push_back(sheet_of(registry, problem, preset));
  }
  return sheet;
}

std::vector<ProblemSheet> problem_sheets(const Registry& registry, const std::vector<AnyFamily>& families,
                                         const std::function<void(std::size_t, std::size_t)>& progress) {
  std::vector<ProblemSheet> sheets;
  for (const auto& family : families) {
    sheets.push_back(problem_sheet(registry, family, true));
    if (progress) progress(sheets.size(), families.size());
  }
  return sheets;
}

}  // namespace odemark
