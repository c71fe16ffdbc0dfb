// Rows as JSON lines and back: one object a line, shortest round-trip numbers, absent values absent.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/data/row.hpp"
#include "bench/data/stability.hpp"

namespace odemark {

std::string to_json_line(const RunHeader& header);
std::string to_json_line(const Row& row);
std::string to_json_line(const StabilityRow& row);

/// Everything in a results file.
struct Results {
  RunHeader header;
  std::vector<Row> rows;
  std::vector<StabilityRow> stability;
  bool cut = false;  // the last line had no end: an interrupted write, left out
};

/// A file that is no results file, or of another schema: one sentence with the line number.
struct BadResults : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws BadResults. A last line without its newline is left out and `cut` set.
Results parse_results(std::string_view text, std::string_view name);
/// Reads a file; throws BadResults, also where it cannot be opened.
Results read_results(const std::string& path);

}  // namespace odemark
