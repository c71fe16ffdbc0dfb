// odemark report: everything that can be read off a results file, as files beside it.
#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "bench/chapter.hpp"
#include "bench/cli/commands.hpp"
#include "bench/cli/files.hpp"
#include "bench/cli/progress.hpp"
#include "bench/cli/report_files.hpp"
#include "bench/json_line.hpp"
#include "bench/method_sheets.hpp"
#include "bench/pictures.hpp"
#include "bench/problem_sheets.hpp"
#include "reference/bad_input.hpp"

namespace odemark {

namespace {

/// Facts of every method and family take half a minute: who ran a few wants those few.
Registry pages_of(const Registry& registry, const Results& results, const std::string& pages) {
  const bool chosen = results.header.suite.find(' ') != std::string::npos;
  if (pages == "all" || (pages == "auto" && !chosen)) return registry;
  std::set<std::string, std::less<>> methods, families;
  for (const Row& row : results.rows) methods.insert(row.method), families.insert(row.family);
  for (const StabilityRow& row : results.stability) methods.insert(row.method), families.insert(row.family);
  Registry used;
  for (const auto& method : registry.methods)
    if (methods.contains(method.id)) used.methods.push_back(method);
  for (const auto& family : registry.families)
    if (families.contains(family.id)) used.families.push_back(family);
  return used;
}

}  // namespace

int report_command(const Registry& registry, const ReportOptions& options) {
  Results results = read_results((std::filesystem::path(options.output) / "results.jsonl").string());
  require_writable_folder(options.output);
  for (const char* name : {"report.html", "chapter.html", "methods.html", "problems.html", "report.md"})
    if (const auto path = std::filesystem::path(options.output) / name; std::filesystem::is_directory(path))
      throw BadInput(fmt::format("cannot write {}: it is a folder", path.string()));
  const Registry shown = pages_of(registry, results, options.pages);
  Pictures pictures = make_pictures(registry, results.rows);
  std::vector<FactSheet> methods;
  {
    Progress progress("facts of methods", options);
    methods = method_sheets(shown.methods,
                            [&](std::size_t done, std::size_t total) { progress.update(done, total, ""); });
  }
  std::vector<ProblemSheet> problems;
  {
    Progress progress("problems", options);
    problems = problem_sheets(registry, shown.families,
                              [&](std::size_t done, std::size_t total) { progress.update(done, total, ""); });
  }
  fmt::print("{}\n", write_report(std::move(results), std::move(pictures), chapter_data(), methods, problems,
                                  options.output, options.title));
  return exit_ok;
}

}  // namespace odemark
