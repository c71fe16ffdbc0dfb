// Cards and regions; scenes are in pictures_scene.cpp.
#include "bench/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bench/registry.hpp"
#include "bench/settling.hpp"
#include "bench/stability_region.hpp"
#include "integrators/linear_stability.hpp"
#include "integrators/system.hpp"
#include "reference/bad_input.hpp"
#include "reference/truth.hpp"

namespace odemark {

namespace {

MethodCard card_of(const AnyMethod& m) {
  return {std::string(m.id),
          std::string(m.kind),
          std::string(m.provider),
          std::string(m.source),
          std::string(m.starter),
          std::string(m.note),
          m.order};
}

ProblemCard card_of(const AnyProblem& p) {
  ProblemCard card;
  card.id = p.id, card.family = std::string(p.family), card.title = std::string(p.title);
  card.equations = std::string(p.equations), card.about = p.customised ? "" : std::string(p.about);
  card.source = std::string(p.source);
  for (const auto& parameter : p.parameters)
    if (!parameter.shorthand)
      card.parameters.push_back(fmt::format("{} = {:.6g}{}{}", parameter.name, parameter.value,
                                            parameter.unit.empty() ? "" : " ", parameter.unit));
  card.t_end = p.t_end, card.suggested_dt = p.suggested_dt;
  card.in_seconds = std::any_of(p.components.begin(), p.components.end(), [](const Component& c) {
    return c.unit.find("/s") != std::string_view::npos;
  });
  return card;
}

std::string describe(const Truth& truth) {
  std::string text = truth.origin;
  if (!truth.checked_by.empty()) text += ", checked by " + truth.checked_by;
  return text + fmt::format("; {} digits at the end", truth.last().digits);
}

/// The problem that a row is of; throws BadInput where the registry does not have it.
AnyProblem problem_of(const Registry& registry, const Row& row) {
  return find_problem(registry.families, row.problem.substr(0, row.problem.find('{')), row.settings);
}

/// Somebody's own problem is drawn at the coarsest of somebody's own steps.
long steps_to_draw(const std::vector<Row>& rows, const Row& row) {
  if (row.settings.empty()) return coarse_steps;
  constexpr long most = 20'000;
  std::optional<long> fewest;
  for (const Row& other : rows)
    if (other.problem == row.problem && other.steps) fewest = std::min(fewest.value_or(most), *other.steps);
  return std::clamp(fewest.value_or(coarse_steps), coarse_steps, most);
}

void add_problem(Pictures& pictures, const Registry& registry, const Row& row, bool certified, long steps) {
  AnyProblem problem;
  try {
    problem = problem_of(registry, row);
  } catch (const BadInput&) {
    return;  // results of another binary: its rows are shown without a card
  }
  if (problem.id != row.problem) return;
  ProblemCard card = card_of(problem);
  try {
    card.truth = certified ? describe(*truth_of(problem)) : row.reason;
  } catch (const TruthUnavailable& e) {
    card.truth = e.what(), certified = false;
  }
  pictures.problems.push_back(std::move(card));
  // a picture needs all of a solution on its way, and shows one of its components
  if (!problem.is_large()) pictures.scenes.push_back(make_scene(registry, problem, certified, steps));
}

struct WantedRegions {
  std::string_view id, title;
  std::vector<std::string_view> methods;
  RegionWindow window;
};

const std::vector<WantedRegions>& wanted_regions() {
  static const std::vector<WantedRegions> all{
      {"explicit",
       "Where explicit Runge-Kutta steps are stable",
       {"explicit_euler", "heun", "bogacki_shampine32", "rk4", "dormand_prince54"},
       {-5.5, 1.5, -4.5, 4.5}},
      {"multistep",
       "Where Adams-Bashforth steps are stable",
       {"explicit_euler", "adams_bashforth2", "adams_bashforth3", "adams_bashforth4", "adams_bashforth5"},
       {-2.4, 0.6, -1.3, 1.3}},
      {"taylor",
       "Where Taylor series are stable",
       {"taylor1", "taylor2", "taylor4", "taylor8", "taylor12", "taylor16", "taylor20"},
       {-10, 3, -10, 10}},
      {"implicit",
       "Where implicit steps are stable",
       {"implicit_euler", "implicit_trapezoid", "implicit_midpoint", "sdirk2"},
       {-4, 5, -4, 4}}};
  return all;
}

}  // namespace

Pictures make_pictures(const Registry& registry, const std::vector<Row>& rows) {
  Pictures pictures;
  for (const auto& method : registry.methods) pictures.methods.push_back(card_of(method));
  std::set<std::string> with_errors, seen;
  for (const Row& row : rows)
    if (row.errors) with_errors.insert(row.problem);
  for (const Row& row : rows)
    if (seen.insert(row.problem).second)
      add_problem(pictures, registry, row, with_errors.contains(row.problem), steps_to_draw(rows, row));
  pictures.regions = make_regions(registry);
  add_damping(pictures, registry);
  if (std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.local.has_value(); }))
    pictures.settling = measure_settling(registry.methods);
  return pictures;
}

std::vector<RegionGroup> make_regions(const Registry& registry) {
  std::vector<RegionGroup> groups;
  for (const auto& wanted : wanted_regions()) {
    RegionGroup group{std::string(wanted.id), std::string(wanted.title), {}};
    for (const auto id : wanted.methods)
      for (const auto& method : registry.methods)
        if (method.id == id && method.theory)
          group.regions.push_back(stability_region(std::string(id), method.theory(), wanted.window));
    if (!group.regions.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

void add_damping(Pictures& pictures, const Registry& registry) {
  pictures.damping_at = {-0.5, -1, -2, -10, -1000, {0, 0.1}, {0, 0.5}, {0, 1}, {0, 2}};
  for (const auto& method : registry.methods) {
    if (!method.theory) continue;
    const Theory theory = method.theory();
    Damping damping{std::string(method.id), std::string(theory.blank_reason), {}};
    if (!theory.numerator.empty() || !theory.rho.empty() || !theory.characteristic.empty())
      for (const auto& z : pictures.damping_at)
        damping.amplification.push_back(double(amplification(theory, WideComplex(z.real(), z.imag()))));
    pictures.damping.push_back(std::move(damping));
  }
}

}  // namespace odemark
