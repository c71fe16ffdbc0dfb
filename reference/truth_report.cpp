#include "reference/truth_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reference/bad_input.hpp"
#include "reference/make_wide_family.hpp"
#include "reference/truth_compare.hpp"
#include "reference/truth_store.hpp"
#include "reference/truth_wide.hpp"

namespace odemark {

namespace {

struct Answer {
  Truth truth;
  TruthPoint point;
  std::string time;  // as solved
};

/// The time asked for in the convention asked for.
Wide time_of(const TruthRequest& request, const WideProblem& wide) {
  if (!request.t) return wide.t_end;
  const double rounded = parse_number("t", *request.t);  // refuses what is no finite number
  if (!(rounded > 0)) throw BadInput("t = " + *request.t + " is no time to ask for: it must be positive");
  return request.exact_inputs ? parse_wide("t", *request.t) : Wide(rounded);
}

Answer answer(const AnyProblem& problem, const TruthRequest& request) {
  const WideProblem wide = widened(problem, request.exact_inputs);
  const Wide t = time_of(request, wide);
  const std::string time =
      request.t && request.exact_inputs ? *request.t : fmt::format("{}", static_cast<double>(t));
  if (!request.exact_inputs)
    if (const auto stored = stored_truth(problem, fingerprint(problem, wide)))
      for (const auto& point : stored->points)
        if (Wide(point.t) == t && point.digits >= request.digits) return {*stored, point, time};
  CertifyOptions options;
  options.digits = request.digits;
  options.exact_inputs = request.exact_inputs;
  options.time_limit_seconds = request.time_limit_seconds;
  const Truth truth = certify_wide(problem, wide, wide, {t}, options);
  return {truth, truth.last(), time};
}

std::string_view convention(bool exact_inputs) {
  return exact_inputs
             ? "as written: every decimal of parameters, initial state and t at its full value"
             : "rounded to double, as a double integrator sees them: parameters, initial state and t";
}

std::string as_text(const AnyProblem& problem, const TruthRequest& request, const Answer& answer) {
  std::string text = fmt::format("{} at t = {}\n", problem.id, answer.time);
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const auto& component = problem.components[i];
    const auto& value = answer.point.values[i];
    const std::string digits = certain_digits(value, request.digits);
    text += fmt::format("  {:<8} {}{}{}\n", component.name, digits == "0" || digits.front() == '-' ? "" : " ",
                        digits, component.unit.empty() ? "" : fmt::format(" {}", component.unit));
    if (digits == "0" && value.bound > 0)
      text += fmt::format("  {:<8}  (no more than {:.1e} in size)\n", "", std::abs(value.hi) + value.bound);
  }
  text += fmt::format(
      "digits       {} certified in units of the problem's scale; every digit shown is right (not rounded)\n"
      "found by     {}\nchecked by   {}\ninputs       {}\n",
      answer.point.digits, answer.truth.origin, answer.truth.checked_by, convention(request.exact_inputs));
  text += answer.truth.stored ? "stored       computed when the suite was made, not now\n"
                              : fmt::format("computed in  {:.2g} s\n", answer.truth.seconds);
  if (std::isfinite(answer.point.sensitivity))
    text += fmt::format("sensitivity  {:.1e} of the scale for one ulp of double in the initial state\n",
                        answer.point.sensitivity);
  return text;
}

std::string as_json(const AnyProblem& problem, const TruthRequest& request, const Answer& answer) {
  nlohmann::ordered_json state = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const auto& value = answer.point.values[i];
    state.push_back({{"name", problem.components[i].name},
                     {"unit", problem.components[i].unit},
                     {"value", certain_digits(value, request.digits)},
                     {"digits", value.digits},
                     {"bound", fmt::format("{:.3e}", value.bound)}});
  }
  nlohmann::ordered_json out{{"problem", problem.id},
                             {"t", answer.time},
                             {"state", state},
                             {"digits", answer.point.digits},
                             {"origin", answer.truth.origin},
                             {"checked_by", answer.truth.checked_by},
                             {"inputs", request.exact_inputs ? "as written" : "rounded to double"},
                             {"stored", answer.truth.stored},
                             {"sensitivity", answer.point.sensitivity}};  // null where it is not known
  return out.dump(2) + "\n";
}

}  // namespace

std::string truth_report(const std::vector<AnyFamily>& families, const TruthRequest& request) {
  const AnyProblem problem = find_problem(families, request.problem, request.settings);
  check_digits(request.digits);
  const Answer found = answer(problem, request);
  return request.json ? as_json(problem, request, found) : as_text(problem, request, found);
}

}  // namespace odemark
