// Stability rows as lines of a results file.
#include <limits>
#include <utility>

#include "bench/json_line.hpp"
#include "bench/json_parts.hpp"

namespace odemark {

namespace json {

namespace {

/// A band without an upper end is written with null there.
Json bands_json(const std::vector<std::pair<double, double>>& bands) {
  Json j = Json::array();
  for (const auto& [low, high] : bands) j.push_back({low, std::isfinite(high) ? Json(high) : Json(nullptr)});
  return j;
}
std::vector<std::pair<double, double>> bands_from(const Json& j, const char* key) {
  std::vector<std::pair<double, double>> bands;
  for (const auto& band : j.value(key, Json::array()))
    bands.emplace_back(band.at(0).get<double>(), band.at(1).is_null()
                                                     ? std::numeric_limits<double>::infinity()
                                                     : band.at(1).get<double>());
  return bands;
}

}  // namespace

StabilityRow stability_from(const Json& j) {
  StabilityRow r;
  r.problem = text(j, "problem"), r.family = text(j, "family"), r.settings = text(j, "settings");
  r.method = text(j, "method"), r.kind = text(j, "kind"), r.provider = text(j, "provider");
  r.scalar = text(j, "scalar"), r.verdict = text(j, "verdict"), r.reason = text(j, "reason");
  r.theory_verdict = text(j, "theory_verdict"), r.theory_reason = text(j, "theory_reason");
  r.theory_as_seen_verdict = text(j, "theory_as_seen_verdict");
  r.theory_as_seen = maybe<double>(j, "theory_as_seen"), r.failure = text(j, "failure");
  r.measured = maybe<double>(j, "measured"), r.theory = maybe<double>(j, "theory");
  r.difference = maybe<double>(j, "difference"), r.resolution = number(j, "resolution");
  r.scanned_to = number(j, "scanned_to"), r.fastest_rate = number(j, "fastest_rate");
  r.later_bands = bands_from(j, "later_bands"), r.theory_later_bands = bands_from(j, "theory_later_bands");
  r.theory_as_seen_bands = bands_from(j, "theory_as_seen_bands");
  r.touches = j.value("touches", std::vector<double>());
  r.reference_dt = number(j, "reference_dt");
  r.growth_per_second = maybe<double>(j, "growth_per_second");
  r.theory_growth_per_second = maybe<double>(j, "theory_growth_per_second");
  for (const auto& z : j.value("eigenvalues", Json::array()))
    r.eigenvalues.emplace_back(z.at(0).get<double>(), z.at(1).get<double>());
  if (r.problem.empty() || r.verdict.empty())
    throw std::invalid_argument("a stability row needs \"problem\" and \"verdict\"");
  return r;
}

}  // namespace json

using namespace json;

std::string to_json_line(const StabilityRow& r) {
  Json j = {{"record", "stability"}, {"problem", r.problem}};
  put(j, "family", r.family), put(j, "settings", r.settings);
  j["method"] = r.method;
  put(j, "kind", r.kind), put(j, "provider", r.provider);
  j["scalar"] = r.scalar, j["verdict"] = r.verdict;
  put(j, "reason", r.reason), put(j, "measured", r.measured), put(j, "theory", r.theory);
  put(j, "resolution", r.resolution), put(j, "difference", r.difference), put(j, "scanned_to", r.scanned_to);
  put(j, "fastest_rate", r.fastest_rate);
  put(j, "theory_verdict", r.theory_verdict), put(j, "theory_reason", r.theory_reason);
  put(j, "theory_as_seen_verdict", r.theory_as_seen_verdict), put(j, "theory_as_seen", r.theory_as_seen);
  put(j, "failure", r.failure);
  if (!r.later_bands.empty()) j["later_bands"] = bands_json(r.later_bands);
  if (!r.theory_later_bands.empty()) j["theory_later_bands"] = bands_json(r.theory_later_bands);
  if (!r.theory_as_seen_bands.empty()) j["theory_as_seen_bands"] = bands_json(r.theory_as_seen_bands);
  if (!r.touches.empty()) j["touches"] = r.touches;
  put(j, "reference_dt", r.reference_dt), put(j, "growth_per_second", r.growth_per_second);
  put(j, "theory_growth_per_second", r.theory_growth_per_second);
  Json eigenvalues = Json::array();
  for (const auto& z : r.eigenvalues) eigenvalues.push_back({z.real(), z.imag()});
  j["eigenvalues"] = eigenvalues;
  return j.dump();
}

}  // namespace odemark
