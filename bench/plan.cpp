#include "bench/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reference/bad_input.hpp"

namespace odemark {

namespace {

/// What one suite runs. Patterns as in select_methods.
struct Suite {
  std::string_view name, methods, problems;
  int rungs;                   // of the step ladder ...
  long most_steps;             // ... which ends here at the latest; of a run under error control alone
  int finest_tolerance;        // error control from 1e-3 down to 10^-this
  std::string_view precision;  // problems on which number types and compensated sums are compared
  int precision_rungs;
  bool timing;
  bool adaptive_only = false;       // error control only, from 1e-2, tolerance by tolerance over all methods
  double time_limit_seconds = 1e9;  // of a counted run, where the user sets no shorter one
};

constexpr std::string_view quick_methods =
    "chapter*,explicit_*,step_doubling_euler,heun,rk4,rk38,bogacki_shampine32,dormand_prince54,tsitouras54,"
    "semi_implicit_euler,"
    "stormer_verlet,velocity_verlet_*,yoshida4,adams_bashforth2,adams_bashforth3,implicit_euler,"
    "implicit_midpoint,implicit_trapezoid,sdirk2,exponential_euler,taylor2,taylor8,taylor20,"
    "fehlberg78,radau_iia5,rodas4,bdf,"
    "cvode_*,arkode_*,gsl_rkf45,gsl_rk8pd,gsl_bsimp,gsl_msadams,gsl_msbdf,odeint_runge_kutta4,odeint_dopri5,"
    "odeint_fehlberg78,"
    "odeint_rosenbrock4,odeint_bulirsch_stoer";
constexpr std::string_view quick_problems =
    "drag_ship,oscillator,damped_spring,stiff_spring,pendulum,free_rigid_body,kepler_e06,van_der_pol,"
    "lorenz63,robertson";
constexpr Suite suites[] = {
    {"quick", quick_methods, quick_problems, 9, 1L << 18, 10, "drag_ship,oscillator", 13, true},
    {"standard", "", "", 12, 1L << 20, 12, "drag_ship,oscillator,kepler_e06,lorenz63", 15, true},
    {"full", "", "", 15, 1L << 23, 13, "", 18, true},
    {"gate", "",
     "drag_ship,drag_ship_quadratic,oscillator,damped_spring,stiff_spring,pendulum,free_rigid_body,kepler_"
     "e02,van_der_pol,lorenz63,robertson",
     7, 1L << 16, 9, "oscillator", 8, false},
    // Down to 1e-15, because Radau codes work with a power of the tolerance asked for: an error of 1e-12 at
    // the end takes that much. The most steps are ten times what the best codes need here.
    {"work_precision", "", "lorenz63_t5,kepler_e05,pleiades,van_der_pol_mu1000,robertson,hires", 0, 200'000,
     15, "", 0, true, true, 2},
};

const Suite& find_suite(std::string_view name) {
  for (const auto& suite : suites)
    if (suite.name == name) return suite;
  throw BadInput(fmt::format("there is no suite \"{}\"{}: the suites are {}", name,
                             suggestion(name, suite_names()), fmt::join(suite_names(), ", ")));
}

/// Patterns of a suite may name methods that this binary was built without.
std::vector<const AnyMethod*> methods_of(const Registry& registry, const Suite& suite,
                                         const PlanOptions& options) {
  if (!options.methods.empty()) return select_methods(registry, options.methods);
  std::vector<const AnyMethod*> chosen;
  std::vector<std::string_view> patterns;
  for (std::string_view rest = suite.methods; !rest.empty();) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    patterns.push_back(rest.substr(0, comma));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  for (const auto& method : registry.methods) {
    const auto hit = [&](std::string_view p) { return matches(p, method.id); };
    if (patterns.empty() || std::any_of(patterns.begin(), patterns.end(), hit)) chosen.push_back(&method);
  }
  return chosen;
}

/// Of a suite: without the large ones, a step of which may take a second. Those run when they are asked for.
std::vector<AnyProblem> problems_of(const Registry& registry, std::string_view patterns,
                                    std::string_view settings = "") {
  auto problems = select_problems(registry, patterns, settings);
  std::erase_if(problems, [](const AnyProblem& p) { return p.is_large(); });
  return problems;
}

std::vector<ScalarType> scalars_of(std::string_view text) {
  std::vector<ScalarType> scalars;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view name = rest.substr(0, comma);
    bool found = false;
    for (const auto s : {ScalarType::float_type, ScalarType::double_type, ScalarType::long_double_type})
      if (to_string(s) == name) scalars.push_back(s), found = true;
    if (!found)
      throw BadInput(fmt::format("\"{}\" is no number type: float, double and long_double are", name));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return scalars;
}

StepFilter filter_of(std::string_view name) {
  for (const auto* filter : step_filters)
    if (filter->id == name) return *filter;
  throw BadInput(fmt::format("\"{}\" is no step-size filter: elementary, pi, h211b and dead_band are", name));
}

long steps_for(const AnyProblem& problem, double dt) {
  const double interval = problem.t_end - problem.t_begin;
  if (!(dt > 0) || !std::isfinite(dt))
    throw BadInput(fmt::format("dt={:g} is no step: it must be a finite number above 0", dt));
  if (dt > interval)
    throw BadInput(fmt::format("dt={:g} s is longer than the {:g} s of {}", dt, interval, problem.id));
  const double count = std::ceil(interval / dt * (1 - 1e-12));
  if (count > 1e9)
    throw BadInput(
        fmt::format("dt={:g} s makes {:.3g} steps on {}: at most 1e9 are run", dt, count, problem.id));
  return static_cast<long>(count);
}

RunRequest base_request(const PlanOptions& options, const Suite& suite, bool timing) {
  RunRequest request;
  request.filter = filter_of(options.filter);
  request.time_limit_seconds = std::min(options.time_limit_seconds, suite.time_limit_seconds);
  if (timing && options.timing)
    request.timing_repeats = suite.adaptive_only ? 15 : 5, request.timing_seconds = 0.002;
  return request;
}

}  // namespace

std::vector<std::string> suite_names() {
  std::vector<std::string> names;
  for (const auto& suite : suites) names.emplace_back(suite.name);
  return names;
}

std::string suite_text(const PlanOptions& o) {
  std::string text = o.suite;
  const auto add = [&](std::string_view name, const std::string& value) {
    if (!value.empty()) text += fmt::format(" {}={}", name, value);
  };
  add("methods", o.methods), add("problems", o.problems), add("set", o.settings);
  add("dt", fmt::format("{}", fmt::join(o.dts, ","))),
      add("tol", fmt::format("{}", fmt::join(o.tolerances, ",")));
  add("scalar", o.scalars);
  if (o.filter != default_filter.id) add("filter", o.filter);
  if (o.compensated) text += " compensated";
  return text;
}

std::vector<long> step_ladder(const AnyProblem& problem, int rungs, long most_steps) {
  const double interval = problem.t_end - problem.t_begin;
  const double wished = interval / (8 * problem.suggested_dt);
  long count = 16 * std::max(1L, static_cast<long>(std::lround(wished / 16)));
  // rates too fast for fixed steps at any price: what becomes of affordable ones is a result too
  if (count > most_steps) count = std::max(16L, most_steps >> (rungs - 1));
  std::vector<long> ladder;
  for (int i = 0; i < rungs && count <= most_steps; ++i, count *= 2) ladder.push_back(count);
  return ladder;
}

std::vector<PlannedRun> make_plan(const Registry& registry, const PlanOptions& options) {
  const Suite& suite = find_suite(options.suite);
  const auto methods = methods_of(registry, suite, options);
  const auto problems = options.problems.empty()
                            ? problems_of(registry, suite.problems, options.settings)
                            : select_problems(registry, options.problems, options.settings);
  const auto scalars = scalars_of(options.scalars.empty() ? "double" : options.scalars);
  std::vector<PlannedRun> plan;
  for (const auto& problem : problems) {
    const auto shared = std::make_shared<const AnyProblem>(problem);
    std::vector<long> counts;
    for (const double dt : options.dts) counts.push_back(steps_for(problem, dt));
    if (options.dts.empty() && options.tolerances.empty() && !suite.adaptive_only)
      counts = step_ladder(problem, suite.rungs, suite.most_steps);
    std::vector<double> tolerances = options.tolerances;
    if (options.dts.empty() && options.tolerances.empty())
      for (int digits = suite.adaptive_only ? 2 : 3; digits <= suite.finest_tolerance; ++digits)
        tolerances.push_back(std::pow(10.0, -digits));
    for (const double tolerance : tolerances)
      if (!(tolerance > 0) || !(tolerance < 1))
        throw BadInput(fmt::format("tol={:g} is no tolerance: it must lie between 0 and 1", tolerance));
    for (const AnyMethod* method : methods)
      for (const ScalarType scalar : scalars) {
        RunRequest request = base_request(options, suite, suite.timing);
        request.scalar = scalar;
        request.compensated = options.compensated;
        if (method->takes_fixed_steps)
          for (const long count : counts) {
            request.steps = count;
            plan.push_back({method, shared, request, "convergence"});
          }
        request.steps.reset();
        request.compensated = false;
        if (method->takes_error_control)
          for (const double tolerance : tolerances) {
            // a method of order p needs about 10^(digits / p) steps: the lowest orders stop where they only
            // burn time
            if (options.tolerances.empty() && tolerance < std::pow(10.0, -3.5 - 2 * method->order)) continue;
            request.rtol = tolerance;
            request.step_sizes = suite.adaptive_only;
            if (suite.adaptive_only) request.step_limit = suite.most_steps;
            // beyond 1e-9 hardly a local solution is known well enough
            request.local_errors =
                suite.adaptive_only && tolerance > 1e-10 && std::lround(-std::log10(tolerance)) % 3 == 0;
            // the listing has no first step of its own: it is called with the frame's dt
            if (method->kind == "chapter listing") request.first_step = 8 * problem.suggested_dt;
            plan.push_back({method, shared, request, "work_precision", suite.adaptive_only});
          }
      }
  }
  // codes are compared at the same tolerance: those runs are neighbours in time, so that drift of the machine
  // hits all
  if (suite.adaptive_only)
    for (auto first = plan.begin(); first != plan.end();) {
      const auto last =
          std::find_if(first, plan.end(), [&](const PlannedRun& p) { return p.problem != first->problem; });
      std::stable_sort(first, last, [](const PlannedRun& a, const PlannedRun& b) {
        return a.request.rtol.value_or(1) > b.request.rtol.value_or(1);
      });
      first = last;
    }
  if (options.dts.empty() && options.tolerances.empty() && options.scalars.empty() && !options.compensated &&
      options.problems.empty() && !suite.adaptive_only)
    for (const auto& problem : problems_of(registry, suite.precision)) {
      const auto shared = std::make_shared<const AnyProblem>(problem);
      for (const AnyMethod* method : methods)
        for (const ScalarType scalar :
             {ScalarType::float_type, ScalarType::double_type, ScalarType::long_double_type})
          for (const bool compensated : {false, true}) {
            if (method->provider != "odemark" || !method->takes_fixed_steps ||
                (compensated && !method->compensated))
              continue;
            RunRequest request = base_request(options, suite, false);
            request.scalar = scalar, request.compensated = compensated, request.trajectory = false;
            for (const long count : step_ladder(problem, suite.precision_rungs, suite.most_steps)) {
              request.steps = count;
              plan.push_back({method, shared, request, "precision"});
            }
          }
    }
  // whatever the patterns and ladders: nothing runs twice, ids are unique in a results file
  std::set<std::string> ids;
  std::erase_if(plan, [&](const PlannedRun& p) {
    return !ids.insert(row_id(*p.method, *p.problem, p.request, p.plan)).second;
  });
  if (plan.empty())
    throw BadInput(options.tolerances.empty()
                       ? "nothing to run: these methods choose their own steps; give --tol instead of --dt"
                       : "nothing to run: these methods have no error control; give --dt instead of --tol");
  return plan;
}

}  // namespace odemark
