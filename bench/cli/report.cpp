// odemark report: everything that can be read off a results file, as files beside it.
#include <fmt/format.h>

#include <filesystem>

#include "bench/chapter.hpp"
#include "bench/cli/commands.hpp"
#include "bench/cli/files.hpp"
#include "bench/cli/progress.hpp"
#include "bench/cli/report_files.hpp"
#include "bench/json_line.hpp"
#include "bench/method_sheets.hpp"
#include "bench/pictures.hpp"
#include "bench/problem_sheets.hpp"

namespace odemark {

int report_command(const Registry& registry, const ReportOptions& options) {
  Results results = read_results((std::filesystem::path(options.output) / "results.jsonl").string());
  require_writable_folder(options.output);
  Pictures pictures = make_pictures(registry, results.rows);
  std::vector<FactSheet> methods;
  {
    Progress progress("facts of methods", options);
    methods = method_sheets(registry.methods,
                            [&](std::size_t done, std::size_t total) { progress.update(done, total, ""); });
  }
  std::vector<ProblemSheet> problems;
  {
    Progress progress("problems", options);
    problems = problem_sheets(registry,
                              [&](std::size_t done, std::size_t total) { progress.update(done, total, ""); });
  }
  fmt::print("{}\n", write_report(std::move(results), std::move(pictures), chapter_data(), methods, problems,
                                  options.output, options.title));
  return exit_ok;
}

}  // namespace odemark
