// Whatever bytes are called thresholds.toml or baseline.json: read, or refused with a sentence; nothing else.
// clang++ -fsanitize=fuzzer,address,undefined, or with run_corpus.cpp for one pass over the corpus.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "reports/baseline.hpp"
#include "reports/check.hpp"
#include "reports/thresholds.hpp"

namespace {

void require(bool fine) {
  if (!fine) std::abort();
}

void read_thresholds(std::string_view text) {
  try {
    const auto thresholds = odemark::parse_thresholds(text, "fuzz.toml");
    const auto result = odemark::check({}, {}, thresholds, {});
    require(odemark::exit_code(result) == 3);  // nothing was run: never a pass
  } catch (const odemark::BadThresholds& e) {
    require(std::string_view(e.what()).starts_with("fuzz.toml:"));
  }
}

void read_baseline(std::string_view text) {
  try {
    const auto written = odemark::to_text(odemark::parse_baseline(text));
    require(odemark::to_text(odemark::parse_baseline(written)) == written);
  } catch (const odemark::BadBaseline& e) {
    require(std::string_view(e.what()).starts_with("baseline.json: "));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  read_thresholds(text);
  read_baseline(text);
  return 0;
}
