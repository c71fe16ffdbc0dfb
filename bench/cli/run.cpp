// odemark run: the error and cost sweep, streamed to results.jsonl.
#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

#include "bench/cli/commands.hpp"
#include "bench/cli/files.hpp"
#include "bench/cli/progress.hpp"
#include "bench/cli/summary.hpp"
#include "bench/doctor.hpp"
#include "bench/execute.hpp"
#include "bench/json_line.hpp"
#include "bench/machine.hpp"
#include "bench/stability.hpp"
#include "reference/bad_input.hpp"

namespace odemark {

namespace {

/// Appends lines; every line is on its way to the disk before the next run begins.
class LineWriter {
 public:
  LineWriter(const std::string& path, bool append)
      : path_(path), file_(path, std::ios::binary | (append ? std::ios::app : std::ios::trunc)) {
    if (!file_) throw BadInput(fmt::format("cannot write {}: {}", path, std::strerror(errno)));
  }
  void write(const std::string& line) {
    file_ << line << '\n' << std::flush;
    if (!file_)
      throw CannotWrite(
          fmt::format("cannot write {}: {}; the rows before this are kept, --resume goes on from there",
                      path_, std::strerror(errno)));
  }

 private:
  std::string path_;
  std::ofstream file_;
};

/// What a resumed file holds already; an incomplete last line is cut off.
Results open_previous(const std::string& path, const std::string& suite) {
  Results previous = read_results(path);
  if (previous.header.suite != suite)
    throw BadInput(fmt::format(
        "{} holds suite \"{}\", not \"{}\": resume with the same arguments, or choose another folder with -o",
        path, previous.header.suite, suite));
  if (previous.cut) {
    const std::string all = read_file(path);
    write_file(path, std::string_view(all).substr(0, all.rfind('\n') + 1));
  }
  return previous;
}

/// A new run begins a new file: up to three earlier ones stay beside it, the latest as .previous.
void keep_previous(const std::string& path) {
  const std::array names{path, path + ".previous", path + ".previous2", path + ".previous3"};
  std::error_code ignored;
  for (std::size_t i = names.size() - 1; i > 0; --i)
    if (std::filesystem::exists(names[i - 1])) std::filesystem::rename(names[i - 1], names[i], ignored);
}

/// The linear ones of the problems that were asked for; where none were, the usual springs and the ship.
std::vector<AnyProblem> stability_problems(const Registry& registry, const PlanOptions& plan) {
  if (plan.problems.empty()) return default_stability_problems();
  return linear_problems(select_problems(registry, plan.problems, plan.settings));
}

}  // namespace

int run_command(const Registry& registry, const RunOptions& options, const std::atomic<bool>& stop) {
  if (options.jobs < 1 || options.jobs > 256)
    throw BadInput(fmt::format("-j {} is no number of jobs: 1 to 256", options.jobs));
  const auto plan = make_plan(registry, options.plan);
  require_writable_folder(options.output);
  const std::string path = (std::filesystem::path(options.output) / "results.jsonl").string();
  const bool resume = options.resume && std::filesystem::exists(path);
  RunHeader header = describe_machine();
  header.suite = suite_text(options.plan);
  header.footnotes = footnotes();
  Results results;
  if (resume)
    results = open_previous(path, header.suite);
  else
    keep_previous(path);
  LineWriter writer(path, resume);
  if (!resume) {
    writer.write(to_json_line(header));
    results.header = header;
  }

  if (!options.quiet)
    fmt::print(stderr, "{}\nsuite {}: {} runs\n", headline(header), options.plan.suite, plan.size());
  ExecuteOptions execute_options;
  execute_options.jobs = options.jobs;
  execute_options.stop = &stop;
  for (const auto& row : results.rows) execute_options.done.insert(row.id);
  execute_options.sink = [&](const Row& row) {
    writer.write(to_json_line(row));
    results.rows.push_back(row);
  };
  bool complete = true;
  {
    Progress progress("runs", options);
    execute_options.progress = [&](std::size_t done, std::size_t total, const std::string& what) {
      progress.update(done, total, what);
    };
    complete = execute(plan, execute_options);
  }
  if (complete && options.stability) {
    Progress progress("stability limits", options);
    StabilityOptions measure;
    measure.jobs = static_cast<unsigned>(options.jobs);
    measure.stop = &stop;
    for (const auto& row : results.stability) measure.done.insert(row.problem + "/" + row.method);
    measure.progress = [&](std::size_t done, std::size_t total, const StabilityRow& row) {
      writer.write(to_json_line(row));
      results.stability.push_back(row);
      progress.update(done, total, row.problem + "/" + row.method);
    };
    std::vector<AnyMethod> methods;
    for (const auto* method : select_methods(registry, options.plan.methods)) methods.push_back(*method);
    measure_stability(methods, stability_problems(registry, options.plan), measure);
    complete = !stop.load();
  }
  if (!complete) {
    fmt::print(stderr,
               "interrupted: {} runs and {} stability limits are in {}; `odemark run --resume` with the same "
               "arguments goes on\n",
               results.rows.size(), results.stability.size(), path);
    return exit_interrupted;
  }
  if (!options.quiet) fmt::print("{}", console_summary(results));
  fmt::print("wrote {} ({} runs, {} stability limits)\n", path, results.rows.size(),
             results.stability.size());
  return exit_ok;
}

}  // namespace odemark
