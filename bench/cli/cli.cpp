// The command line: what may be said, and which exit code an ending has.
#include <fmt/format.h>
#include <signal.h>

#include <CLI/CLI.hpp>
#include <map>

#include "bench/cli/commands.hpp"
#include "bench/cli/files.hpp"
#include "bench/cli/ladder.hpp"
#include "bench/cli/mistakes.hpp"
#include "bench/cli/truth_options.hpp"
#include "bench/json_line.hpp"
#include "bench/machine.hpp"
#include "reference/bad_input.hpp"
#include "reference/truth.hpp"

namespace odemark {

namespace {

std::atomic<bool> interrupted{false};

void on_interrupt(int) {
  interrupted = true;
  signal(SIGINT, SIG_DFL);  // a second Ctrl-C ends the program at once
}

void add_common(CLI::App& command, CommonOptions& options) {
  command.add_flag("-q,--quiet", options.quiet, "results only, no progress");
  static const std::map<std::string, ProgressStyle> styles{{"auto", ProgressStyle::automatic},
                                                           {"bar", ProgressStyle::bar},
                                                           {"lines", ProgressStyle::lines},
                                                           {"none", ProgressStyle::none}};
  command
      .add_option_function<std::string>(
          "--progress", [&options](const std::string& name) { options.progress = styles.at(name); },
          "auto (default), bar, lines or none; on stderr")
      ->check(one_of("style of progress", {"auto", "bar", "lines", "none"}))
      ->option_text("STYLE");
}

CLI::Option* add_format(CLI::App& command, std::string& format, const std::vector<std::string>& formats) {
  return command
      .add_option("--format", format, fmt::format("{} (default: {})", fmt::join(formats, ", "), format))
      ->check(one_of("format", formats))
      ->option_text("FORMAT");
}

}  // namespace

int odemark_main(int argc, char** argv, const Registry& registry) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  // Google Benchmark reads its own flags; they must not be judged here
  const bool benchmark_flag = std::any_of(arguments.begin(), arguments.end(),
                                          [](const std::string& a) { return a.starts_with("--benchmark_"); });
  if (!arguments.empty() && (arguments[0] == "bench" || (benchmark_flag && arguments[0].starts_with("--"))))
    return bench_command({arguments.begin() + (arguments[0] == "bench" ? 1 : 0), arguments.end()});

  CLI::App app(
      "Which time integrator, and which dt: error, stability boundaries and cost per step, measured.",
      "odemark");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 ran, 1 a threshold violated, 2 usage, 3 gate incomplete, 4 a case failed where a result "
      "was required, 130 interrupted.");

  RunOptions run;
  std::string dt_text, tol_text;
  auto& run_app = *app.add_subcommand("run", "measure error, work and time; rows stream to results.jsonl");
  run_app.add_option("-s,--suite", run.plan.suite, fmt::format("{}", fmt::join(suite_names(), ", ")))
      ->option_text("NAME");
  run_app.add_option("--methods", run.plan.methods, "ids with commas; * and ? match")
      ->check(something())
      ->option_text("LIST");
  run_app.add_option("--problems", run.plan.problems, "presets or families with commas; * and ? match")
      ->check(something())
      ->option_text("LIST");
  run_app.add_option("--set", run.plan.settings, "parameters of the problems, like k=6e5,m=168,zeta=0.1")
      ->option_text("SETTINGS");
  run_app
      .add_option("--dt", dt_text,
                  "step sizes with commas, 1/30,1/60, or start:ratio:count: 0.1:0.5:10 is ten of them from "
                  "0.1 on, each half the one before")
      ->check(something())
      ->option_text("LADDER");
  run_app
      .add_option("--tol", tol_text,
                  "tolerances with commas, 1e-3,1e-6, or start:ratio:count: 1e-3:0.1:7 is 1e-3 to 1e-9")
      ->check(something())
      ->option_text("LADDER");
  run_app.add_option("--filter", run.plan.filter, "step-size filter: dead_band, elementary, pi or h211b")
      ->option_text("NAME");
  run_app.add_option("--scalar", run.plan.scalars, "float, double, long_double, with commas")
      ->check(something())
      ->option_text("LIST");
  run_app.add_flag("--compensated", run.plan.compensated,
                   "carry the rounding error of the state (fixed steps)");
  run_app.add_flag_callback(
      "--no-timing", [&] { run.plan.timing = false; }, "errors and work only");
  run_app.add_flag_callback(
      "--no-stability", [&] { run.stability = false; }, "leave out the stability limits");
  run_app
      .add_option("--time-limit", run.plan.time_limit_seconds,
                  fmt::format("seconds for one run (default: {:g})", run.plan.time_limit_seconds))
      ->check(above_zero("seconds"))
      ->option_text("S");
  run_app.add_option("-j,--jobs", run.jobs, "threads for the errors; times are always taken one by one")
      ->check(whole_number("jobs", 1, 256))
      ->option_text("N");
  run_app.add_flag("--resume", run.resume, "keep the rows that are there and go on");
  run_app.add_option("-o,--output", run.output, "folder of results.jsonl (default: out)")
      ->check(something())
      ->option_text("DIR");
  add_common(run_app, run);

  ReportOptions report;
  auto& report_app = *app.add_subcommand(
      "report", "report.html, chapter.html, methods.html, SVG, Markdown and CSV from results.jsonl");
  report_app
      .add_option("-o,--output", report.output, "folder of results.jsonl and of the report (default: out)")
      ->option_text("DIR");
  report_app.add_option("--title", report.title, "title of the report")->option_text("TEXT");
  report_app
      .add_option("--pages", report.pages,
                  "pages of methods and families: all, or those of the results (used); default: used where "
                  "the run chose some, else all")
      ->check(one_of("choice of pages", {"all", "used", "auto"}))
      ->option_text("WHICH");
  add_common(report_app, report);

  CheckCommandOptions check;
  auto& check_app = *app.add_subcommand("check", "gate results on thresholds.toml and baseline.json");
  check_app.add_option("-o,--output", check.output, "folder of results.jsonl (default: out)")
      ->option_text("DIR");
  check_app
      .add_option("--thresholds", check.thresholds,
                  "what people demand (default: thresholds.toml); a rule whose case matches nothing that was "
                  "run makes the gate incomplete, unless it says optional = true")
      ->option_text("FILE");
  check_app
      .add_option("--baseline", check.baseline,
                  "written by `odemark approve` (default: baseline.json, which may be missing)")
      ->option_text("FILE");
  check_app.add_option("--junit", check.junit, "write JUnit XML")->option_text("FILE");
  check_app.add_option("--markdown", check.markdown, "write a summary for a pull request")
      ->option_text("FILE");
  check_app.add_option("--json", check.json, "write the findings as JSON")->option_text("FILE");
  check_app.add_flag("--github", check.github, "print workflow annotations");
  check_app.add_flag("--strict", check.strict, "final bits must equal the baseline's");
  add_common(check_app, check);

  ApproveCommandOptions approve;
  auto& approve_app = *app.add_subcommand("approve", "make these results the baseline");
  approve_app.add_option("-o,--output", approve.output, "folder of results.jsonl (default: out)")
      ->option_text("DIR");
  approve_app.add_option("--baseline", approve.baseline, "the file to write (default: baseline.json)")
      ->option_text("FILE");
  approve_app.add_option("--only", approve.only, "regular expression on cases: kepler.*/rk4")
      ->option_text("REGEX");
  approve_app.add_option("--reason", approve.reason, "why the numbers changed")
      ->required()
      ->option_text("TEXT");
  approve_app.add_flag("--dry-run", approve.dry_run, "show the changes, write nothing");
  approve_app.add_flag("--force", approve.force, "even where CI is set, and over a damaged baseline");
  add_common(approve_app, approve);

  CompareCommandOptions compare;
  auto& compare_app = *app.add_subcommand("compare", "before and after: errors, orders, work, times");
  compare_app
      .add_option("files", compare.files, "results.jsonl files or folders of them, the first is before")
      ->required()
      ->expected(2, 100)
      ->option_text("FILE FILE ...");
  compare_app.add_option("--only", compare.only, "changed (default), regressed, improved or all")
      ->check(one_of("filter", {"regressed", "improved", "changed", "all"}))
      ->option_text("WHICH");
  add_format(compare_app, compare.format, {"table", "markdown", "json"});

  ListOptions list;
  auto& list_app = *app.add_subcommand("list", "methods, problems and suites");
  list_app.add_flag("--methods", list.methods, "methods only");
  list_app.add_flag("--problems", list.problems, "problems only");
  list_app.add_flag("--suites", list.suites, "suites only");
  add_format(list_app, list.format, {"table", "json", "names"});

  MethodsCommandOptions methods;
  auto& methods_app = *app.add_subcommand(
      "methods", "facts of methods: order, intervals, kinds of stability, proved or measured");
  methods_app.add_option("names", methods.names, "ids; * and ? match; default: all of the suite")
      ->option_text("NAME...");
  methods_app.add_flag("--measured", methods.measured, "measure them on the compiled steps too");
  add_format(methods_app, methods.format, {"table", "json"});
  add_common(methods_app, methods);

  StabilityCommandOptions stability;
  std::string stability_dt;
  auto& stability_app =
      *app.add_subcommand("stability", "largest stable dt: measured, in theory, and what a dt of yours does");
  stability_app.add_option("--problem", stability.problem, "a linear problem; default: the suite's")
      ->option_text("ID");
  stability_app.add_option("--set", stability.settings, "its parameters, like k=6e5,m=168,zeta=0.1")
      ->option_text("SETTINGS");
  stability_app.add_option("--methods", stability.methods, "ids with commas; * and ? match")
      ->check(something())
      ->option_text("LIST");
  stability_app
      .add_option("--dt", stability_dt,
                  "your dt, like 1/60: verdict, margin, what becomes of the amplitude, substeps")
      ->option_text("DT");
  stability_app.add_option("-j,--jobs", stability.jobs, "threads")
      ->check(whole_number("jobs", 1, 256))
      ->option_text("N");
  add_format(stability_app, stability.format, {"table", "json", "markdown", "csv"});
  add_common(stability_app, stability);

  TruthCommandOptions truth;
  std::vector<std::string> truth_presets;
  std::string truth_t, truth_format = "text";
  auto& truth_app =
      *app.add_subcommand("truth", "the solution to many digits, by two independent computations");
  add_truth_options(truth_app, truth, truth_presets, truth_t);
  add_format(truth_app, truth_format, {"text", "json"});
  add_common(truth_app, truth);

  app.add_subcommand("bench",
                     "cost per step by Google Benchmark: every --benchmark_* flag works; --tax: what the "
                     "engine itself costs");
  DoctorOptions doctor;
  auto& doctor_app = *app.add_subcommand("doctor", "what affects the numbers on this machine");
  add_format(doctor_app, doctor.format, {"text", "json"});

  try {
    require_unique_names(registry);
    if (!arguments.empty() && !arguments[0].starts_with("-")) {
      std::vector<std::string> commands;
      for (const auto* command : app.get_subcommands([](CLI::App*) { return true; }))
        commands.push_back(command->get_name());
      if (std::find(commands.begin(), commands.end(), arguments[0]) == commands.end())
        throw BadInput(fmt::format("there is no command \"{}\"{}: the commands are {}", arguments[0],
                                   suggestion(arguments[0], commands), fmt::join(commands, ", ")));
    }
    app.parse(argc, argv);
    check.baseline_named = check_app.count("--baseline") > 0;
    run.plan.dts = dt_text.empty() ? std::vector<double>{} : parse_ladder("--dt", dt_text);
    run.plan.tolerances = tol_text.empty() ? std::vector<double>{} : parse_ladder("--tol", tol_text);
    if (!stability_dt.empty()) {
      stability.dt = parse_number("--dt", stability_dt);
      if (!(stability.dt > 0))
        throw BadInput(fmt::format("--dt {} is no step: it must be above 0", stability_dt));
    }
    if (!truth_t.empty()) truth.request.t = truth_t;
    truth.request.json = truth_format == "json";
    if (app.got_subcommand("truth")) settle_truth(truth, truth_presets);
    signal(SIGINT, on_interrupt);
    signal(SIGTERM, on_interrupt);
    if (app.got_subcommand("run")) return run_command(registry, run, interrupted);
    if (app.got_subcommand("report")) return report_command(registry, report);
    if (app.got_subcommand("check")) return check_command(check);
    if (app.got_subcommand("approve")) return approve_command(approve);
    if (app.got_subcommand("compare")) return compare_command(compare);
    if (app.got_subcommand("list")) return list_command(registry, list);
    if (app.got_subcommand("methods")) return methods_command(registry, methods);
    if (app.got_subcommand("stability")) return stability_command(registry, stability);
    if (app.got_subcommand("truth")) return truth_command(registry, truth, interrupted);
    if (app.got_subcommand("doctor")) return doctor_command(doctor);
    return exit_usage;
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    const std::string unexpected = unexpected_words(app);
    fmt::print(stderr, "odemark: {}\n", unexpected.empty() ? e.what() : unexpected);
    return exit_usage;
  } catch (const BadInput& e) {
    fmt::print(stderr, "odemark: {}\n", e.what());
    return exit_usage;
  } catch (const BadResults& e) {
    fmt::print(stderr, "odemark: {}\n", e.what());
    return exit_usage;
  } catch (const TruthUnavailable& e) {
    fmt::print(stderr, "odemark: {}\n", e.what());
    return exit_failed;
  } catch (const std::exception& e) {
    fmt::print(stderr, "odemark: {}\n", e.what());
    return exit_failed;
  }
}

}  // namespace odemark
