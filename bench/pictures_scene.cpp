// What a problem does over time: a line within a picture's accuracy of the truth, and coarse runs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bench/pictures.hpp"
#include "bench/registry.hpp"
#include "bench/run.hpp"
#include "bench/solve.hpp"
#include "reference/truth.hpp"

namespace odemark {

namespace {

constexpr std::size_t exact_points = 128;  // multiples of 16 and of coarse_steps: the times are shared
constexpr double visible = 1e-3;           // of the scale: a line of a picture is thicker
constexpr long most_steps = 2'000'000;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// One run, seen at the times of a grid or after every step.
struct Seen {
  RunStatus status = RunStatus::not_applicable;
  std::vector<double> t;
  std::vector<std::vector<double>> y;  // per time, all components
};

bool can_run(const AnyMethod& method, const AnyProblem& problem, bool fixed) {
  return missing_ability(method.needs, problem.abilities).empty() && method.runs<double>().solve_traced &&
         (fixed ? method.takes_fixed_steps : method.takes_error_control);
}

Seen solve(const AnyMethod& method, const AnyProblem& problem, const Control& control,
           const std::vector<double>& grid) {
  Seen seen;
  const std::size_t size = problem.size();
  std::vector<double> y = problem.initial;
  if (grid.empty()) seen.t.push_back(problem.t_begin), seen.y.push_back(y);
  Trace<double> trace;
  trace.grid = grid;
  long steps = 0;
  trace.on_step = [&](double t, const double* state) {
    if (grid.empty()) seen.t.push_back(t), seen.y.emplace_back(state, state + size);
    return ++steps < most_steps;
  };
  std::vector<FoundEvent> found;
  try {
    seen.status = solve_problem(method, problem, control, y, trace, found, nullptr).status;
  } catch (const std::exception&) {
    seen.status = RunStatus::rhs_failed;
  }
  for (std::size_t i = 0; i < trace.samples.size() / std::max<std::size_t>(size, 1); ++i) {
    const auto at = trace.samples.begin() + static_cast<std::ptrdiff_t>(i * size);
    seen.t.push_back(grid[i]);
    seen.y.emplace_back(at, at + static_cast<std::ptrdiff_t>(size));
  }
  return seen;
}

/// The largest distance from the certified values, in units of the scale; infinite where something is
/// missing.
double distance(const Seen& seen, const Truth& truth, const AnyProblem& problem) {
  double worst = 0;
  for (const auto& point : truth.points) {
    const auto at = std::find(seen.t.begin(), seen.t.end(), point.t);
    if (at == seen.t.end()) return infinity;
    const auto& y = seen.y[static_cast<std::size_t>(at - seen.t.begin())];
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double off = std::abs(y[i] - double(point.values[i].hi)) / problem.scale[i];
      if (!(off <= worst)) worst = off;
    }
  }
  return std::isnan(worst) ? infinity : worst;
}

Trajectory curve(const AnyProblem& problem, const Seen& seen, std::size_t component, std::string method,
                 double dt) {
  Trajectory out;
  out.problem = problem.id, out.method = std::move(method);
  out.component = std::string(problem.components[component].name);
  out.unit = std::string(problem.components[component].unit);
  out.dt = dt;
  for (std::size_t i = 0; i < seen.t.size(); ++i)
    out.t.push_back(seen.t[i]), out.value.push_back(seen.y[i][component]);
  return out;
}

/// Two components named x and y and no z make a path in a plane.
std::pair<std::optional<std::size_t>, std::size_t> components_to_draw(const AnyProblem& problem) {
  std::optional<std::size_t> x, y;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    if (problem.components[i].name == "x") x = i;
    if (problem.components[i].name == "y") y = i;
    if (problem.components[i].name == "z") return {std::nullopt, 0};
  }
  if (x && y) return {x, *y};
  if (problem.family.starts_with("drag_ship") && problem.size() > 1) return {std::nullopt, 1};  // speed
  return {std::nullopt, 0};
}

/// The most accurate of a few careful runs, as the certified values judge them.
void add_exact(Scene& scene, const Registry& registry, const AnyProblem& problem, const Truth& truth,
               std::optional<std::size_t> x, std::size_t y) {
  std::vector<double> grid;
  for (std::size_t i = 1; i <= exact_points; ++i)
    grid.push_back(static_cast<double>(i) * problem.t_end / exact_points);
  for (const auto& point : truth.points) grid.push_back(point.t);
  std::sort(grid.begin(), grid.end());
  grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
  struct Candidate {
    std::string_view method;
    Control control;
    const char* words;
  };
  const std::array candidates{Candidate{"dormand_prince54", ErrorControl{1e-10, 1e-10}, "tolerance 1e-10"},
                              Candidate{"cvode_bdf", ErrorControl{1e-9, 1e-9}, "tolerance 1e-9"},
                              Candidate{"sdirk2", FixedSteps{160'000}, "160 000 steps"}};
  double best = visible;
  for (const auto& candidate : candidates) {
    const auto method = std::find_if(registry.methods.begin(), registry.methods.end(),
                                     [&](const AnyMethod& m) { return m.id == candidate.method; });
    const bool fixed = std::holds_alternative<FixedSteps>(candidate.control);
    if (method == registry.methods.end() || !can_run(*method, problem, fixed)) continue;
    Control control = candidate.control;
    if (auto* adaptive = std::get_if<ErrorControl>(&control)) adaptive->scale = problem.scale.data();
    Seen seen = solve(*method, problem, control, grid);
    const double off = seen.status == RunStatus::reached_end ? distance(seen, truth, problem) : infinity;
    if (!(off <= best)) continue;
    best = off;
    seen.t.insert(seen.t.begin(), problem.t_begin);
    seen.y.insert(seen.y.begin(), problem.initial);
    scene.exact.clear();
    if (x) scene.exact.push_back(curve(problem, seen, *x, "exact", 0));
    scene.exact.push_back(curve(problem, seen, y, "exact", 0));
    scene.exact_is = fmt::format("{} with {}, within {:.0e} of the certified values at {} times",
                                 candidate.method, candidate.words, best, truth.points.size());
    if (best < 1e-7) return;
  }
}

}  // namespace

Scene make_scene(const Registry& registry, const AnyProblem& problem, bool certified, long steps) {
  Scene scene;
  scene.problem = problem.id;
  const auto [x, y] = components_to_draw(problem);
  if (x) scene.x = std::string(problem.components[*x].name);
  scene.y = std::string(problem.components[y].name);
  if (certified) add_exact(scene, registry, problem, *truth_of(problem), x, y);
  const double dt = problem.t_end / static_cast<double>(steps);
  for (const std::string_view id : {"explicit_euler", "semi_implicit_euler", "rk4", "implicit_euler"}) {
    const auto method = std::find_if(registry.methods.begin(), registry.methods.end(),
                                     [&](const AnyMethod& m) { return m.id == id; });
    if (method == registry.methods.end() || !can_run(*method, problem, true)) continue;
    Seen seen = solve(*method, problem, FixedSteps{steps}, {});
    for (std::size_t i = 0; i < seen.t.size(); ++i)
      seen.t[i] = static_cast<double>(i) * problem.t_end / static_cast<double>(steps);
    Scene::Run run{std::string(id), std::string(to_string(seen.status)), dt,
                   curve(problem, seen, y, std::string(id), dt), std::nullopt};
    if (x) run.x = curve(problem, seen, *x, std::string(id), dt);
    scene.runs.push_back(std::move(run));
  }
  return scene;
}

}  // namespace odemark
