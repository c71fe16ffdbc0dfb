// Tables as Markdown, CSV and console text; HTML is in html_table.cpp.
#include "reports/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reports/format.hpp"
#include "reports/markup.hpp"
#include "reports/table_rows.hpp"
#include "reports/unicode.hpp"

namespace odemark {
namespace {

std::string markdown_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n') {
      out += "<br>";
    } else if (c == '<') {
      out += "&lt;";
    } else {
      if (std::string_view("\\|`*[]").find(c) != std::string_view::npos) out += '\\';
      out += c;
    }
  }
  return out;
}

std::string markdown_cell(const Cell& cell) {
  std::string text = markdown_text(cell.text);
  if (cell.link.empty() || !is_safe_link(cell.link)) return text;
  std::string target;
  for (const char c : cell.link) {
    const bool breaks = std::string_view(" ()|<>").find(c) != std::string_view::npos;
    target += breaks ? fmt::format("%{:02X}", static_cast<unsigned char>(c)) : std::string(1, c);
  }
  return fmt::format("[{}]({})", text, target);
}

std::string csv_field(std::string_view field) {
  const bool plain = field.find_first_of(",\"\r\n") == field.npos &&
                     (field.empty() || (field.front() != ' ' && field.back() != ' '));
  if (plain) return std::string(field);
  std::string out = "\"";
  for (const char c : field) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

std::string padded(std::string_view text, int width, Align align) {
  const int spare = std::max(width - column_width(text), 0);
  const int before = align == Align::left ? 0 : align == Align::right ? spare : spare / 2;
  return std::string(static_cast<std::size_t>(before), ' ') + std::string(text) +
         std::string(static_cast<std::size_t>(spare - before), ' ');
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return text;
}

void add_line(std::string& out, std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  out += line + '\n';
}

}  // namespace

std::string_view to_string(Status status) {
  switch (status) {
    case Status::plain: return "plain";
    case Status::ok: return "ok";
    case Status::fail: return "fail";
    case Status::warn: return "warn";
    case Status::note: return "note";
    case Status::muted: return "muted";
  }
  throw std::logic_error("unknown status");
}

Cell number_cell(double x, std::string text) {
  if (!std::isfinite(x)) return {std::string(no_value), Status::muted};
  return {std::move(text), Status::plain, x};
}

std::string header_text(const Column& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

std::vector<std::vector<Cell>> full_rows(const Table& table) {
  std::vector<std::vector<Cell>> rows = table.rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() > table.columns.size())
      throw std::invalid_argument(fmt::format("table '{}': row {} has {} cells for {} columns", table.title,
                                              i + 1, rows[i].size(), table.columns.size()));
    rows[i].resize(table.columns.size());
  }
  return rows;
}

std::string to_markdown(const Table& table) {
  std::string out = table.title.empty() ? "" : fmt::format("### {}\n\n", markdown_text(table.title));
  std::string rule = "|";
  out += '|';
  for (const Column& column : table.columns) {
    out += fmt::format(" {} |", markdown_text(header_text(column)));
    rule += column.align == Align::right ? " ---: |" : column.align == Align::centre ? " :---: |" : " --- |";
  }
  out += '\n' + rule + '\n';
  for (const auto& row : full_rows(table)) {
    out += '|';
    for (const Cell& cell : row) out += fmt::format(" {} |", markdown_cell(cell));
    out += '\n';
  }
  if (!table.note.empty()) out += '\n' + markdown_text(table.note) + '\n';
  return out;
}

std::string to_csv(const Table& table) {
  std::string out;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    out += (i > 0 ? "," : "") + csv_field(header_text(table.columns[i]));
  out += "\r\n";
  for (const auto& row : full_rows(table)) {
    for (std::size_t i = 0; i < row.size(); ++i) out += (i > 0 ? "," : "") + csv_field(row[i].text);
    out += "\r\n";
  }
  return out;
}

std::string to_text(const Table& table) {
  const auto rows = full_rows(table);
  std::vector<int> widths;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    int width = column_width(one_line(header_text(table.columns[c])));
    for (const auto& row : rows) width = std::max(width, column_width(one_line(row[c].text)));
    widths.push_back(width);
  }
  std::string out = table.title.empty() ? "" : one_line(table.title) + "\n\n";
  std::string header;
  std::string rule;
  for (std::size_t c = 0; c < widths.size(); ++c) {
    const std::string_view gap = c > 0 ? "  " : "";
    header += fmt::format("{}{}", gap,
                          padded(one_line(header_text(table.columns[c])), widths[c], table.columns[c].align));
    rule += gap;
    for (int i = 0; i < widths[c]; ++i) rule += "─";
  }
  add_line(out, header);
  add_line(out, rule);
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      line += (c > 0 ? "  " : "") + padded(one_line(row[c].text), widths[c], table.columns[c].align);
    add_line(out, line);
  }
  if (!table.note.empty()) out += '\n' + table.note + '\n';
  return out;
}

}  // namespace odemark
