#include "reference/truth.hpp"

#include <future>
#include <map>
#include <mutex>

#include "reference/truth_sampled.hpp"
#include "reference/truth_store.hpp"
#include "reference/truth_wide.hpp"

namespace odemark {

namespace {

std::shared_ptr<const Truth> find_or_compute(const AnyProblem& problem, const WideProblem& wide,
                                             const std::string& definition) {
  if (auto stored = stored_truth(problem, definition)) return stored;
  const auto grid = common_times(problem);
  const std::vector<Wide> times(grid.begin(), grid.end());
  CertifyOptions options;
  options.digits = 25;
  if (!wide.exact) return std::make_shared<const Truth>(certify_wide(problem, wide, wide, times, options));
  options.time_limit_seconds = 4;
  try {
    return std::make_shared<const Truth>(certify_wide(problem, wide, wide, times, options));
  } catch (const TruthUnavailable& why) {
    if (why.digits_reached > 0) throw;  // the formula and the computation disagree
    return std::make_shared<const Truth>(unchecked_closed_form(problem, wide, times));
  }
}

}  // namespace

std::shared_ptr<const Truth> stored_truth_of(const AnyProblem& problem) {
  if (problem.is_large()) return nullptr;
  try {
    return stored_truth(problem, fingerprint(problem, widened(problem, false)));
  } catch (const TruthUnavailable&) {
    return nullptr;  // a family from outside the suite
  }
}

std::vector<double> common_times(const AnyProblem& problem) {
  std::vector<double> times;
  for (int j = 1; j <= 16; ++j) times.push_back(j * problem.t_end / 16);
  return times;
}

std::shared_ptr<const Truth> truth_of(const AnyProblem& problem) {
  if (problem.is_large()) {
    static std::mutex one_at_a_time;
    static std::map<std::string, std::shared_ptr<const Truth>> known;
    const std::lock_guard lock(one_at_a_time);
    auto& truth = known[problem.id + ' ' + problem.preset_settings];
    if (!truth) truth = std::make_shared<const Truth>(sampled_truth(problem));
    return truth;
  }
  using Answer = std::shared_future<std::shared_ptr<const Truth>>;
  static std::mutex mutex;
  static std::map<std::string, Answer> cache;
  const WideProblem wide = widened(problem, false);
  const std::string definition = fingerprint(problem, wide);
  std::promise<std::shared_ptr<const Truth>> promise;
  Answer answer;
  bool first = false;
  {
    const std::lock_guard lock(mutex);
    auto& entry = cache[problem.id + ' ' + definition];
    if (!entry.valid()) first = true, entry = promise.get_future().share();
    answer = entry;
  }
  if (first) {
    try {
      promise.set_value(find_or_compute(problem, wide, definition));
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
  }
  return answer.get();
}

}  // namespace odemark
