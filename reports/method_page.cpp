// Words and layout for sheets of facts.
#include "reports/method_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/format.hpp"

namespace odemark {

namespace {

constexpr int page_digits = 10;

std::string number_text(double x, int shown = page_digits) {
  if (std::isnan(x)) return std::string(no_value);
  if (std::isinf(x)) return x > 0 ? "∞" : "−∞";
  return compact(x, shown);
}

std::string text(const std::monostate&, int) { return std::string(no_value); }
std::string text(bool x, int) { return x ? "yes" : "no"; }
std::string text(int x, int) { return fmt::format("{}", x); }
std::string text(double x, int shown) { return number_text(x, shown); }
std::string text(const FactPower& law, int shown) {
  return fmt::format("{} y^{}", number_text(law.coefficient, shown), law.power);
}
std::string text(const FactIntervals& intervals, int shown) {
  std::string out;
  for (const auto& [low, high] : intervals)
    out +=
        fmt::format("{}{} … {}", out.empty() ? "" : ", ", number_text(low, shown), number_text(high, shown));
  return out.empty() ? "none" : out;
}
std::string text(const FactNumbers& numbers, int shown) {
  std::string out;
  for (const auto& [name, value] : numbers)
    out += fmt::format("{}{}: {}", out.empty() ? "" : ", ", name, number_text(value, std::min(shown, 7)));
  return out;
}

std::string value_text(const FactLine& line, int shown = page_digits) {
  return std::visit([shown](const auto& value) { return text(value, shown); }, line.value);
}

const FactLine* find(const FactSheet& sheet, std::string_view key) {
  for (const auto& line : sheet.facts)
    if (line.key == key) return &line;
  return nullptr;
}

Cell cell(const FactSheet& sheet, std::string_view key) {
  const FactLine* line = find(sheet, key);
  if (!line || std::holds_alternative<std::monostate>(line->value))
    return {std::string(no_value), Status::muted};
  if (const auto* x = std::get_if<double>(&line->value))
    return {number_text(*x, 5), Status::plain, std::isinf(*x) ? 1e300 : *x};
  if (const auto* n = std::get_if<int>(&line->value)) return {text(*n, 0), Status::plain, double(*n)};
  return {value_text(*line, 5)};
}

std::string optional_number(const std::optional<double>& x, int shown = page_digits) {
  return x ? number_text(*x, shown) : std::string(no_value);
}

bool all_agree(const FactSheet& sheet) {
  return std::all_of(sheet.measured.begin(), sheet.measured.end(),
                     [](const MeasuredFact& m) { return m.agrees; });
}

Chart region_chart(const FactSheet& sheet) {
  const StabilityRegion& region = *sheet.region;
  Chart chart{.id = "region-of-" + sheet.id, .title = "Where " + sheet.id + " is stable", .caption = ""};
  chart.x.label = "Re λ dt";
  chart.y.label = "Im λ dt";
  chart.equal_aspect = true;
  chart.x.range = {{region.re_min, region.re_max}};
  chart.y.range = {{region.im_min, region.im_max}};
  Region shape{sheet.id, sheet.id, "", {}, {}};
  const double apart = 0.012 * (region.re_max - region.re_min);
  for (const auto& polygon : region.boundaries) {
    std::vector<Position> points;
    for (const auto& z : polygon)
      if (points.empty() || std::hypot(z.real() - points.back().x, z.imag() - points.back().y) > apart)
        points.push_back({z.real(), z.imag()});
    shape.outlines.push_back(std::move(points));
  }
  chart.regions.push_back(std::move(shape));
  chart.lines = {{Direction::vertical, 0, ""}, {Direction::horizontal, 0, ""}};
  chart.caption = "Shaded: |R(z)| ≤ 1, from the coefficients that step.";
  return chart;
}

}  // namespace

Table facts_table(const FactSheet& sheet) {
  Table table{
      "facts-" + sheet.id, sheet.id, "", {{"fact"}, {"value"}, {"meaning, or why there is none"}}, {}};
  for (const auto& line : sheet.facts) {
    const bool none = std::holds_alternative<std::monostate>(line.value);
    table.rows.push_back({{line.key}, {value_text(line), none ? Status::muted : Status::plain}, {line.note}});
  }
  table.note =
      "From the coefficients that step. Intervals are in z = h λ on the axis, oscillator limits in ω h; "
      "y is the place on the imaginary axis.";
  return table;
}

Table measured_table(const FactSheet& sheet) {
  Table table{"measured-" + sheet.id, sheet.id + ", measured", "", {}, {}};
  table.columns = {{"fact"},
                   {"type"},
                   {"theory", Align::right},
                   {"measured", Align::right},
                   {"difference", Align::right},
                   {"allowed", Align::right},
                   {"agree"},
                   {"how"}};
  for (const auto& m : sheet.measured) {
    const bool compared = m.difference.has_value() || !m.agrees;
    table.rows.push_back({{m.fact},
                          {m.scalar},
                          {optional_number(m.theory)},
                          {optional_number(m.measured)},
                          {m.difference ? scientific(*m.difference, 1) : std::string(no_value)},
                          {m.bound ? scientific(*m.bound, 1) : std::string(no_value)},
                          {!compared  ? ""
                           : m.agrees ? "yes"
                                      : "no",
                           !compared  ? Status::muted
                           : m.agrees ? Status::ok
                                      : Status::fail},
                          {m.note}});
  }
  return table;
}

Table overview_table(const std::vector<FactSheet>& sheets) {
  Table table{"methods", "Methods", "", {{"method"}, {"family"}}, {}};
  const std::pair<const char*, const char*> keys[] = {{"order", "order"},
                                                      {"embedded_order", "embedded"},
                                                      {"stages", "stages"},
                                                      {"evaluations_per_step", "evaluations"},
                                                      {"error_constant", "error constant"},
                                                      {"real_interval", "real"},
                                                      {"imaginary_interval", "imaginary"},
                                                      {"oscillator_limit", "oscillator"},
                                                      {"a_alpha_degrees", "A(α)"},
                                                      {"r_infinity", "R(∞)"},
                                                      {"ssp_coefficient", "SSP"}};
  for (const auto& [key, name] : keys) table.columns.push_back({name, Align::right});
  table.columns.push_back({"keeps"});
  const bool measured =
      std::any_of(sheets.begin(), sheets.end(), [](const FactSheet& s) { return !s.measured.empty(); });
  if (measured) table.columns.push_back({"measured"});
  for (const auto& sheet : sheets) {
    std::vector<Cell> row{{sheet.id, Status::plain, {}, "methods/" + sheet.id + ".html"}, {sheet.family}};
    for (const auto& [key, name] : keys) row.push_back(cell(sheet, key));
    std::string keeps;
    for (const char* key : {"symplectic", "symmetric"})
      if (const auto* line = find(sheet, key))
        if (const auto* yes = std::get_if<bool>(&line->value); yes && *yes)
          keeps += (keeps.empty() ? "" : ", ") + std::string(key);
    row.push_back({keeps});
    if (measured)
      row.push_back(sheet.measured.empty() ? Cell{}
                    : all_agree(sheet)     ? Cell{"agrees", Status::ok}
                                           : Cell{"differs", Status::fail});
    table.rows.push_back(std::move(row));
  }
  table.note =
      "Computed from the coefficients that step; – where a notion does not apply, for the reason on the "
      "method's own page.";
  return table;
}

Page methods_page(const std::vector<FactSheet>& sheets) {
  Page page;
  page.title = "Methods";
  page.nav = {{"the report", "report.html"}};
  page.sections.push_back({"methods", "Facts", {overview_table(sheets)}});
  Table advice{"advice", "When to use what", "", {{"method"}, {"advice"}}, {}};
  for (const auto& sheet : sheets)
    if (!sheet.advice.empty()) advice.rows.push_back({{sheet.id}, {sheet.advice}});
  if (!advice.rows.empty()) page.sections.push_back({"advice", "Advice", {std::move(advice)}});
  return page;
}

std::vector<NamedPage> method_pages(const std::vector<FactSheet>& sheets) {
  std::vector<NamedPage> pages;
  for (const auto& sheet : sheets) {
    Page page;
    page.title = sheet.id;
    page.subtitle = fmt::format("{}; {}", sheet.family, sheet.source);
    page.nav = {{"all methods", "../methods.html"}, {"the report", "../report.html"}};
    Section facts{"facts", "Facts", {}};
    if (!sheet.advice.empty()) facts.blocks.push_back(Paragraph{sheet.advice, Status::note});
    facts.blocks.push_back(facts_table(sheet));
    if (sheet.region && !sheet.region->boundaries.empty()) facts.blocks.push_back(region_chart(sheet));
    page.sections.push_back(std::move(facts));
    if (!sheet.measured.empty()) {
      page.verdict = all_agree(sheet)
                         ? Verdict{Status::ok, "What was measured agrees with the coefficients."}
                         : Verdict{Status::fail, "What was measured does not agree with the coefficients."};
      page.sections.push_back({"measured", "Measured from the compiled step", {measured_table(sheet)}});
    }
    pages.push_back({"methods/" + sheet.id + ".html", std::move(page)});
  }
  return pages;
}

}  // namespace odemark
