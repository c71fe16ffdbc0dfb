// odemark check, approve and compare: results against demands, against the baseline, against each other.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "bench/cli/commands.hpp"
#include "bench/cli/files.hpp"
#include "bench/json_line.hpp"
#include "reference/bad_input.hpp"
#include "reports/annotations.hpp"
#include "reports/check.hpp"
#include "reports/compare.hpp"
#include "reports/junit.hpp"

namespace odemark {

namespace {

std::string results_path(const std::string& folder) {
  return (std::filesystem::path(folder) / "results.jsonl").string();
}

std::optional<std::string> read_if_there(const std::string& path) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  return read_file(path);
}

std::string today() { return fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))); }

/// Sentences of the pure functions that are about what the user typed.
template <class F>
auto as_input(F&& f) {
  try {
    return f();
  } catch (const BadThresholds& e) {
    throw BadInput(e.what());
  } catch (const std::invalid_argument& e) {
    throw BadInput(e.what());
  }
}

void tell_cut(const std::string& path) {
  fmt::print(stderr,
             "odemark: the last line of {} is cut: the run was interrupted, `odemark run --resume` goes on\n",
             path);
}

nlohmann::ordered_json rows_json(const Table& table) {
  auto rows = nlohmann::ordered_json::array();
  for (const auto& row : table.rows) {
    nlohmann::ordered_json cells;
    for (std::size_t i = 0; i < row.size(); ++i) cells[table.columns[i].name] = row[i].text;
    rows.push_back(cells);
  }
  return rows;
}

}  // namespace

int check_command(const CheckCommandOptions& options) {
  const Results results = read_results(results_path(options.output));
  if (results.cut) tell_cut(results_path(options.output));
  for (const auto& path : {options.junit, options.markdown, options.json})
    if (!path.empty()) require_writable_file(path);
  const CheckResult result = as_input([&] {
    const Thresholds thresholds = parse_thresholds(read_file(options.thresholds), options.thresholds);
    const BaselineFile baseline = load_baseline(read_if_there(options.baseline), options.baseline);
    CheckOptions how;
    how.strict = options.strict;
    how.today = today();
    how.baseline_named = options.baseline_named;
    return check(results.rows, results.stability, thresholds, baseline, results.header, how);
  });
  fmt::print("{}", to_console(result));
  if (options.github) fmt::print("{}", to_github(result, options.thresholds));
  if (!options.junit.empty()) write_file(options.junit, to_junit(result));
  if (!options.markdown.empty()) write_file(options.markdown, to_markdown(result));
  if (!options.json.empty()) write_file(options.json, to_json(result));
  const int code = exit_code(result);
  if (code != exit_ok) {
    const std::string received = (std::filesystem::path(options.output) / "baseline.received.json").string();
    write_file(received, to_text(make_baseline(results.rows, results.header, "received")));
    fmt::print(
        stderr,
        "the numbers of this run are in {}; `odemark approve --reason \"...\"` makes them the baseline\n",
        received);
  }
  return code;
}

int approve_command(const ApproveCommandOptions& options) {
  if (std::getenv("CI") != nullptr && !options.force)
    throw BadInput(
        "approve changes what the gate demands, and CI is set: a person should do that, or --force");
  const Results results = read_results(results_path(options.output));
  if (results.cut)
    throw BadInput(
        fmt::format("{} is cut: finish the run with --resume first", results_path(options.output)));
  const Approval approval = as_input([&] {
    const BaselineFile old = load_baseline(read_if_there(options.baseline), options.baseline);
    if (old.damaged && !options.only.empty())
      throw BadInput(fmt::format("{}; approve everything, without --only", old.problem));
    if (old.damaged && !options.force)
      throw BadInput(fmt::format("{}; --force writes a new one over it", old.problem));
    return approve(results.rows, results.header, old.baseline, options.reason, options.only);
  });
  if (!options.dry_run) require_writable_file(options.baseline);
  if (!options.quiet) fmt::print("{}", to_text(approval.changes));
  fmt::print("{} added, {} changed, {} removed\n", approval.added, approval.changed, approval.removed);
  if (options.dry_run) return exit_ok;
  write_file(options.baseline, approval.text);
  fmt::print("wrote {}\n", options.baseline);
  return exit_ok;
}

int compare_command(const CompareCommandOptions& options) {
  std::vector<NamedRows> sets;
  for (const auto& name : options.files) {
    const std::string path = std::filesystem::is_directory(name) ? results_path(name) : name;
    Results results = read_results(path);
    if (results.cut) tell_cut(path);
    sets.push_back({name, std::move(results.rows), std::move(results.stability)});
  }
  const CompareFilter filter = options.only == "all"         ? CompareFilter::all
                               : options.only == "regressed" ? CompareFilter::regressed
                               : options.only == "improved"  ? CompareFilter::improved
                                                             : CompareFilter::changed;
  const Comparison comparison = as_input([&] { return compare(sets, filter); });
  if (options.format == "json") {
    const nlohmann::ordered_json j{{"regressed", comparison.regressed},
                                   {"improved", comparison.improved},
                                   {"changed", comparison.changed},
                                   {"same", comparison.same},
                                   {"runs", rows_json(comparison.runs)},
                                   {"limits", rows_json(comparison.limits)},
                                   {"one_side", rows_json(comparison.one_side)}};
    fmt::print("{}\n", j.dump(2));
  } else {
    for (const Table* table :
         {&comparison.runs, &comparison.orders, &comparison.limits, &comparison.one_side})
      if (!table->rows.empty())
        fmt::print("{}\n", options.format == "markdown" ? to_markdown(*table) : to_text(*table));
    fmt::print("{} regressed, {} improved, {} changed otherwise, {} the same, {} in one file only\n",
               comparison.regressed, comparison.improved, comparison.changed, comparison.same,
               comparison.one_side.rows.size());
  }
  return exit_ok;
}

}  // namespace odemark
