#include "reference/verify_solutions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>

#include "reference/bad_input.hpp"
#include "reference/truth_wide.hpp"

namespace odemark {

namespace {

struct Candidate {
  AnyProblem problem;
  std::string_view json;  // empty: nothing is stored
  std::size_t place = 0;
};

std::string_view stored_text(std::string_view preset) {
  for (const StoredSolution& solution : stored_solutions())
    if (solution.preset == preset) return solution.json;
  return {};
}

/// Scatters: the presets of one family are neighbours, a sample should not be.
std::uint64_t scattered(std::string_view seed, std::string_view preset) {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  for (const std::string_view part : {seed, std::string_view("/"), preset})
    for (const char c : part) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash ^ (hash >> 29);
}

VerifiedSolution verified(const Candidate& candidate, std::size_t times) {
  VerifiedSolution result;
  result.preset = candidate.problem.preset;
  if (candidate.json.empty()) {
    result.fault = "no solution is stored";
    return result;
  }
  const auto begin = std::chrono::steady_clock::now();
  try {
    const Truth stored = from_json(candidate.problem, candidate.json,
                                   fingerprint(candidate.problem, widened(candidate.problem, false)));
    result.digits = stored.digits, result.origin = stored.origin, result.checked_by = stored.checked_by;
    result.fault = verify(candidate.problem, stored, times);
  } catch (const std::exception& fault) {
    result.fault = fault.what();
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

/// What the file says it took; a file that says nothing is checked whatever it takes.
double stored_seconds(std::string_view json) {
  constexpr std::string_view key = "\"seconds\": ";
  const auto at = json.find(key);
  return at == json.npos ? 0 : std::strtod(json.data() + at + key.size(), nullptr);
}

std::vector<Candidate> chosen(const std::vector<AnyFamily>& families, const VerifyRequest& request) {
  std::vector<Candidate> all;
  for (const auto& id : request.presets.empty() ? problem_ids(families) : request.presets) {
    Candidate candidate{find_problem(families, id), stored_text(id), all.size()};
    if (candidate.problem.is_large()) {
      if (request.presets.empty()) continue;
      throw BadInput(id + " is too large to be stored: its closed form is evaluated when it is asked for");
    }
    if (request.within && stored_seconds(candidate.json) > *request.within) continue;
    all.push_back(std::move(candidate));
  }
  if (all.empty()) throw BadInput("no stored solution was computed that fast: give --within more seconds");
  if (!request.sample || *request.sample >= all.size()) return all;
  const auto first = [&](const Candidate& a, const Candidate& b) {
    return scattered(request.seed, a.problem.preset) < scattered(request.seed, b.problem.preset);
  };
  std::sort(all.begin(), all.end(), first);
  all.resize(*request.sample);
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
  return all;
}

}  // namespace

std::vector<VerifiedSolution> verify_solutions(const std::vector<AnyFamily>& families,
                                               const VerifyRequest& request, const OnVerified& report,
                                               const std::atomic<bool>& stop) {
  const auto candidates = chosen(families, request);
  std::vector<std::optional<VerifiedSolution>> results(candidates.size());
  std::atomic<std::size_t> next = 0;
  std::size_t done = 0;
  std::mutex mutex;
  const auto worker = [&] {
    for (std::size_t i; !stop && (i = next++) < candidates.size();) {
      VerifiedSolution result = verified(candidates[i], request.times);
      const std::lock_guard lock(mutex);
      report(result, ++done, candidates.size());
      results[i] = std::move(result);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < request.jobs; ++i) threads.emplace_back(worker);
  worker();
  for (auto& thread : threads) thread.join();
  std::vector<VerifiedSolution> all;
  for (auto& result : results)
    if (result) all.push_back(std::move(*result));
  return all;
}

}  // namespace odemark
