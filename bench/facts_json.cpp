// Sheets of facts as JSON.
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/facts.hpp"

namespace odemark {

namespace {

using Json = nlohmann::ordered_json;

Json json_number(double x) {
  if (std::isnan(x)) return nullptr;
  if (std::isinf(x)) return x > 0 ? "infinity" : "-infinity";
  return x;
}

Json value_json(const std::monostate&) { return nullptr; }
Json value_json(bool x) { return x; }
Json value_json(int x) { return x; }
Json value_json(double x) { return json_number(x); }
Json value_json(const FactPower& law) {
  return {{"coefficient", json_number(law.coefficient)}, {"power", law.power}};
}
Json value_json(const FactIntervals& intervals) {
  Json out = Json::array();
  for (const auto& [low, high] : intervals) out.push_back({json_number(low), json_number(high)});
  return out;
}
Json value_json(const FactNumbers& numbers) {
  Json out = Json::object();
  for (const auto& [name, value] : numbers) out[name] = json_number(value);
  return out;
}

Json json_number(const std::optional<double>& x) { return x ? json_number(*x) : Json(nullptr); }

}  // namespace

std::string to_json(const FactSheet& sheet, int indent) {
  Json j{{"id", sheet.id},         {"name", sheet.name},
         {"family", sheet.family}, {"provider", sheet.provider},
         {"source", sheet.source}, {"advice", sheet.advice}};
  Json reasons = Json::object(), notes = Json::object();
  for (const auto& line : sheet.facts) {
    j[line.key] = std::visit([](const auto& value) { return value_json(value); }, line.value);
    if (line.note.empty()) continue;
    (j[line.key].is_null() ? reasons : notes)[line.key] = line.note;
  }
  j["reasons"] = reasons, j["notes"] = notes;
  if (!sheet.measured.empty()) {
    Json measured = Json::array();
    for (const auto& m : sheet.measured)
      measured.push_back({{"fact", m.fact},
                          {"scalar", m.scalar},
                          {"theory", json_number(m.theory)},
                          {"measured", json_number(m.measured)},
                          {"difference", json_number(m.difference)},
                          {"bound", json_number(m.bound)},
                          {"agrees", m.agrees},
                          {"note", m.note}});
    j["measured"] = measured;
  }
  return j.dump(indent);
}

}  // namespace odemark
