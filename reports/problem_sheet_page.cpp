#include "reports/problem_sheet_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/format.hpp"

namespace odemark {

namespace {

std::string number(double x) { return compact(x, 4); }
std::string rate(double x) { return x == 0 ? "0" : compact(x, 3); }
std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}
std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

Equations equations_of(const ProblemSheet& sheet) {
  Equations equations{sheet.equations, {}};
  for (const auto& [name, unit] : sheet.components) equations.names.push_back(name);
  for (const auto& p : sheet.parameters) equations.names.push_back(p.name);
  return equations;
}

Table parameters_table(const ProblemSheet& sheet) {
  Table table{"parameters",
              "Parameters",
              "",
              {{"name"}, {"value", Align::right}, {"unit"}, {"range"}, {"meaning"}},
              {}};
  for (const auto& p : sheet.parameters)
    table.rows.push_back(
        {{p.name},
         p.shorthand ? Cell{"shorthand", Status::muted} : number_cell(p.value, number(p.value)),
         {p.unit},
         {p.range},
         {p.meaning}});
  table.note = "Values of the first preset; change them with --set.";
  return table;
}

Table presets_table(const ProblemSheet& sheet) {
  Table table{"presets", "Presets", "", {{"preset"}, {"settings"}, {"why it is there"}}, {}};
  for (const char* name : {"t_end", "suggested dt"}) table.columns.push_back({name, Align::right});
  for (const auto& p : sheet.presets)
    table.rows.push_back({{p.id},
                          {p.settings},
                          {p.about},
                          number_cell(p.t_end, number(p.t_end)),
                          number_cell(p.suggested_dt, number(p.suggested_dt))});
  return table;
}

Cell digits_cell(const SheetPreset& p) {
  return p.digits > 0 ? number_cell(p.digits, fmt::format("{}", p.digits)) : Cell{"none", Status::warn, 0};
}

Table truth_table(const ProblemSheet& sheet) {
  Table table{"truth", "Truth", "", {{"preset"}, {"digits", Align::right}, {"found by"}, {"checked by"}}, {}};
  table.columns.push_back({"one ulp of y(0)", Align::right});
  if (!sheet.events.empty()) table.columns.push_back({"events", Align::right});
  for (const auto& p : sheet.presets) {
    table.rows.push_back({{p.id},
                          digits_cell(p),
                          {p.origin},
                          {p.checked_by},
                          number_cell(p.sensitivity, scientific(p.sensitivity, 1))});
    if (!sheet.events.empty())
      table.rows.back().push_back(number_cell(double(p.events), fmt::format("{}", p.events)));
  }
  table.note =
      "Certified digits in units of the scale, at the worst of 16 times; the change of the end, in units of "
      "the scale, "
      "when y(0) moves by one ulp of double is the floor of every error.";
  return table;
}

Table spectrum_table(const ProblemSheet& sheet) {
  Table table{"spectrum", "Eigenvalues along the solution", "", {{"preset"}}, {}};
  for (const char* name : {"fastest decay", "fastest growth", "fastest turn"})
    table.columns.push_back({name, Align::right, "1/s"});
  table.columns.push_back({"stiffness ratio", Align::right});
  for (const auto& p : sheet.presets)
    table.rows.push_back({{p.id},
                          number_cell(p.fastest_decay, rate(p.fastest_decay)),
                          number_cell(p.fastest_growth, rate(p.fastest_growth)),
                          number_cell(p.fastest_turn, rate(p.fastest_turn)),
                          p.stiffness_ratio ? number_cell(*p.stiffness_ratio, rate(*p.stiffness_ratio))
                                            : Cell{std::string(no_value), Status::muted}});
  table.note =
      "Of the Jacobian at 17 times: largest -Re, largest Re, largest |Im|; the ratio is of the fastest decay "
      "to the "
      "slowest at one time.";
  return table;
}

Table limits_table(const ProblemSheet& sheet) {
  Table table{"limits", "Largest stable dt", "", {{"preset"}}, {}};
  const auto& first = sheet.presets.front().limits;
  for (const auto& limit : first) table.columns.push_back({limit.method, Align::right});
  for (const auto& p : sheet.presets) {
    std::vector<Cell> row{{p.id}};
    for (const auto& wanted : first) {
      Cell cell{std::string(no_value), Status::muted};
      for (const auto& limit : p.limits)
        if (limit.method == wanted.method)
          cell = limit.dt ? number_cell(*limit.dt, *limit.dt > 0 ? rate(*limit.dt) : "none is stable")
                          : Cell{"no limit", Status::plain, 1e300};
      row.push_back(std::move(cell));
    }
    table.rows.push_back(std::move(row));
  }
  table.note =
      "From the coefficients and the eigenvalues above, those that grow left aside; frozen at each time, so "
      "a guide and "
      "no proof for what is not linear.";
  return table;
}

/// As the cards of the report have it: where something is measured per second.
bool in_seconds(const ProblemSheet& sheet) {
  return std::any_of(sheet.components.begin(), sheet.components.end(),
                     [](const auto& component) { return component.second.find("/s") != std::string::npos; });
}

std::optional<Chart> picture(const ProblemSheet& sheet) {
  if (!sheet.scene || sheet.scene->exact.empty()) return std::nullopt;
  const Scene& scene = *sheet.scene;
  Chart chart{
      .id = "solution-of-" + sheet.id, .title = "Solution of " + scene.problem, .caption = scene.exact_is};
  const Trajectory& drawn = scene.exact.back();
  const bool path = scene.exact.size() > 1;
  chart.y.label = with_unit(drawn.component, drawn.unit);
  chart.x.label = path ? with_unit(scene.exact.front().component, scene.exact.front().unit)
                       : with_unit("t", in_seconds(sheet) ? "s" : "");
  chart.equal_aspect = path;
  Series line{"exact", "solution", "", {}, {.marker = Marker::none, .line = Line::solid}};
  for (std::size_t i = 0; i < drawn.value.size(); ++i)
    line.points.push_back({path ? scene.exact.front().value[i] : drawn.t[i], drawn.value[i]});
  chart.series.push_back(std::move(line));
  return chart;
}

}  // namespace

std::string counts_text(const std::vector<ProblemSheet>& sheets) {
  std::size_t presets = 0, closed = 0, events = 0, certified = 0;
  for (const auto& sheet : sheets) {
    presets += sheet.presets.size();
    closed += std::find(sheet.offers.begin(), sheet.offers.end(), "closed form") != sheet.offers.end();
    events += !sheet.events.empty();
    for (const auto& p : sheet.presets) certified += p.digits >= 30;
  }
  return fmt::format(
      "{} families, {} presets, {} of them certified to 30 digits or more; {} families have a closed form, "
      "{} events",
      sheets.size(), presets, certified, closed, events);
}

Table problems_overview_table(const std::vector<ProblemSheet>& sheets) {
  Table table{"problems", "Problems", "", {{"problem"}, {"title"}, {"why it is there"}}, {}};
  for (const char* name : {"n", "t_end", "digits"}) table.columns.push_back({name, Align::right});
  table.columns.push_back({"truth"});
  for (const char* name : {"events", "fastest decay", "fastest turn", "stiffness ratio"})
    table.columns.push_back({name, Align::right});
  for (const auto& sheet : sheets)
    for (const auto& p : sheet.presets)
      table.rows.push_back(
          {{p.id, Status::plain, {}, "families/" + sheet.id + ".html"},
           {sheet.title},
           {p.about},
           number_cell(double(sheet.components.size()), fmt::format("{}", sheet.components.size())),
           number_cell(p.t_end, number(p.t_end)),
           digits_cell(p),
           {p.origin},
           sheet.events.empty() ? Cell{} : number_cell(double(p.events), fmt::format("{}", p.events)),
           number_cell(p.fastest_decay, rate(p.fastest_decay)),
           number_cell(p.fastest_turn, rate(p.fastest_turn)),
           p.stiffness_ratio ? number_cell(*p.stiffness_ratio, rate(*p.stiffness_ratio)) : Cell{}});
  return table;
}

Page families_page(const std::vector<ProblemSheet>& sheets) {
  Page page;
  page.title = "Problems";
  page.subtitle = counts_text(sheets);
  page.nav = {{"the report", "report.html"}};
  page.sections.push_back({"problems", "All presets", {problems_overview_table(sheets)}});
  return page;
}

std::vector<NamedPage> family_pages(const std::vector<ProblemSheet>& sheets) {
  std::vector<NamedPage> pages;
  for (const auto& sheet : sheets) {
    Page page;
    page.title = sheet.title;
    page.subtitle = fmt::format("{}; {}", sheet.id, sheet.source);
    page.nav = {{"all problems", "../problems.html"}, {"the report", "../report.html"}};
    Section what{"what", "What it is", {equations_of(sheet)}};
    std::vector<std::string> state;
    for (const auto& [name, unit] : sheet.components) state.push_back(with_unit(name, unit));
    what.blocks.push_back(Paragraph{fmt::format("State: {}.", joined(state))});
    if (!sheet.offers.empty())
      what.blocks.push_back(Paragraph{fmt::format("It offers: {}.", joined(sheet.offers))});
    if (!sheet.invariants.empty())
      what.blocks.push_back(Paragraph{fmt::format("Invariants: {}.", joined(sheet.invariants))});
    if (!sheet.events.empty())
      what.blocks.push_back(Paragraph{fmt::format("Events: {}.", joined(sheet.events))});
    if (const auto chart = picture(sheet)) what.blocks.push_back(*chart);
    page.sections.push_back(std::move(what));
    page.sections.push_back({"parameters-and-presets",
                             "Parameters and presets",
                             {presets_table(sheet), parameters_table(sheet)}});
    page.sections.push_back({"truth-section", "Truth", {truth_table(sheet)}});
    Section stiffness{"stiffness", "Stiffness", {spectrum_table(sheet)}};
    if (!sheet.presets.front().limits.empty()) stiffness.blocks.push_back(limits_table(sheet));
    page.sections.push_back(std::move(stiffness));
    pages.push_back({"families/" + sheet.id + ".html", std::move(page)});
  }
  return pages;
}

}  // namespace odemark
