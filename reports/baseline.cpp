// The bytes of baseline.json: written one case a line, read back strictly.
#include "reports/baseline.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

namespace odemark {
namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const Json& j) { return j.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// plan/problem/method/scalar[+compensated]/control says the case too; empty for an id of another shape.
std::string case_of_id(std::string_view id) {
  std::array<std::string_view, 4> parts;
  for (auto& part : parts) {
    const std::size_t slash = id.find('/');
    if (slash == id.npos) return "";
    part = id.substr(0, slash), id.remove_prefix(slash + 1);
  }
  const std::size_t plus = parts[3].find('+');
  return case_name({std::string(parts[1]), std::string(parts[2]), std::string(parts[3].substr(0, plus)),
                    plus != parts[3].npos});
}

/// What most runs have in common is left out.
Json run_json(const std::string& id, const BaselineRun& run) {
  Json j = {{"id", id}};
  if (run.case_name != case_of_id(id)) j["case"] = run.case_name;
  if (run.provider != "odemark") j["provider"] = run.provider;
  if (run.status != "reached_end") j["status"] = run.status;
  if (run.scaled && std::isfinite(*run.scaled)) j["scaled"] = *run.scaled;
  j["evaluations"] = run.evaluations, j["accepted"] = run.accepted;
  if (run.rejected != 0) j["rejected"] = run.rejected;
  if (!run.drift.empty()) {
    Json drift = Json::object();
    for (const auto& [name, value] : run.drift)
      drift[name] = std::isfinite(value) ? Json(value) : Json(nullptr);
    j["drift"] = std::move(drift);
  }
  if (!run.state_hash.empty()) j["state_hash"] = run.state_hash;
  return j;
}

std::string lines_of(const std::vector<Json>& all) {
  std::string out = "[\n";
  for (std::size_t i = 0; i < all.size(); ++i) out += line_of(all[i]) + (i + 1 < all.size() ? ",\n" : "\n");
  return out + "]";
}

/// Six digits are more than a factor of 1.5 asks for, and half the file.
double to_six_digits(double x) {
  return std::isfinite(x) ? std::strtod(fmt::format("{:.6g}", x).c_str(), nullptr) : x;
}

struct BadValue : std::runtime_error {
  using std::runtime_error::runtime_error;
};

const Json& needed(const Json& j, const char* key) {
  if (!j.is_object()) throw BadValue("an entry is not written { ... }");
  const auto found = j.find(key);
  if (found == j.end()) throw BadValue(fmt::format("\"{}\" is missing", key));
  return *found;
}
std::string text(const Json& j, const char* key) {
  const Json& value = needed(j, key);
  if (!value.is_string()) throw BadValue(fmt::format("\"{}\" is no text", key));
  return value.get<std::string>();
}
double number(const Json& value, std::string_view key) {
  if (!value.is_number()) throw BadValue(fmt::format("\"{}\" is no number", key));
  return value.get<double>();
}
long whole(const Json& j, const char* key) {
  const Json& value = needed(j, key);
  if (!value.is_number_integer() ||
      (value.is_number_unsigned() &&
       value.get<unsigned long>() > static_cast<unsigned long>(std::numeric_limits<long>::max())))
    throw BadValue(fmt::format("\"{}\" is no whole number", key));
  return value.get<long>();
}

BaselineRun run_from(const Json& j) {
  BaselineRun run;
  run.case_name = case_of_id(text(j, "id")), run.status = "reached_end";
  if (j.contains("case") || run.case_name.empty()) run.case_name = text(j, "case");
  if (j.contains("status")) run.status = text(j, "status");
  if (j.contains("provider")) run.provider = text(j, "provider");
  if (j.contains("scaled")) run.scaled = number(j["scaled"], "scaled");
  run.evaluations = whole(j, "evaluations");
  run.accepted = whole(j, "accepted"), run.rejected = j.contains("rejected") ? whole(j, "rejected") : 0;
  if (j.contains("drift")) {
    if (!j["drift"].is_object()) throw BadValue("\"drift\" is not written { ... }");
    for (const auto& [name, value] : j["drift"].items())
      run.drift[name] = value.is_null() ? std::numeric_limits<double>::quiet_NaN() : number(value, name);
  }
  if (j.contains("state_hash")) run.state_hash = text(j, "state_hash");
  return run;
}

Baseline baseline_from(const Json& j) {
  Baseline baseline;
  const long schema = whole(j, "schema");
  if (schema != baseline_schema)
    throw BadValue(
        fmt::format("it has schema {}, this odemark reads {}: approve anew", schema, baseline_schema));
  baseline.tool = text(j, "tool"), baseline.reason = text(j, "reason");
  const Json& build = needed(j, "build");
  baseline.compiler = text(build, "compiler"), baseline.flags = text(build, "flags");
  baseline.build_type = text(build, "build_type");
  for (const char* key : {"orders", "runs"})
    if (!needed(j, key).is_array()) throw BadValue(fmt::format("\"{}\" is no list", key));
  for (const Json& order : j["orders"])
    if (!baseline.orders.emplace(text(order, "case"), number(needed(order, "order"), "order")).second)
      throw BadValue(fmt::format("the order of {} is there twice", text(order, "case")));
  for (const Json& run : j["runs"])
    if (!baseline.runs.emplace(text(run, "id"), run_from(run)).second)
      throw BadValue(fmt::format("{} is there twice", text(run, "id")));
  return baseline;
}

}  // namespace

std::string to_text(const Baseline& baseline) {
  std::vector<Json> orders, runs;
  for (const auto& [name, order] : baseline.orders)
    if (std::isfinite(order)) orders.push_back({{"case", name}, {"order", order}});
  for (const auto& [id, run] : baseline.runs) runs.push_back(run_json(id, run));
  const Json build = {
      {"compiler", baseline.compiler}, {"flags", baseline.flags}, {"build_type", baseline.build_type}};
  return fmt::format("{{\n\"schema\":{},\n\"tool\":{},\n\"build\":{},\n\"reason\":{},\n", baseline_schema,
                     line_of(baseline.tool), line_of(build), line_of(baseline.reason)) +
         fmt::format("\"orders\":{},\n\"runs\":{}\n}}\n", lines_of(orders), lines_of(runs));
}

Baseline parse_baseline(std::string_view all, std::string_view name) {
  try {
    return baseline_from(Json::parse(all));
  } catch (const nlohmann::json::exception& e) {
    throw BadBaseline(fmt::format("{}: cut or damaged, approve anew ({})", name, e.what()));
  } catch (const BadValue& e) {
    throw BadBaseline(fmt::format("{}: {}", name, e.what()));
  }
}

Baseline make_baseline(const std::vector<Row>& rows, const RunHeader& header, std::string reason) {
  Baseline baseline;
  baseline.tool = "odemark " + header.version;
  baseline.compiler = header.compiler, baseline.flags = header.flags;
  baseline.build_type = header.build_type, baseline.reason = std::move(reason);
  for (const ObservedOrder& order : observed_orders(rows))
    if (order.slope) baseline.orders[case_name(order.id)] = to_six_digits(*order.slope);
  for (const Row& row : rows) {
    if (row.status == "not_applicable") continue;
    BaselineRun run;
    run.case_name = case_name(curve_of(row)), run.status = row.status;
    if (!row.provider.empty()) run.provider = row.provider;
    if (row.errors && std::isfinite(row.errors->scaled)) run.scaled = to_six_digits(row.errors->scaled);
    run.evaluations = row.work.evaluations, run.accepted = row.accepted, run.rejected = row.rejected;
    for (const auto& [name, value] : row.drift) run.drift[name] = to_six_digits(value);
    run.state_hash = row.state_hash;
    baseline.runs.insert_or_assign(row.id, std::move(run));
  }
  return baseline;
}

}  // namespace odemark
