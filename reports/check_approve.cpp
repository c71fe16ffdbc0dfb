// Approving: the new baseline from a run, and what it changes, as a table to be read before it is committed.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>

#include "reports/baseline.hpp"
#include "reports/format.hpp"

namespace odemark {
namespace {

std::string error_text(const BaselineRun& run) {
  return run.scaled ? scientific(*run.scaled, 3) : std::string(no_value);
}

bool same_bits(const BaselineRun& a, const BaselineRun& b) {
  const auto same = [](const auto& x, const auto& y) {
    return x.first == y.first && (x.second == y.second || (std::isnan(x.second) && std::isnan(y.second)));
  };
  return a.case_name == b.case_name && a.provider == b.provider && a.status == b.status &&
         a.scaled == b.scaled && a.evaluations == b.evaluations && a.accepted == b.accepted &&
         a.rejected == b.rejected && a.state_hash == b.state_hash &&
         std::equal(a.drift.begin(), a.drift.end(), b.drift.begin(), b.drift.end(), same);
}

Change change_of(const BaselineRun& now, const BaselineRun& before) {
  const Change status = judge_status(now.status, before.status);
  if (status != Change::same || !now.scaled || !before.scaled) return status;
  return judge_change(*now.scaled, *before.scaled, 1, 0);
}

void add_change(Table& table, const std::string& id, const std::string& what, Status status,
                const BaselineRun* before, const BaselineRun* now) {
  const auto side = [&](const BaselineRun* run, auto&& print) {
    return Cell{run ? print(*run) : std::string(no_value)};
  };
  const auto status_text = [](const BaselineRun& run) { return run.status; };
  const auto evaluations = [](const BaselineRun& run) { return fmt::format("{}", run.evaluations); };
  table.rows.push_back({{id},
                        {what, status},
                        side(before, status_text),
                        side(now, status_text),
                        side(before, error_text),
                        side(now, error_text),
                        side(before, evaluations),
                        side(now, evaluations)});
}

std::regex expression(std::string_view only) {
  try {
    return std::regex(only.begin(), only.end());
  } catch (const std::regex_error&) {
    throw std::invalid_argument(fmt::format("\"{}\" is no regular expression", only));
  }
}

}  // namespace

Approval approve(const std::vector<Row>& rows, const RunHeader& header, const std::optional<Baseline>& old,
                 std::string_view reason, std::string_view only) {
  if (std::all_of(reason.begin(), reason.end(), [](unsigned char c) { return std::isspace(c); }))
    throw std::invalid_argument("approve needs a reason: who reads the diff later wants to know why");
  const std::regex pattern = expression(only);
  const auto chosen = [&](const std::string& name) {
    return only.empty() || std::regex_search(name, pattern);
  };
  const Baseline received = make_baseline(rows, header, std::string(reason));
  Baseline next = received;
  next.runs.clear(), next.orders.clear();
  bool any = false;
  if (old) {
    for (const auto& [id, run] : old->runs)
      if (!chosen(run.case_name)) next.runs.emplace(id, run);
    for (const auto& [name, order] : old->orders)
      if (!chosen(name)) next.orders.emplace(name, order);
  }
  for (const auto& [id, run] : received.runs)
    if (chosen(run.case_name)) any = true, next.runs.insert_or_assign(id, run);
  for (const auto& [name, order] : received.orders)
    if (chosen(name)) next.orders.insert_or_assign(name, order);
  if (!any)
    throw std::invalid_argument(only.empty() ? std::string("there is no executed run to approve")
                                             : fmt::format("no executed case matches \"{}\"", only));

  Approval approval;
  approval.text = to_text(next);
  Table& table = approval.changes;
  table.id = "approval", table.title = "Changes to the baseline", table.note = reason;
  table.columns = {{"run"}, {"change"}, {"status before"}, {"status now"}};
  for (const char* name : {"error before", "error now", "evaluations before", "evaluations now"})
    table.columns.push_back({name, Align::right});
  const std::map<std::string, BaselineRun> none;
  const auto& before = old ? old->runs : none;
  for (const auto& [id, run] : next.runs) {
    const auto found = before.find(id);
    if (found == before.end()) {
      ++approval.added;
      add_change(table, id, "new", Status::note, nullptr, &run);
    } else if (!same_bits(run, found->second)) {
      ++approval.changed;
      const Change change = change_of(run, found->second);
      add_change(table, id,
                 change == Change::worse    ? "worse"
                 : change == Change::better ? "better"
                                            : "other",
                 change == Change::worse    ? Status::warn
                 : change == Change::better ? Status::ok
                                            : Status::note,
                 &found->second, &run);
    }
  }
  for (const auto& [id, run] : before)
    if (!next.runs.contains(id)) {
      ++approval.removed;
      add_change(table, id, "gone", Status::warn, &run, nullptr);
    }
  return approval;
}

}  // namespace odemark
