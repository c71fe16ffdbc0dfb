// Drift of invariants, amplitude and phase errors.
#include "reports/conservation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/format.hpp"
#include "reports/shown_error.hpp"
#include "reports/work_curves.hpp"

namespace odemark {
namespace {

/// Fixed-step runs of each method with the dt nearest to the wanted one, on a logarithmic scale.
std::vector<const Row*> nearest(const std::vector<Row>& rows, const std::string& problem, double dt) {
  std::vector<const Row*> chosen;
  const auto distance = [dt](const Row& row) { return std::abs(std::log(*row.dt / dt)); };
  for (const Row& row : rows) {
    if (row.problem != problem || !row.dt || row.status == "not_applicable") continue;
    const auto same = std::find_if(chosen.begin(), chosen.end(),
                                   [&](const Row* other) { return other->method == row.method; });
    if (same == chosen.end())
      chosen.push_back(&row);
    else if (distance(row) < distance(**same))
      *same = &row;
  }
  return chosen;
}

std::vector<std::string> invariants_of(const std::vector<const Row*>& rows) {
  std::set<std::string> names;
  for (const Row* row : rows)
    for (const auto& [name, drift] : row->drift) names.insert(name);
  return {names.begin(), names.end()};
}

double drift_of(const Row& row, const std::string& name) {
  const auto at = row.drift.find(name);
  return at == row.drift.end() || row.status != "reached_end" ? absent : at->second;
}

double worst_drift(const Row& row) {
  double worst = row.status == "reached_end" ? 0 : infinity;
  for (const auto& [name, drift] : row.drift) worst = drift > worst || std::isnan(drift) ? drift : worst;
  return std::isnan(worst) ? infinity : worst;
}

Cell drift_cell(const Row& row, const std::string& name) {
  if (row.status != "reached_end") return {row.status, Status::fail, 1e300};
  const double drift = drift_of(row, name);
  return number_cell(rounded(drift, 3), scientific(drift, 2));
}

double shared_dt(const std::vector<const Row*>& rows) { return rows.empty() ? absent : *rows.front()->dt; }

}  // namespace

std::vector<std::string> conserving_problems(const std::vector<Row>& rows) {
  std::vector<std::string> problems;
  for (const Row& row : rows)
    if (!row.drift.empty() && std::find(problems.begin(), problems.end(), row.problem) == problems.end())
      problems.push_back(row.problem);
  return problems;
}

Table drift_table(const std::vector<Row>& rows, const std::string& problem, double dt) {
  Table table{problem + "-drift", "", "", {{"method"}, {"order", Align::right}}, {}};
  auto chosen = nearest(rows, problem, dt);
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(), [](const Row* r) { return r->drift.empty(); }),
               chosen.end());
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const Row* a, const Row* b) { return worst_drift(*a) < worst_drift(*b); });
  const auto names = invariants_of(chosen);
  for (const auto& name : names) table.columns.push_back({"drift of " + name, Align::right});
  table.columns.push_back({"error at the end", Align::right});
  table.title = fmt::format("{}: largest drift of what is conserved, dt = {} s", problem,
                            compact(shared_dt(chosen), 3));
  for (const Row* row : chosen) {
    std::vector<Cell> line{{row->method}, {std::to_string(row->order), Status::plain, row->order}};
    for (const auto& name : names) line.push_back(drift_cell(*row, name));
    const double error = shown_error(*row);
    line.push_back(number_cell(rounded(error, 3), scientific(error, 2)));
    table.rows.push_back(std::move(line));
  }
  return table;
}

Table oscillation_table(const std::vector<Row>& rows, const std::string& problem, double dt) {
  Table table{problem + "-oscillation", "", "", {}, {}};
  auto chosen = nearest(rows, problem, dt);
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(),
                              [](const Row* r) { return !r->errors || !r->errors->amplitude; }),
               chosen.end());
  std::stable_sort(chosen.begin(), chosen.end(), [](const Row* a, const Row* b) {
    return std::abs(*a->errors->amplitude) < std::abs(*b->errors->amplitude);
  });
  table.columns = {{"method"},
                   {"amplitude error", Align::right},
                   {"growth of the amplitude", Align::right, "1/s"},
                   {"phase error", Align::right, "rad"},
                   {"that is"}};
  table.title =
      fmt::format("{}: amplitude and phase at the end, dt = {} s", problem, compact(shared_dt(chosen), 3));
  for (const Row* row : chosen) {
    const double amplitude = *row->errors->amplitude, phase = row->errors->phase.value_or(absent);
    const double growth = std::log1p(amplitude) / row->t_end;
    table.rows.push_back({{row->method},
                          number_cell(rounded(amplitude, 3), scientific(amplitude, 2)),
                          number_cell(rounded(growth, 3), scientific(growth, 2)),
                          number_cell(rounded(phase, 3), scientific(phase, 2)),
                          {phase > 0   ? "runs fast"
                           : phase < 0 ? "runs slow"
                                       : "",
                           Status::plain}});
  }
  table.note = "Amplitude above 0: the step feeds energy; below: it damps. Phase is unwrapped along the run.";
  return table;
}

std::string drift_answer(const std::vector<Row>& rows, const std::string& problem, double dt) {
  auto chosen = nearest(rows, problem, dt);
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(),
                              [](const Row* r) { return r->drift.empty() || r->status != "reached_end"; }),
               chosen.end());
  if (chosen.empty()) return "";
  const auto less = [](const Row* a, const Row* b) { return worst_drift(*a) < worst_drift(*b); };
  const Row* best = *std::min_element(chosen.begin(), chosen.end(), less);
  const Row* worst = *std::max_element(chosen.begin(), chosen.end(), less);
  std::string text =
      fmt::format("{}: at dt = {} s the least drift is {} ({})", problem, compact(shared_dt(chosen), 3),
                  scientific(worst_drift(*best), 1), best->method);
  if (worst != best)
    text += fmt::format(", the largest {} ({})", scientific(worst_drift(*worst), 1), worst->method);
  return text + ".";
}

}  // namespace odemark
