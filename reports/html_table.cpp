// A table as HTML: scrolls inside its own container, complete without script.
#include <fmt/format.h>

#include <iterator>

#include "reports/markup.hpp"
#include "reports/table.hpp"
#include "reports/table_rows.hpp"

namespace odemark {
namespace {

constexpr std::size_t long_table = 12;  // rows; the script of the page offers a filter beyond

std::string classes(Align align, Status status) {
  std::string names = align == Align::right ? "right" : align == Align::centre ? "centre" : "";
  if (status != Status::plain) (names += names.empty() ? "" : " ") += to_string(status);
  return names.empty() ? "" : fmt::format(" class=\"{}\"", names);
}

std::string cell_html(const Cell& cell) {
  const std::string text = escaped(cell.text);
  if (cell.link.empty() || !is_safe_link(cell.link)) return text;
  return fmt::format("<a href=\"{}\">{}</a>", escaped(cell.link), text);
}

}  // namespace

std::string to_html(const Table& table) {
  const auto rows = full_rows(table);
  const std::string name = escaped(table.title.empty() ? "table" : table.title);
  std::string out = "<div class=\"table\"";
  if (!table.id.empty()) fmt::format_to(std::back_inserter(out), " id=\"{}\"", safe_id(table.id));
  // Focusable, so that a keyboard can scroll it.
  fmt::format_to(std::back_inserter(out),
                 ">\n<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"{}\">\n", name);
  out += "<table>\n";
  // those that scroll inside their container, so that nobody takes what is seen for all
  const std::string size =
      rows.size() > long_table ? fmt::format("<span class=\"rows\">{} rows</span>", rows.size()) : "";
  if (!table.title.empty() || !size.empty())
    fmt::format_to(std::back_inserter(out), "<caption>{}{}</caption>\n", escaped(table.title), size);
  out += "<thead><tr>";
  for (const Column& column : table.columns) {
    if (column.name.empty() && column.unit.empty()) {  // heads nothing, and the script sorts nothing by it
      out += "<td></td>";
      continue;
    }
    fmt::format_to(std::back_inserter(out), "<th scope=\"col\"{}>{}", classes(column.align, Status::plain),
                   escaped(column.name));
    if (!column.unit.empty())
      fmt::format_to(std::back_inserter(out), " <span class=\"unit\">[{}]</span>", escaped(column.unit));
    out += "</th>";
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows) {
    out += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) {
      fmt::format_to(std::back_inserter(out), "<td{}", classes(table.columns[c].align, row[c].status));
      if (row[c].sort) fmt::format_to(std::back_inserter(out), " data-sort=\"{}\"", *row[c].sort);
      // end tags of cells and rows are optional in HTML, and would be a tenth of a page of tables
      fmt::format_to(std::back_inserter(out), ">{}", cell_html(row[c]));
    }
    out += "\n";
  }
  out += "</tbody>\n</table>\n</div>\n";
  if (!table.note.empty())
    fmt::format_to(std::back_inserter(out), "<p class=\"tablenote\">{}</p>\n", escaped(table.note));
  return out + "</div>\n";
}

}  // namespace odemark
