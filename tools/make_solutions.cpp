// Makes reference/solutions: `odemark_make_solutions [--only PRESET]... [--into DIR] [-j N]`. What it made,
// `odemark truth --verify` checks.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <thread>

#include "reference/bad_input.hpp"
#include "reference/truth_store.hpp"
#include "reference/truth_wide.hpp"

namespace {

using namespace odemark;

struct Arguments {
  std::vector<std::string> only;
  std::filesystem::path into = "reference/solutions";
  unsigned threads = 2;
};

std::size_t count_of(const std::string& option, const std::string& text) {
  std::size_t count = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), count);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size() || count == 0)
    throw BadInput(option + " takes a positive whole number, not \"" + text + "\"");
  return count;
}

Arguments parse(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto value = [&]() -> const std::string& {
      if (i + 1 >= words.size()) throw BadInput(words[i] + " needs a value");
      return words[++i];
    };
    if (words[i] == "--only")
      arguments.only.push_back(value());
    else if (words[i] == "--into")
      arguments.into = value();
    else if (words[i] == "-j")
      arguments.threads = unsigned(std::min<std::size_t>(count_of("-j", value()), 256));
    else
      throw BadInput("unknown option " + words[i] + ": there are --only PRESET, --into DIR and -j N");
  }
  return arguments;
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  const auto temporary = path.string() + ".new";
  std::ofstream file(temporary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + temporary);
  std::filesystem::rename(temporary, path);
}

/// As many digits as can be had: 36, else 30, else 25, else what a closed form claims that nobody could
/// check.
Truth best_truth(const AnyProblem& problem) {
  CertifyOptions options;
  options.time_limit_seconds = 3600;
  for (const int digits : {36, 30}) {
    options.digits = digits;
    try {
      return certify(problem, common_times(problem), options);
    } catch (const TruthUnavailable&) {
      // fewer, then
    }
  }
  options.digits = 25;
  try {
    return certify(problem, common_times(problem), options);
  } catch (const TruthUnavailable& why) {
    const WideProblem wide = widened(problem, false);
    if (!wide.exact || why.digits_reached > 0) throw;
    const auto times = common_times(problem);
    return unchecked_closed_form(problem, wide, {times.begin(), times.end()});
  }
}

/// What happened, in one line; throws where it went wrong.
std::string treat(const AnyProblem& problem, const Arguments& arguments) {
  if (problem.is_large()) return "large: not stored, its closed form is computed where it is needed";
  const auto path = arguments.into / (problem.preset + ".json");
  const std::string definition = fingerprint(problem, widened(problem, false));
  const Truth truth = best_truth(problem);
  write_file(path, to_json(truth, problem.preset, definition));
  return fmt::format("{} digits, {}, checked by {}, {:.2g} s", truth.digits, truth.origin, truth.checked_by,
                     truth.seconds);
}

int work(const Arguments& arguments) {
  std::vector<AnyProblem> problems;
  for (const auto& id : arguments.only.empty() ? problem_ids(suite_families()) : arguments.only)
    problems.push_back(find_problem(suite_families(), id));
  std::filesystem::create_directories(arguments.into);
  std::atomic<std::size_t> next = 0;
  std::size_t done = 0;
  int failures = 0;
  std::mutex mutex;
  const auto begin = std::chrono::steady_clock::now();
  const auto worker = [&] {
    for (std::size_t i; (i = next++) < problems.size();) {
      std::string line;
      bool good = true;
      try {
        line = treat(problems[i], arguments);
      } catch (const std::exception& fault) {
        line = fault.what(), good = false;
      }
      const std::lock_guard lock(mutex);
      failures += good ? 0 : 1;
      ++done;
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      const double rest = seconds / double(done) * double(problems.size() - done);
      std::cerr << fmt::format("[{}/{}, {:.0f} s, about {:.0f} s to go] {}{}: {}\n", done, problems.size(),
                               seconds, rest, good ? "" : "FAILED ", problems[i].preset, line);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < arguments.threads; ++i) threads.emplace_back(worker);
  for (auto& thread : threads) thread.join();
  return failures == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  try {
    return work(parse({words + 1, words + count}));
  } catch (const BadInput& fault) {
    std::cerr << "odemark_make_solutions: " << fault.what() << '\n';
    return 2;
  } catch (const std::exception& fault) {
    std::cerr << "odemark_make_solutions: " << fault.what() << '\n';
    return 1;
  }
}
