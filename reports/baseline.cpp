// The bytes of baseline.json: written one ladder a line, read back strictly.
#include "reports/baseline.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace odemark {
namespace {

using Json = nlohmann::ordered_json;

std::string json_line(const Json& j) { return j.dump(-1, ' ', false, Json::error_handler_t::replace); }

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

constexpr std::string_view columns[] = {"control",  "status",   "error",  "evaluations",
                                        "accepted", "rejected", "drifts", "state_hash"};
constexpr std::string_view no_drift = "-";  // null is one that was not finite

/// What comes before the control in an id, and the control.
std::pair<std::string, std::string> split_id(const std::string& id) {
  const std::size_t slash = id.rfind('/');
  return slash == id.npos ? std::pair<std::string, std::string>{"", id}
                          : std::pair{id.substr(0, slash), id.substr(slash + 1)};
}

using Runs = std::map<std::string, BaselineRun>;

Json number_json(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

/// One ladder a line: the runs from `first` on that differ in their control only; `first` ends behind them.
Json ladder_json(Runs::const_iterator& first, Runs::const_iterator end) {
  const std::string of = split_id(first->first).first;
  const BaselineRun& head = first->second;
  std::set<std::string> names;
  auto last = first;
  for (; last != end && split_id(last->first).first == of && last->second.case_name == head.case_name &&
         last->second.provider == head.provider;
       ++last)
    for (const auto& [name, value] : last->second.drift) names.insert(name);
  Json j = {{"of", of}};
  if (head.case_name != case_of_id(of + "/")) j["case"] = head.case_name;
  if (head.provider != "odemark") j["provider"] = head.provider;
  if (!names.empty()) j["drifts"] = names;
  j["runs"] = Json::array();
  for (; first != last; ++first) {
    const BaselineRun& run = first->second;
    Json drifts = Json::array();
    for (const auto& name : names) {
      const auto found = run.drift.find(name);
      drifts.push_back(found == run.drift.end() ? Json(no_drift) : number_json(found->second));
    }
    j["runs"].push_back({split_id(first->first).second, run.status,
                         run.scaled ? number_json(*run.scaled) : Json(), run.evaluations, run.accepted,
                         run.rejected, drifts, run.state_hash});
  }
  return j;
}

std::string lines_of(const std::vector<Json>& all) {
  std::string out = "[\n";
  for (std::size_t i = 0; i < all.size(); ++i) out += json_line(all[i]) + (i + 1 < all.size() ? ",\n" : "\n");
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

void add_run(Runs& runs, const Json& ladder, const std::string& of, const Json& j) {
  if (!j.is_array() || j.size() != std::size(columns)) throw BadValue("a run has not all its columns");
  Json named = Json::object();
  for (std::size_t i = 0; i < std::size(columns); ++i) named[std::string(columns[i])] = j[i];
  BaselineRun run;
  const std::string id = (of.empty() ? "" : of + "/") + text(named, "control");
  run.case_name = ladder.contains("case") ? text(ladder, "case") : case_of_id(id);
  if (run.case_name.empty()) throw BadValue(fmt::format("{} says no case", id));
  if (ladder.contains("provider")) run.provider = text(ladder, "provider");
  run.status = text(named, "status"), run.state_hash = text(named, "state_hash");
  if (!named["error"].is_null()) run.scaled = number(named["error"], "error");
  run.evaluations = whole(named, "evaluations"), run.accepted = whole(named, "accepted");
  run.rejected = whole(named, "rejected");
  const Json names = ladder.value("drifts", Json::array()), &drifts = named["drifts"];
  if (!names.is_array() || !drifts.is_array() || names.size() != drifts.size())
    throw BadValue(fmt::format("the drifts of {} are not those that its ladder names", id));
  for (std::size_t i = 0; i < names.size(); ++i)
    if (drifts[i] != no_drift)
      run.drift[names[i].get<std::string>()] =
          drifts[i].is_null() ? std::numeric_limits<double>::quiet_NaN() : number(drifts[i], "drift");
  if (!runs.emplace(id, std::move(run)).second) throw BadValue(fmt::format("{} is there twice", id));
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
  for (const char* key : {"orders", "ladders"})
    if (!needed(j, key).is_array()) throw BadValue(fmt::format("\"{}\" is no list", key));
  for (const Json& order : j["orders"])
    if (!baseline.orders.emplace(text(order, "case"), number(needed(order, "order"), "order")).second)
      throw BadValue(fmt::format("the order of {} is there twice", text(order, "case")));
  for (const Json& ladder : j["ladders"]) {
    const std::string of = text(ladder, "of");
    if (!needed(ladder, "runs").is_array()) throw BadValue(fmt::format("the runs of {} are no list", of));
    for (const Json& run : ladder["runs"]) add_run(baseline.runs, ladder, of, run);
  }
  return baseline;
}

}  // namespace

std::string to_text(const Baseline& baseline) {
  std::vector<Json> orders, ladders;
  for (const auto& [name, order] : baseline.orders)
    if (std::isfinite(order)) orders.push_back({{"case", name}, {"order", order}});
  for (auto run = baseline.runs.begin(); run != baseline.runs.end();)
    ladders.push_back(ladder_json(run, baseline.runs.end()));
  const Json build = {
      {"compiler", baseline.compiler}, {"flags", baseline.flags}, {"build_type", baseline.build_type}};
  return fmt::format("{{\n\"schema\":{},\n\"tool\":{},\n\"build\":{},\n\"reason\":{},\n", baseline_schema,
                     json_line(baseline.tool), json_line(build), json_line(baseline.reason)) +
         fmt::format("\"columns\":{},\n\"orders\":{},\n\"ladders\":{}\n}}\n", json_line(Json(columns)),
                     lines_of(orders), lines_of(ladders));
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
