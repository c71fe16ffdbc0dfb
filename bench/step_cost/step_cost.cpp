#include "bench/step_cost/step_cost.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <regex>

#include "bench/machine.hpp"
#include "bench/plan.hpp"
#include "bench/static_run.hpp"
#include "bench/step_cost/keep.hpp"
#include "bench/step_cost/tax.hpp"

namespace odemark {

namespace {

/// Google Benchmark's console without its header: Debian's library calls itself a DEBUG build because it was
/// compiled without NDEBUG, which has nothing to do with the code that is timed.
class QuietHeader : public benchmark::ConsoleReporter {
 public:
  QuietHeader() : ConsoleReporter(OO_Tabular) {}
  bool ReportContext(const Context& context) override {
    fmt::print("{}\n", headline(describe_machine()));
    name_field_width_ = context.name_field_width;
    return true;
  }
};

/// What one benchmark runs; shared by its repetitions.
struct Case {
  const AnyMethod* method;
  std::shared_ptr<const AnyProblem> problem;
  RunRequest request;
  const StaticRun* inlined;
};

void run_case(benchmark::State& state, const Case& c) {
  const Row row = run(*c.method, *c.problem, c.request, "bench");
  if (row.status != "reached_end") {
    // never a non-finite counter: the library would write it as bare NaN, which is no JSON
    state.SkipWithError(fmt::format("{} at t = {:g}", row.status, row.t_reached).c_str());
    return;
  }
  const FixedSteps control{*c.request.steps};
  std::vector<double> y = c.problem->initial;
  for (auto _ : state) {
    std::copy(c.problem->initial.begin(), c.problem->initial.end(), y.begin());
    if (c.inlined)
      c.inlined->solve(c.problem->value.get(), control, c.problem->t_begin, c.problem->t_end, y.data());
    else
      c.method->runs<double>().solve(c.problem->system<double>(), control, c.problem->t_begin,
                                     c.problem->t_end, y);
    keep(y[0]);
  }
  const double steps = static_cast<double>(*c.request.steps);
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * *c.request.steps);
  state.counters["per_step"] =
      benchmark::Counter(steps, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["evaluations_per_step"] = static_cast<double>(row.work.evaluations) / steps;
  std::string label = c.inlined ? "static" : "erased";
  if (row.errors && std::isfinite(row.errors->scaled)) {
    state.counters["error"] = row.errors->scaled;
    label += fmt::format(" error={:.2e}", row.errors->scaled);
  }
  state.SetLabel(label);
}

/// The names of all.
std::vector<std::string> register_cases(const Registry& registry) {
  std::vector<std::string> names;
  for (const auto& id : {"drag_ship", "oscillator", "damped_spring", "stiff_spring", "pendulum",
                         "free_rigid_body", "kepler_e06", "van_der_pol", "lorenz63"}) {
    const auto problem = std::make_shared<const AnyProblem>(find_problem(registry.families, id));
    const long steps = step_ladder(*problem, 4).back();
    for (const auto& method : registry.methods) {
      if (!method.takes_fixed_steps || !method.runs<double>().solve ||
          !missing_ability(method.needs, problem->abilities).empty())
        continue;
      Case c{&method, problem, {}, find_static_run(problem->family, method.id)};
      c.request.steps = steps;
      c.request.trajectory = false;
      const std::string name = fmt::format("{}/{}/steps:{}", problem->id, method.id, steps);
      benchmark::RegisterBenchmark(name.c_str(), [c](benchmark::State& state) { run_case(state, c); });
      names.push_back(name);
    }
  }
  return names;
}

/// Why --benchmark_filter chooses nothing, which the library says and then ends as if all were well; empty:
/// it chooses some. Its patterns are extended regular expressions, a "-" in front inverts one, and "all" is
/// all.
std::string fault_of_filter(const std::vector<std::string>& arguments,
                            const std::vector<std::string>& names) {
  constexpr std::string_view flag = "--benchmark_filter=";
  const auto last = std::find_if(arguments.rbegin(), arguments.rend(),
                                 [&](const std::string& a) { return a.starts_with(flag); });
  if (last == arguments.rend()) return "";
  std::string pattern = last->substr(flag.size());
  if (pattern.empty() || pattern == "all") return "";
  const bool inverted = pattern.front() == '-';
  if (inverted) pattern.erase(0, 1);
  try {
    const std::regex expression(pattern, std::regex::extended);
    if (std::any_of(names.begin(), names.end(),
                    [&](const std::string& name) { return std::regex_search(name, expression) != inverted; }))
      return "";
  } catch (const std::regex_error&) {
    return fmt::format("{} is no regular expression", *last);
  }
  return fmt::format("{} matches none of the {} benchmarks: --benchmark_list_tests shows their names", *last,
                     names.size());
}

constexpr const char* help =
    "odemark bench [--tax] [--benchmark_...]\n"
    "cost per step of every method on nine scenes; --benchmark_filter=REGEX chooses by names like "
    "oscillator/rk4/steps:256\n"
    "--tax            what the engine costs beyond a loop written by hand and beyond Boost.odeint; stands "
    "alone\n"
    "The flags of Google Benchmark:\n";

int print_tax() {
  fmt::print("{}\n", headline(describe_machine()));
  const auto results = measure_tax(tax_cells(), 201, 5'000);
  fmt::print("{}", tax_table(results));
  const auto faults = tax_faults(results);
  for (const auto& fault : faults) fmt::print("{}\n", fault);
  if (faults.empty())
    fmt::print("every cell within 1.10 of the hand-written loop and 1.03 of Boost.odeint\n");
  return 0;
}

}  // namespace

int step_cost_main(const std::vector<std::string>& arguments, const Registry& registry) {
  if (std::find(arguments.begin(), arguments.end(), "--tax") != arguments.end()) {
    if (arguments.size() == 1) return print_tax();
    fmt::print(stderr, "odemark bench: --tax stands alone\n");
    return 2;
  }
  const auto names = register_cases(registry);
  if (const std::string fault = fault_of_filter(arguments, names); !fault.empty()) {
    fmt::print(stderr, "odemark: {}\n", fault);
    return 2;
  }
  std::vector<std::string> owned{"odemark_bench"};
  owned.insert(owned.end(), arguments.begin(), arguments.end());
  for (auto& text : owned)
    if (text == "-h") text = "--help";
  if (std::find(owned.begin(), owned.end(), "--help") != owned.end()) {
    fmt::print("{}", help);
    std::fflush(stdout);  // the library prints the rest and ends the program
  }
  std::vector<char*> argv;
  for (auto& text : owned) argv.push_back(text.data());
  int argc = static_cast<int>(argv.size());
  const bool console = std::none_of(arguments.begin(), arguments.end(), [](const std::string& a) {
    return a.starts_with("--benchmark_format=") && a != "--benchmark_format=console";
  });
  const RunHeader header = describe_machine();
  benchmark::AddCustomContext("odemark", version_text());
  benchmark::AddCustomContext("odemark_build",
                              header.compiler + " " + header.build_type + " " + header.flags);
  benchmark::Initialize(&argc, argv.data());
  if (benchmark::ReportUnrecognizedArguments(argc, argv.data())) return 2;
  QuietHeader reporter;
  const std::size_t matched =
      console ? benchmark::RunSpecifiedBenchmarks(&reporter) : benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return matched > 0 ? 0 : 2;
}

}  // namespace odemark
