// Any bytes as a results file: rows, or one sentence with a line number; what was read can be written and
// read again.
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "bench/json_line.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace odemark;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const Results results = parse_results(text, "fuzz");
    std::string written = to_json_line(results.header) + "\n";
    for (const auto& row : results.rows) written += to_json_line(row) + "\n";
    for (const auto& row : results.stability) written += to_json_line(row) + "\n";
    const Results again = parse_results(written, "again");
    if (again.rows.size() != results.rows.size() || again.stability.size() != results.stability.size())
      std::abort();
    std::string rewritten = to_json_line(again.header) + "\n";
    for (const auto& row : again.rows) rewritten += to_json_line(row) + "\n";
    for (const auto& row : again.stability) rewritten += to_json_line(row) + "\n";
    if (written != rewritten) std::abort();
  } catch (const BadResults& e) {
    if (std::strncmp(e.what(), "fuzz", 4) != 0) std::abort();
  }
  return 0;
}
