// Rows and stability rows, flat.
#include "reports/csv_rows.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace odemark {
namespace {

Cell text(double x) { return {std::isfinite(x) ? fmt::format("{}", x) : ""}; }
Cell text(const std::optional<double>& x) { return x ? text(*x) : Cell{}; }
Cell text(long x) { return {std::to_string(x)}; }
Cell text(const std::string& x) { return {x}; }

/// A table that learns its columns from its first line.
class Sheet {
 public:
  explicit Sheet(std::string id) { table_.id = std::move(id); }
  void begin_line() { table_.rows.emplace_back(), at_ = 0; }
  template <class T>
  void add(const std::string& name, const T& value) {
    if (at_ == table_.columns.size()) table_.columns.push_back({name});
    table_.rows.back().push_back(text(value));
    ++at_;
  }
  Table take() { return std::move(table_); }

 private:
  Table table_;
  std::size_t at_ = 0;
};

void add_errors(Sheet& sheet, const std::optional<RowErrors>& errors) {
  const auto pick = [&](auto member) -> std::optional<double> {
    return errors ? std::optional<double>((*errors).*member) : std::nullopt;
  };
  const auto maybe = [&](auto member) -> std::optional<double> {
    return errors ? (*errors).*member : std::nullopt;
  };
  sheet.add("error", pick(&RowErrors::scaled));
  sheet.add("error_absolute", pick(&RowErrors::absolute));
  sheet.add("error_relative", maybe(&RowErrors::relative));
  sheet.add("error_rms", pick(&RowErrors::rms));
  sheet.add("trajectory_max", maybe(&RowErrors::trajectory_max));
  sheet.add("trajectory_rms", maybe(&RowErrors::trajectory_rms));
  sheet.add("amplitude_error", maybe(&RowErrors::amplitude));
  sheet.add("phase_error", maybe(&RowErrors::phase));
}

void add_timing(Sheet& sheet, const std::optional<RowTiming>& timing) {
  const auto pick = [&](auto member) -> std::optional<double> {
    return timing ? std::optional<double>((*timing).*member) : std::nullopt;
  };
  sheet.add("seconds_minimum", pick(&RowTiming::minimum_seconds));
  sheet.add("seconds_median", pick(&RowTiming::median_seconds));
  sheet.add("seconds_mad", pick(&RowTiming::mad_seconds));
  sheet.add("repeats", timing ? std::to_string(timing->repeats) : std::string());
  sheet.add("ns_per_step", pick(&RowTiming::ns_per_step));
  sheet.add("ns_per_simulated_second", pick(&RowTiming::ns_per_simulated_second));
  sheet.add("tier", timing ? timing->tier : std::string());
}

}  // namespace

Table rows_table(const std::vector<Row>& rows) {
  std::set<std::string> invariants;
  for (const Row& row : rows)
    for (const auto& [name, drift] : row.drift) invariants.insert(name);
  Sheet sheet("rows");
  for (const Row& r : rows) {
    sheet.begin_line();
    for (const auto& [name, value] : {std::pair{"id", &r.id},
                                      {"plan", &r.plan},
                                      {"problem", &r.problem},
                                      {"settings", &r.settings},
                                      {"method", &r.method},
                                      {"kind", &r.kind},
                                      {"provider", &r.provider},
                                      {"scalar", &r.scalar}})
      sheet.add(name, *value);
    sheet.add("compensated", std::string(r.compensated ? "yes" : "no"));
    sheet.add("order", static_cast<long>(r.order));
    sheet.add("steps", r.steps ? std::to_string(*r.steps) : std::string());
    sheet.add("dt", r.dt);
    sheet.add("rtol", r.rtol);
    sheet.add("atol", r.atol);
    sheet.add("filter", r.filter);
    sheet.add("status", r.status);
    sheet.add("reason", r.reason);
    sheet.add("accepted", r.accepted);
    sheet.add("rejected", r.rejected);
    sheet.add("t_end", r.t_end);
    sheet.add("t_reached", r.t_reached);
    add_errors(sheet, r.errors);
    sheet.add("truth_floor", r.truth_floor);
    sheet.add("sensitivity", r.sensitivity);
    for (const auto& [name, count] : {std::pair{"evaluations", r.work.evaluations},
                                      {"rhs", r.work.rhs},
                                      {"acceleration", r.work.acceleration},
                                      {"jacobian", r.work.jacobian},
                                      {"series", r.work.series},
                                      {"lu", r.work.lu},
                                      {"newton", r.work.newton}})
      sheet.add(name, count);
    sheet.add("events_found", r.events ? std::to_string(r.events->found) : std::string());
    sheet.add("events_expected", r.events ? std::to_string(r.events->expected) : std::string());
    sheet.add("event_time_error", r.events ? r.events->worst_time_error : std::nullopt);
    add_timing(sheet, r.timing);
    for (const auto& name : invariants) {
      const auto at = r.drift.find(name);
      sheet.add("drift_" + name, at == r.drift.end() ? std::optional<double>() : std::optional(at->second));
    }
    sheet.add("state_hash", r.state_hash);
  }
  return sheet.take();
}

Table stability_table(const std::vector<StabilityRow>& rows) {
  Sheet sheet("stability");
  for (const StabilityRow& r : rows) {
    sheet.begin_line();
    for (const auto& [name, value] : {std::pair{"problem", &r.problem},
                                      {"settings", &r.settings},
                                      {"method", &r.method},
                                      {"kind", &r.kind},
                                      {"provider", &r.provider},
                                      {"scalar", &r.scalar},
                                      {"verdict", &r.verdict},
                                      {"reason", &r.reason},
                                      {"theory_verdict", &r.theory_verdict}})
      sheet.add(name, *value);
    sheet.add("measured_s", r.measured);
    sheet.add("theory_s", r.theory);
    sheet.add("difference_s", r.difference);
    sheet.add("resolution_s", r.resolution);
    sheet.add("scanned_to_s", r.scanned_to);
    sheet.add("fastest_rate_per_s", r.fastest_rate);
    sheet.add("reference_dt_s", r.reference_dt);
    sheet.add("growth_per_second", r.growth_per_second);
    sheet.add("theory_growth_per_second", r.theory_growth_per_second);
  }
  return sheet.take();
}

}  // namespace odemark
