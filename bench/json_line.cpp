#include "bench/json_line.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "bench/json_parts.hpp"

namespace odemark {

using namespace json;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();  // written as absent: never a good value

Json work_json(const RowWork& w) {
  return {{"rhs", w.rhs},
          {"acceleration", w.acceleration},
          {"jacobian", w.jacobian},
          {"series", w.series},
          {"lu", w.lu},
          {"newton", w.newton},
          {"evaluations", w.evaluations}};
}
RowWork work_from(const Json& j) {
  return {whole(j, "rhs"), whole(j, "acceleration"), whole(j, "jacobian"),   whole(j, "series"),
          whole(j, "lu"),  whole(j, "newton"),       whole(j, "evaluations")};
}

Json errors_json(const RowErrors& e) {
  Json j = Json::object();
  put(j, "scaled", e.scaled), put(j, "absolute", e.absolute), put(j, "relative", e.relative),
      put(j, "rms", e.rms);
  put(j, "trajectory_max", e.trajectory_max), put(j, "trajectory_rms", e.trajectory_rms);
  put(j, "amplitude", e.amplitude), put(j, "phase", e.phase), put(j, "left", e.left);
  return j;
}
RowErrors errors_from(const Json& j) {
  return {
      j.value("scaled", nothing),    j.value("absolute", nothing),       maybe<double>(j, "relative"),
      j.value("rms", nothing),       maybe<double>(j, "trajectory_max"), maybe<double>(j, "trajectory_rms"),
      maybe<double>(j, "amplitude"), maybe<double>(j, "phase"),          maybe<double>(j, "left")};
}

Json timing_json(const RowTiming& t) {
  Json j = Json::object();
  put(j, "minimum_seconds", t.minimum_seconds), put(j, "median_seconds", t.median_seconds),
      put(j, "mad_seconds", t.mad_seconds);
  j["repeats"] = t.repeats;
  put(j, "ns_per_step", t.ns_per_step), put(j, "ns_per_simulated_second", t.ns_per_simulated_second);
  j["tier"] = t.tier;
  return j;
}
RowTiming timing_from(const Json& j) {
  return {j.value("minimum_seconds", nothing),
          j.value("median_seconds", nothing),
          j.value("mad_seconds", nothing),
          whole<int>(j, "repeats"),
          j.value("ns_per_step", nothing),
          j.value("ns_per_simulated_second", nothing),
          text(j, "tier")};
}

Json local_json(const RowLocal& l) {
  return {{"judged", l.judged}, {"deceived", l.deceived}, {"worst", l.worst}};
}
RowLocal local_from(const Json& j) { return {whole(j, "judged"), whole(j, "deceived"), number(j, "worst")}; }

Json events_json(const RowEvents& e) {
  Json j = {{"found", e.found}, {"expected", e.expected}};
  put(j, "worst_time_error", e.worst_time_error);
  return j;
}
RowEvents events_from(const Json& j) {
  return {whole(j, "found"), whole(j, "expected"), maybe<double>(j, "worst_time_error")};
}

Json steps_json(const RowSteps& s) { return {{"time", s.time}, {"step", s.step}}; }
RowSteps steps_from(const Json& j) {
  return {j.value("time", std::vector<double>{}), j.value("step", std::vector<double>{})};
}

Row row_from(const Json& j) {
  Row r;
  r.id = text(j, "id"), r.plan = text(j, "plan");
  r.problem = text(j, "problem"), r.family = text(j, "family"), r.settings = text(j, "settings");
  r.method = text(j, "method"), r.kind = text(j, "kind"), r.provider = text(j, "provider");
  r.order = whole<int>(j, "order"), r.embedded_order = whole<int>(j, "embedded_order");
  r.expected_order = maybe<int>(j, "expected_order"), r.expected_because = text(j, "expected_because");
  r.scalar = text(j, "scalar"), r.compensated = j.value("compensated", false);
  r.steps = maybe<long>(j, "steps"), r.dt = maybe<double>(j, "dt");
  r.rtol = maybe<double>(j, "rtol"), r.atol = maybe<double>(j, "atol"), r.filter = text(j, "filter");
  r.status = text(j, "status"), r.reason = text(j, "reason");
  r.accepted = whole(j, "accepted"), r.rejected = whole(j, "rejected");
  r.t_end = number(j, "t_end"), r.t_reached = number(j, "t_reached");
  if (j.contains("work")) r.work = work_from(j["work"]);
  if (j.contains("errors")) r.errors = errors_from(j["errors"]);
  r.truth_floor = number(j, "truth_floor"), r.sensitivity = number(j, "sensitivity");
  r.truth_digits = number(j, "truth_digits");
  if (j.contains("drift"))
    for (const auto& [name, value] : j["drift"].items())
      r.drift[name] = value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
  if (j.contains("events")) r.events = events_from(j["events"]);
  if (j.contains("local")) r.local = local_from(j["local"]);
  if (j.contains("history")) r.history = steps_from(j["history"]);
  if (j.contains("timing")) r.timing = timing_from(j["timing"]);
  r.state_hash = text(j, "state_hash");
  if (r.id.empty() || r.status.empty()) throw std::invalid_argument("a run needs \"id\" and \"status\"");
  return r;
}

RunHeader header_from(const Json& j) {
  RunHeader h;
  h.schema = whole_from<int>(j.at("schema"), "schema");
  h.suite = text(j, "suite"), h.version = text(j, "version"), h.revision = text(j, "revision"),
  h.date = text(j, "date");
  h.compiler = text(j, "compiler"), h.flags = text(j, "flags"), h.build_type = text(j, "build_type");
  h.processor = text(j, "processor"), h.system = text(j, "system"), h.cores = whole<int>(j, "cores");
  h.providers = j.value("providers", std::map<std::string, std::string>());
  h.footnotes = j.value("footnotes", std::vector<std::string>());
  return h;
}

}  // namespace

std::string to_json_line(const RunHeader& h) {
  Json j = {{"record", "header"}, {"schema", h.schema}};
  put(j, "suite", h.suite), put(j, "version", h.version), put(j, "revision", h.revision),
      put(j, "date", h.date);
  put(j, "compiler", h.compiler), put(j, "flags", h.flags), put(j, "build_type", h.build_type);
  put(j, "processor", h.processor), put(j, "system", h.system);
  j["cores"] = h.cores;
  j["providers"] = h.providers;
  j["footnotes"] = h.footnotes;
  return j.dump();
}

std::string to_json_line(const Row& r) {
  Json j = {{"record", "run"}, {"id", r.id}, {"plan", r.plan}, {"problem", r.problem}};
  put(j, "family", r.family), put(j, "settings", r.settings);
  j["method"] = r.method;
  put(j, "kind", r.kind), put(j, "provider", r.provider);
  j["order"] = r.order, j["embedded_order"] = r.embedded_order;
  put(j, "expected_order", r.expected_order), put(j, "expected_because", r.expected_because);
  j["scalar"] = r.scalar;
  j["compensated"] = r.compensated;
  put(j, "steps", r.steps), put(j, "dt", r.dt), put(j, "rtol", r.rtol), put(j, "atol", r.atol),
      put(j, "filter", r.filter);
  j["status"] = r.status;
  put(j, "reason", r.reason);
  j["accepted"] = r.accepted, j["rejected"] = r.rejected;
  put(j, "t_end", r.t_end), put(j, "t_reached", r.t_reached);
  j["work"] = work_json(r.work);
  if (r.errors) j["errors"] = errors_json(*r.errors);
  put(j, "truth_floor", r.truth_floor), put(j, "sensitivity", r.sensitivity),
      put(j, "truth_digits", r.truth_digits);
  if (!r.drift.empty()) {
    Json drift = Json::object();
    for (const auto& [name, value] : r.drift)
      drift[name] = std::isfinite(value) ? Json(value) : Json(nullptr);
    j["drift"] = drift;
  }
  if (r.events) j["events"] = events_json(*r.events);
  if (r.local) j["local"] = local_json(*r.local);
  if (r.history) j["history"] = steps_json(*r.history);
  if (r.timing) j["timing"] = timing_json(*r.timing);
  put(j, "state_hash", r.state_hash);
  return j.dump();
}

Results parse_results(std::string_view all, std::string_view name) {
  Results results;
  bool has_header = false;
  long line_number = 0;
  while (!all.empty()) {
    ++line_number;
    const std::size_t end = all.find('\n');
    const std::string_view line = all.substr(0, std::min(end, all.size()));
    all.remove_prefix(end == all.npos ? all.size() : end + 1);
    if (end == line.npos) {
      results.cut = true;
      break;
    }
    if (line.empty()) continue;
    try {
      const Json j = Json::parse(line);
      const std::string record = text(j, "record");
      if (!has_header) {
        if (record != "header")
          throw std::invalid_argument("the first line must be the header that `odemark run` writes");
        results.header = header_from(j);
        if (results.header.schema != row_schema)
          throw std::invalid_argument(
              fmt::format("it has schema {}, this odemark reads schema {}: run the suite again",
                          results.header.schema, row_schema));
        has_header = true;
      } else if (record == "run") {
        results.rows.push_back(row_from(j));
      } else if (record == "stability") {
        results.stability.push_back(stability_from(j));
      } else {
        throw std::invalid_argument(
            fmt::format("\"{}\" is no kind of record: header, run or stability", record));
      }
    } catch (const nlohmann::json::exception& e) {
      throw BadResults(fmt::format("{}:{}: not a results line ({})", name, line_number, e.what()));
    } catch (const std::invalid_argument& e) {
      throw BadResults(fmt::format("{}:{}: {}", name, line_number, e.what()));
    }
  }
  if (!has_header) throw BadResults(fmt::format("{}: empty, not a results file", name));
  return results;
}

Results read_results(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw BadResults(
        fmt::format("cannot read {}: `odemark run` writes it, into the folder that its -o names", path));
  std::ostringstream all;
  all << file.rdbuf();
  return parse_results(all.str(), path);
}

}  // namespace odemark
