#include "reference/truth_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "reference/truth_compare.hpp"
#include "reference/truth_wide.hpp"

namespace odemark {

namespace {

using Json = nlohmann::ordered_json;

/// FNV-1a, 64 bits (G. Fowler, L. C. Noll, K.-P. Vo).
std::string hash(std::string_view text) {
  std::uint64_t sum = 14695981039346656037u;
  for (const char c : text) {
    sum ^= static_cast<unsigned char>(c);
    sum *= 1099511628211u;
  }
  return fmt::format("{:016x}", sum);
}

/// The right-hand side of every phase at the initial state and beside it, and what events do there, to thirty
/// digits: the same everywhere.
std::string slopes(const WideProblem& wide) {
  std::string text;
  std::vector<Wide> slope(wide.size), value(wide.events.count);
  for (const auto& phase : wide.phases)
    for (int beside = 0; beside < 2; ++beside) {
      std::vector<Wide> y = wide.initial;
      for (std::size_t i = 0; beside && i < y.size(); ++i) y[i] = y[i] * 9 / 8 + Wide(i + 1) / 16;
      wide.rhs(phase.value.get(), Wide(beside), y.data(), slope.data());
      for (const Wide& s : slope) text += ' ' + s.str(30, std::ios_base::scientific);
      if (!wide.events.jumps) continue;
      wide.events.values(phase.value.get(), Wide(beside), y.data(), value.data());
      for (const Wide& g : value) text += ' ' + g.str(30, std::ios_base::scientific);
      for (std::size_t k = 0; k < value.size(); ++k) {
        std::vector<Wide> after = y;
        text += ' ' + std::to_string(wide.events.after(phase.value.get(), k, Wide(beside), after.data(), 0));
        for (const Wide& x : after) text += ' ' + x.str(30, std::ios_base::scientific);
      }
    }
  return text;
}

}  // namespace

std::string fingerprint(const AnyProblem& problem, const WideProblem& wide) {
  std::string text(problem.family);
  for (const auto& p : problem.parameters)
    if (!p.shorthand) text += fmt::format(" {}={:a}", p.name, p.value);
  for (const double y : problem.initial) text += fmt::format(" {:a}", y);
  return hash(text + slopes(wide));
}

std::string to_json(const Truth& truth, std::string_view preset, std::string_view fingerprint) {
  std::string text = fmt::format(
      "{{\n \"problem\": \"{}\",\n \"definition\": \"{}\",\n \"inputs\": \"rounded to double\",\n "
      "\"origin\": \"{}\",\n"
      " \"checked_by\": \"{}\",\n \"digits\": {},\n \"seconds\": {:.2g},\n \"points\": [",
      preset, fingerprint, truth.origin, truth.checked_by, truth.digits, truth.seconds);
  const char* comma = "";
  for (const auto& point : truth.points) {
    Json values = Json::array(), bounds = Json::array();
    for (const auto& value : point.values) {
      values.push_back(value.decimal);
      bounds.push_back(fmt::format("{:.3e}", value.bound));
    }
    text += fmt::format("{}\n  {{\"t\": {}, \"sensitivity\": {:.3e},\n   \"y\": {},\n   \"bound\": {}}}",
                        comma, Json(point.t).dump(), point.sensitivity, values.dump(), bounds.dump());
    comma = ",";
  }
  text += "\n ]";
  comma = ",\n \"events\": [";
  for (const auto& event : truth.events) {
    text += fmt::format("{}\n  {{\"event\": {}, \"phase\": {}, \"t\": \"{}\", \"bound\": \"{:.3e}\"}}", comma,
                        event.event, event.phase, event.t.decimal, event.t.bound);
    comma = ",";
  }
  return text + (truth.events.empty() ? "\n}\n" : "\n ]\n}\n");
}

Truth from_json(const AnyProblem& problem, std::string_view json, std::string_view fingerprint) {
  Truth truth;
  try {
    const Json file = Json::parse(json);
    if (file.at("definition") != fingerprint)
      throw std::runtime_error("it was made for another definition of the problem");
    truth.problem = problem.id, truth.stored = true;
    file.at("origin").get_to(truth.origin), file.at("checked_by").get_to(truth.checked_by);
    file.at("seconds").get_to(truth.seconds);
    truth.digits = std::numeric_limits<int>::max();
    for (const auto& entry : file.at("points")) {
      TruthPoint point;
      entry.at("t").get_to(point.t), entry.at("sensitivity").get_to(point.sensitivity);
      const auto& values = entry.at("y");
      const auto& bounds = entry.at("bound");
      if (values.size() != problem.size() || bounds.size() != problem.size())
        throw std::runtime_error("it has a state of the wrong size");
      for (std::size_t i = 0; i < values.size(); ++i)
        point.values.push_back(
            truth_value(values[i].get<std::string>(), std::stold(bounds[i].get<std::string>())));
      point.digits = digits_in_scale(point.values, problem.scale);
      truth.digits = std::min(truth.digits, point.digits);
      truth.points.push_back(std::move(point));
    }
    if (file.contains("events"))
      for (const auto& entry : file["events"])
        truth.events.push_back({entry.at("event"), entry.at("phase"),
                                truth_value(entry.at("t").get<std::string>(),
                                            std::stold(entry.at("bound").get<std::string>()))});
  } catch (const std::exception& fault) {
    throw std::runtime_error("the stored solution of " + problem.preset + " is no good: " + fault.what());
  }
  return truth;
}

std::shared_ptr<const Truth> stored_truth(const AnyProblem& problem, std::string_view fingerprint) {
  for (const auto& stored : stored_solutions())
    if (stored.preset == problem.preset && stored.json.find(fingerprint) != stored.json.npos)
      return std::make_shared<const Truth>(from_json(problem, stored.json, fingerprint));
  return nullptr;
}

std::string verify(const AnyProblem& problem, const Truth& stored, std::size_t sample) {
  const std::size_t count = stored.points.size();
  sample = std::clamp<std::size_t>(sample, 1, count);
  std::vector<const TruthPoint*> points;
  std::vector<Wide> times;
  for (std::size_t i = 1; i <= sample; ++i) {
    points.push_back(&stored.points[i * count / sample - 1]);
    times.emplace_back(points.back()->t);
  }
  const WideProblem wide = widened(problem, false);
  CertifyOptions options;
  options.sensitivity = false;
  options.digits = std::min(stored.digits, most_digits);
  options.time_limit_seconds = 3600;
  Truth fresh;
  try {
    fresh = certify_wide(problem, wide, wide, times, options);
  } catch (const TruthUnavailable& why) {
    if (!wide.exact || why.digits_reached > 0) return why.what();
    fresh = unchecked_closed_form(problem, wide, times);
  }
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t i = 0; i < problem.size(); ++i) {
      const TruthValue &old = points[p]->values[i], &now = fresh.points[p].values[i];
      const Wide distance = abs(Wide(old.decimal) - Wide(now.decimal));
      if (!(distance <= Wide(old.bound) + Wide(now.bound)))
        return fmt::format(
            "{}, {} at t = {}: stored {}, computed {}; they differ by {}, more than their bounds {} and {}",
            problem.preset, problem.components[i].name, points[p]->t, old.decimal, now.decimal,
            distance.str(3), old.bound, now.bound);
    }
  if (stored.events.size() != fresh.events.size())
    return fmt::format("{}: {} events are stored, {} computed", problem.preset, stored.events.size(),
                       fresh.events.size());
  for (std::size_t i = 0; i < stored.events.size(); ++i) {
    const TruthValue &old = stored.events[i].t, &now = fresh.events[i].t;
    if (!(abs(Wide(old.decimal) - Wide(now.decimal)) <= Wide(old.bound) + Wide(now.bound)))
      return fmt::format("{}: event {} is stored at t = {}, computed at {}", problem.preset, i, old.decimal,
                         now.decimal);
  }
  return "";
}

}  // namespace odemark
