// How it was measured: definitions, machine, versions, notes.
#include <fmt/format.h>

#include <algorithm>

#include "reports/format.hpp"
#include "reports/report_page.hpp"

namespace odemark {
namespace {

Table definitions() {
  Table table{"definitions", "What the numbers mean", "", {{"word"}, {"meaning"}}, {}};
  table.rows = {
      {{"error"},
       {"at the end of the run: the largest |y - truth| over the components, each in units of its scale"}},
      {{"scale"},
       {"a typical size of each component, given by the problem; results files have the absolute error too"}},
      {{"truth"},
       {"two independent computations, or a closed form and one, to the digits in which they agree; inputs "
        "are decimals rounded to double first, as a program reads them"}},
      {{"round-off"},
       {"the shaded floor: the largest of the truth's own bound, what one ulp of y(0) does to the end, "
        "and the unit roundoff; no error below it is claimed"}},
      {{"common grid"},
       {"16 equal parts of the interval; numbers of steps are multiples of 16, so that errors along "
        "the way are of steps, not of interpolation"}},
      {{"dt, tolerance"},
       {"fixed steps: the interval divided by a whole number; error control: relative tolerance "
        "equal to the absolute one, in units of the scale"}},
      {{"evaluations"},
       {"of the right-hand side in any form, counted; a Taylor expansion of order p counts as p; "
        "Jacobians and matrix solves are counted apart"}},
      {{"time"},
       {"wall time of the same request run again bare, the smallest of at least five; the timed run must end "
        "in the same bits as the counted one"}},
      {{"per simulated second"},
       {"that time divided by the length of the interval, so that problems can be compared"}},
      {{"static, erased"},
       {"right-hand side inlined into the step, or called through a pointer as a library would"}},
      {{"order holds"},
       {"the fitted slope is at least the claimed order - 0.3 where the error is neither round-off "
        "nor too large to converge; more than 0.3 above is said to exceed"}},
      {{"largest stable dt"},
       {"by bisection on the eigenvalues of one compiled step; in theory: from the "
        "coefficients"}}};
  return table;
}

Table machine(const RunHeader& h) {
  Table table{"machine", "Where and with what", "", {{"what"}, {"value"}}, {}};
  const auto add = [&](const std::string& what, const std::string& value) {
    if (!value.empty()) table.rows.push_back({{what}, {value}});
  };
  add("suite", h.suite);
  add("odemark", h.revision.empty() ? h.version : fmt::format("{} ({})", h.version, h.revision));
  add("date", h.date);
  add("compiler", h.compiler);
  add("flags", fmt::format("{} {}", h.build_type, h.flags));
  add("processor", h.processor);
  add("cores", h.cores > 0 ? std::to_string(h.cores) : "");
  add("system", h.system);
  for (const auto& [name, version] : h.providers) add(name, version);
  return table;
}

Table method_notes(const std::vector<MethodCard>& methods, const std::vector<ProblemCurves>& problems) {
  Table table{"method-notes", "Methods in these results", "", {}, {}};
  table.columns = {{"method"}, {"kind"}, {"order", Align::right}, {"by"}, {"note"}, {"source"}};
  for (const MethodCard& m : methods) {
    const bool used = std::any_of(problems.begin(), problems.end(), [&](const ProblemCurves& p) {
      return std::any_of(p.curves.begin(), p.curves.end(), [&](const auto& c) { return c.method == m.id; });
    });
    if (!used) continue;
    std::string note = m.note;
    if (!m.starter.empty()) note += (note.empty() ? "" : "; ") + fmt::format("started by {}", m.starter);
    table.rows.push_back({{m.id},
                          {m.kind},
                          {std::to_string(m.order), Status::plain, m.order},
                          {m.provider},
                          {note},
                          {m.source}});
  }
  return table;
}

}  // namespace

Section how_section(const ReportData& data) {
  Section section{"how", "How it was measured", {}};
  section.blocks.push_back(Paragraph{
      "Error, work and time of a number come from one and the same request; a hash of the final bits "
      "proves it. A run that fails is a row like any other."});
  if (data.input.cut)
    section.blocks.push_back(
        Paragraph{"The results file ends in the middle of a line, which was left out: the run "
                  "was interrupted. `odemark run --resume` completes it.",
                  Status::warn});
  for (const auto& footnote : data.input.header.footnotes)
    section.blocks.push_back(Paragraph{footnote, Status::note});
  section.blocks.push_back(definitions());
  section.blocks.push_back(machine(data.input.header));
  if (Table notes = method_notes(data.input.pictures.methods, data.problems); !notes.rows.empty())
    section.blocks.push_back(std::move(notes));
  if (!data.input.beside.empty()) {
    Table files{"files", "Files beside this page", "", {{"file"}, {"what it is"}}, {}};
    for (const Link& link : data.input.beside)
      files.rows.push_back({{link.href, Status::plain, std::nullopt, link.href}, {link.text}});
    section.blocks.push_back(std::move(files));
  }
  return section;
}

}  // namespace odemark
