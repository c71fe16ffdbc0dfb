// odemark stability: the largest stable dt, and what a dt of the user's does.
#include "bench/stability.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bench/cli/commands.hpp"
#include "bench/cli/progress.hpp"
#include "bench/json_line.hpp"
#include "reference/bad_input.hpp"
#include "reports/format.hpp"
#include "reports/table.hpp"

namespace odemark {

namespace {

std::string optional_text(const std::optional<double>& x, int digits = 7) {
  return x ? significant(*x, digits) : std::string(no_value);
}

Table limits_table(const std::vector<StabilityRow>& rows) {
  Table table;
  table.title = "Largest stable dt";
  table.columns = {{"problem"},
                   {"method"},
                   {"verdict"},
                   {"measured", Align::right, "s"},
                   {"theory", Align::right, "s"},
                   {"difference", Align::right, "s"},
                   {"growth", Align::right, "1/s"},
                   {"at dt", Align::right, "s"},
                   {"reason"}};
  for (const auto& r : rows)
    table.rows.push_back({{r.problem},
                          {r.method},
                          {r.verdict},
                          {optional_text(r.measured)},
                          {optional_text(r.theory)},
                          {r.difference ? scientific(*r.difference, 1) : std::string(no_value)},
                          {optional_text(r.growth_per_second, 4)},
                          {significant(r.reference_dt, 4)},
                          {r.reason}});
  return table;
}

/// What a second of steps leaves of the slowest-dying motion, "x 0.98", or makes of the fastest-growing one,
/// "x 17.5"; from ln(amplitude) per second, which for an explosion may be beyond what a double holds.
std::string factor_text(double growth_per_second) {
  if (std::isnan(growth_per_second)) return std::string(no_value);
  const double decades = growth_per_second / std::log(10.0);
  if (std::abs(decades) > 100 && std::isfinite(decades)) return fmt::format("x 10^{:.0f}", decades);
  const double factor = std::exp(growth_per_second);
  const double change = std::abs(std::expm1(growth_per_second));
  return "x " + (change < 1e-9   ? "1"
                 : change < 0.01 ? fmt::format("{:.9g}", factor)
                                 : significant(factor, 3));
}

/// "Will it explode at my dt?", one line per method.
Table verdict_table(const std::vector<AnyMethod>& methods, const AnyProblem& problem, double dt) {
  Table table;
  table.title = fmt::format("{} at dt = {:g} s ({:g} Hz)", problem.id, dt, 1 / dt);
  table.columns = {{"method"},
                   {"verdict"},
                   {"limit", Align::right, "s"},
                   {"limit/dt", Align::right},
                   {"amplitude, per second", Align::right},
                   {"substeps needed", Align::right},
                   {"reason"}};
  for (const auto& method : methods) {
    const DtVerdict v = check_dt(method, problem, dt);
    const bool stable = v.verdict == "stable";
    const std::string limit = v.unlimited ? "none"
                              : v.limit   ? (*v.limit > 0 ? significant(*v.limit, 6) : "unstable at every dt")
                                          : std::string(no_value);
    table.rows.push_back({{std::string(method.id)},
                          {v.verdict, stable                    ? Status::ok
                                      : v.verdict == "unstable" ? Status::fail
                                                                : Status::muted},
                          {limit},
                          {v.unlimited ? std::string(no_value) : optional_text(v.margin, 4)},
                          {v.verdict == "blank" ? std::string(no_value) : factor_text(v.growth_per_second)},
                          {v.substeps                ? fmt::format("{}", *v.substeps)
                           : v.verdict == "unstable" ? "none is enough"
                                                     : std::string(no_value)},
                          {v.reason}});
  }
  return table;
}

void print(const Table& table, const std::string& format) {
  if (format == "markdown")
    fmt::print("{}", to_markdown(table));
  else if (format == "csv")
    fmt::print("{}", to_csv(table));
  else
    fmt::print("{}", to_text(table));
}

}  // namespace

int stability_command(const Registry& registry, const StabilityCommandOptions& options) {
  std::vector<AnyMethod> methods;
  for (const auto* method : select_methods(registry, options.methods)) methods.push_back(*method);
  if (options.dt > 0) {
    if (options.problem.empty())
      throw BadInput(
          "--dt asks about one problem: name it, like --problem damped_spring --set k=6e5,m=168,zeta=0.1");
    const AnyProblem problem = find_problem(registry.families, options.problem, options.settings);
    if (problem.is_large())
      throw BadInput(
          fmt::format("{} has {} components: stability limits are measured on matrices, of up to {}",
                      problem.id, problem.size(), largest_compared_size));
    if (!problem.homogeneous)
      throw BadInput(
          fmt::format("{} is not linear, so no single dt is its limit: linear problems are dahlquist, "
                      "oscillator, damped_spring, "
                      "stiff_spring and drag_ship",
                      problem.id));
    if (options.format == "json") {
      for (const auto& method : methods) {
        const DtVerdict v = check_dt(method, problem, options.dt);
        const auto number = [](const std::optional<double>& x) {
          return x && std::isfinite(*x) ? fmt::format("{}", *x) : std::string("null");
        };
        fmt::print(
            "{{\"problem\":\"{}\",\"method\":\"{}\",\"dt\":{},\"verdict\":\"{}\",\"unlimited\":{},\"limit\":{"
            "},\"margin\":{},"
            "\"growth_per_second\":{},\"substeps\":{}}}\n",
            problem.id, method.id, options.dt, v.verdict, v.unlimited, number(v.limit), number(v.margin),
            number(v.growth_per_second), v.substeps ? fmt::format("{}", *v.substeps) : "null");
      }
      return exit_ok;
    }
    print(verdict_table(methods, problem, options.dt), options.format);
    return exit_ok;
  }
  if (options.problem.empty() && !options.settings.empty())
    throw BadInput("--set needs --problem: whose parameters are they?");
  const auto problems = options.problem.empty()
                            ? default_stability_problems()
                            : select_problems(registry, options.problem, options.settings);
  std::vector<StabilityRow> rows;
  {
    Progress progress("stability limits", options);
    StabilityOptions measure;
    measure.jobs = static_cast<unsigned>(options.jobs);
    measure.progress = [&](std::size_t done, std::size_t total, const StabilityRow& row) {
      progress.update(done, total, row.problem + "/" + row.method);
    };
    rows = measure_stability(methods, problems, measure);
  }
  if (options.format == "json")
    for (const auto& row : rows) fmt::print("{}\n", to_json_line(row));
  else
    print(limits_table(rows), options.format);
  const auto faults = stability_faults(rows);
  for (const auto& fault : faults) fmt::print(stderr, "odemark: {}\n", fault);
  return faults.empty() ? exit_ok : exit_violated;
}

}  // namespace odemark
