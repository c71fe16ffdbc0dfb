#include "reference/truth_sampled.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "reference/truth_compare.hpp"
#include "reference/wide_problem.hpp"

namespace odemark {

std::vector<std::size_t> compared_components(const AnyProblem& problem) {
  const std::size_t size = problem.size();
  std::vector<std::size_t> places;
  if (!problem.is_large()) {
    for (std::size_t i = 0; i < size; ++i) places.push_back(i);
    return places;
  }
  const std::size_t half = size / 2, each = largest_compared_size / 2;
  for (const std::size_t begin : {std::size_t(0), half}) {
    const std::size_t count = begin == 0 ? half : size - half;
    for (std::size_t k = 0; k < each; ++k) places.push_back(begin + k * (count - 1) / (each - 1));
  }
  return places;
}

Truth sampled_truth(const AnyProblem& problem) {
  const auto begin = std::chrono::steady_clock::now();
  const auto& families = suite_wide_families();
  const auto family = std::find_if(families.begin(), families.end(),
                                   [&](const WideFamily& f) { return f.id == problem.family; });
  if (family == families.end() || !family->sampled)
    throw TruthUnavailable("with " + std::to_string(problem.size()) + " components " + problem.id +
                               " is too large for anything but a closed form of single components, and it "
                               "has none",
                           0);
  Truth truth;
  truth.problem = problem.id, truth.origin = "closed form, at some components";
  truth.checked_by =
      "nothing at this size: the formula is tested against the whole closed form at a small one";
  truth.places = compared_components(problem);
  double largest = 0;
  for (const double y : problem.initial) largest = std::max(largest, std::abs(y));
  // the sines and sums that the initial state is made of are good to a few units in the last place
  const double unit = std::numeric_limits<double>::epsilon() * largest, rounding = 4 * unit;
  const auto solution = family->sampled(problem, Wide(problem.t_end), truth.places);
  TruthPoint point;
  point.t = problem.t_end;
  std::vector<double> scale;
  for (std::size_t p = 0; p < truth.places.size(); ++p) {
    if (!isfinite(solution.y[p]))
      throw TruthUnavailable("the closed form of " + problem.id + " is not finite", 0);
    scale.push_back(problem.scale[truth.places[p]]);
    point.values.push_back(truth_value(solution.y[p], Wide(rounding * solution.spread[p])));
    point.sensitivity = std::max(point.sensitivity, unit * solution.reach[p] / scale.back());
  }
  point.digits = truth.digits = digits_in_scale(point.values, scale);
  truth.points.push_back(std::move(point));
  truth.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return truth;
}

}  // namespace odemark
