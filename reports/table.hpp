// The one shape between analysis and rendering: analyses fill a Table, renderers only lay it out.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odemark {

// What a cell, badge or banner says beyond its words. Renderers add a sign to ok, warn and fail: never colour
// alone.
enum class Status { plain, ok, fail, warn, note, muted };

std::string_view to_string(Status status);

enum class Align { left, right, centre };

struct Column {
  std::string name;
  Align align = Align::left;
  std::string unit{};  // printed as "name [unit]"
};

struct Cell {
  std::string text;
  Status status = Status::plain;
  std::optional<double> sort{};  // sorts by this instead of the text
  std::string link{};
};

// A number with its printed form; one that is not finite becomes the muted dash and sorts last.
Cell number_cell(double x, std::string text);

struct Table {
  std::string id;  // names the anchor in a page
  std::string title;
  std::string note;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  // a short row ends in blanks; surplus cells are an error
};

// Each throws std::invalid_argument for a row with more cells than columns.
std::string to_markdown(const Table& table);  // GitHub flavour
std::string to_csv(const Table& table);       // RFC 4180: CRLF, quotes doubled; title and note are not data
std::string to_text(const Table& table);      // for a console; columns line up for any UTF-8
std::string to_html(const Table& table);      // complete without script; data-sort feeds a sorting script

}  // namespace odemark
