// Stability limits as tables, and the section that holds them.
#include "reports/stability_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/format.hpp"
#include "reports/numbers.hpp"
#include "reports/verdict.hpp"
#include "reports/work_curves.hpp"

namespace odemark {
namespace {

constexpr double agreement = 1e-6;  // relative, beside the resolution of the measurement

StabilityMatch match_of(const StabilityRow& row) { return judge_stability(row, agreement); }

std::string growth_text(double per_second) {
  if (!std::isfinite(per_second)) return std::string(no_value);
  if (std::abs(per_second) < 9) return "× " + compact(std::exp(per_second), 4);
  return "× " + fmt::format("e^{}", compact(per_second, 3));
}

Cell verdict_cell(const StabilityRow& row) {
  if (row.verdict == "limit")
    return number_cell(rounded(row.measured.value_or(absent), 4), compact(row.measured.value_or(absent), 4));
  if (row.verdict == "unstable") return {"none", Status::warn, 0};
  if (row.verdict == "unlimited") return {"no limit", Status::plain, 1e300};
  return {std::string(no_value), Status::muted};
}

Cell measured_cell(const StabilityRow& row) {
  if (row.verdict == "limit")
    return number_cell(row.measured.value_or(absent), compact(row.measured.value_or(absent), 7));
  if (row.verdict == "unstable") return {"unstable at every dt", Status::warn, 0};
  if (row.verdict == "unlimited")
    return {fmt::format("no limit up to {}", compact(row.scanned_to, 2)), Status::plain, 1e300};
  return {row.reason.empty() ? std::string(no_value) : row.reason, Status::muted};
}

Cell theory_cell(const StabilityRow& row) {
  if (row.theory_verdict == "unlimited") return {"no limit", Status::plain, 1e300};
  if (row.theory_verdict == "unstable") return {"unstable at every dt", Status::plain, 0};
  if (row.theory) return number_cell(*row.theory, compact(*row.theory, 7));
  return {std::string(no_value), Status::muted};
}

std::string bands_text(const StabilityRow& row) {
  std::string text;
  for (const auto& [low, high] : row.later_bands)
    text += fmt::format("{}{} … {}", text.empty() ? "" : ", ", compact(low, 3), compact(high, 3));
  return text;
}

std::vector<std::string> in_order(const std::vector<StabilityRow>& rows, std::string StabilityRow::*part) {
  std::vector<std::string> names;
  for (const auto& row : rows)
    if (std::find(names.begin(), names.end(), row.*part) == names.end()) names.push_back(row.*part);
  return names;
}

Table limits(std::string id, std::string title) {
  Table table{std::move(id), std::move(title), "", {}, {}};
  table.columns = {{"method"},
                   {"largest stable dt, measured", Align::right, "s"},
                   {"in theory", Align::right, "s"},
                   {"difference", Align::right, "s"},
                   {"agree"},
                   {"dt × fastest rate", Align::right},
                   {"stable again", Align::left, "s"},
                   {"grows per s at suggested dt", Align::right}};
  return table;
}

std::vector<Cell> limit_line(const StabilityRow& row, std::string name) {
  const StabilityMatch match = match_of(row);
  std::vector<Cell> line{{std::move(name)}, measured_cell(row), theory_cell(row)};
  line.push_back(row.difference && row.verdict == "limit"
                     ? Cell{within_resolution(*row.difference, row.resolution, 2), Status::plain,
                            rounded(std::abs(*row.difference), 2)}
                     : Cell{std::string(no_value), Status::muted});
  line.push_back(match == StabilityMatch::agrees    ? Cell{"yes", Status::ok}
                 : match == StabilityMatch::differs ? Cell{"no", Status::fail}
                                                    : Cell{"no theory", Status::muted});
  const bool limited = row.verdict == "limit" && row.measured;
  line.push_back(limited ? number_cell(rounded(*row.measured * row.fastest_rate, 4),
                                       compact(*row.measured * row.fastest_rate, 4))
                         : Cell{std::string(no_value), Status::muted});
  line.push_back({bands_text(row)});
  line.push_back(row.growth_per_second ? Cell{growth_text(*row.growth_per_second), Status::warn,
                                              rounded(*row.growth_per_second)}
                                       : Cell{"", Status::muted});
  return line;
}

std::string stability_answer(const std::vector<StabilityRow>& rows) {
  const StabilityCounts counts = count_stability(rows);
  std::string text = fmt::format("{} of {} measured limits agree with the theory of their coefficients",
                                 counts.agrees, counts.agrees + counts.differs);
  const auto never =
      std::count_if(rows.begin(), rows.end(), [](const StabilityRow& r) { return r.verdict == "unstable"; });
  if (never > 0) text += fmt::format("; {} pairs are unstable at every dt, however small", never);
  return text + ".";
}

}  // namespace

StabilityCounts count_stability(const std::vector<StabilityRow>& rows) {
  StabilityCounts counts;
  for (const auto& row : rows) switch (match_of(row)) {
      case StabilityMatch::agrees: ++counts.agrees; break;
      case StabilityMatch::differs: ++counts.differs; break;
      case StabilityMatch::nothing_to_compare: ++counts.blank; break;
    }
  return counts;
}

Table limit_matrix(const std::vector<StabilityRow>& rows) {
  Table table{"stability-limits", "Largest stable dt [s]", "", {{"method"}}, {}};
  const auto problems = in_order(rows, &StabilityRow::problem);
  std::map<std::pair<std::string, std::string>, const StabilityRow*> at;
  for (const auto& row : rows) at.emplace(std::pair{row.method, row.problem}, &row);
  for (const auto& problem : problems) table.columns.push_back({problem, Align::right});
  for (const auto& method : in_order(rows, &StabilityRow::method)) {
    std::vector<Cell> line{{method}};
    bool any = false;
    for (const auto& problem : problems) {
      const auto found = at.find({method, problem});
      line.push_back(found == at.end() ? Cell{} : verdict_cell(*found->second));
      any = any || (found != at.end() && found->second->verdict != "blank");
      if (found != at.end() && match_of(*found->second) == StabilityMatch::differs)
        line.back().status = Status::fail;
    }
    if (any) table.rows.push_back(std::move(line));
  }
  table.note =
      "Found by bisection on the compiled steppers. none: the amplitude grows at every dt, however small. "
      "–: nothing was measured (the method does not apply, or chooses its own steps). Methods without any "
      "limit to measure are left out.";
  return table;
}

Table limit_table(const std::vector<StabilityRow>& rows, const std::string& problem) {
  Table table = limits(problem + "-limits", problem + ": measured and in theory");
  for (const auto& row : rows)
    if (row.problem == problem && row.verdict != "blank") table.rows.push_back(limit_line(row, row.method));
  return table;
}

Table disagreeing_limits(const std::vector<StabilityRow>& rows) {
  Table table = limits("stability-differs", "Limits that do not agree with theory");
  for (const auto& row : rows)
    if (match_of(row) == StabilityMatch::differs)
      table.rows.push_back(limit_line(row, row.problem + "/" + row.method));
  return table;
}

Table damping_table(const Pictures& pictures) {
  Table table{"damping", "What one step leaves of a mode: |R(z)|, z = λ dt", "", {{"method"}}, {}};
  for (const auto& z : pictures.damping_at)
    table.columns.push_back({z.imag() == 0 ? compact(z.real(), 4)
                             : z.real() == 0
                                 ? fmt::format("{}i", compact(z.imag(), 3))
                                 : fmt::format("{} + {}i", compact(z.real(), 3), compact(z.imag(), 3)),
                             Align::right});
  for (const auto& damping : pictures.damping) {
    if (damping.amplification.empty()) continue;
    std::vector<Cell> row{{damping.method}};
    for (const double r : damping.amplification) {
      const double off = r - 1;
      row.push_back({std::abs(off) < 1e-3 && off != 0
                         ? fmt::format("1 {} {}", off < 0 ? "−" : "+", scientific(std::abs(off), 1))
                         : compact(r, 3),
                     off > 1e-12 ? Status::warn : Status::plain, rounded(r, 4)});
    }
    table.rows.push_back(std::move(row));
  }
  table.note =
      "Along the real axis a mode should decay: the exact factor is e^z. On the imaginary axis it should "
      "stay: 1. Above 1 (!) the step amplifies. Multistep methods: the largest root.";
  return table;
}

Section stability_section(const std::vector<StabilityRow>& rows, const Pictures& pictures,
                          const Palette& palette) {
  Section section{"stability", "Stability", {}};
  if (rows.empty()) {
    section.blocks.push_back(Paragraph{"No stability limits are in these results.", Status::note});
  } else {
    section.blocks.push_back(Paragraph{stability_answer(rows)});
    if (Table differs = disagreeing_limits(rows); !differs.rows.empty())
      section.blocks.push_back(std::move(differs));
    section.blocks.push_back(limit_matrix(rows));
    for (const auto& problem : in_order(rows, &StabilityRow::problem)) {
      const bool reported = std::any_of(pictures.problems.begin(), pictures.problems.end(),
                                        [&](const ProblemCard& card) { return card.id == problem; });
      if (reported) section.blocks.push_back(limit_table(rows, problem));
    }
  }
  for (Chart& chart : region_charts(pictures, rows, palette)) section.blocks.push_back(std::move(chart));
  if (!pictures.damping.empty()) section.blocks.push_back(damping_table(pictures));
  return section;
}

}  // namespace odemark
