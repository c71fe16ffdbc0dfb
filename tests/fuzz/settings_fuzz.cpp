// Any text as settings of any problem: a problem, or one sentence; never a crash, never a problem out of its
// range.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "reference/any_problem.hpp"
#include "reference/bad_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace odemark;
  if (size > 4096) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  // the first byte chooses the family, so that every family's ranges and shorthands are reached
  const auto& families = suite_families();
  const auto& family = families[size == 0 ? 0 : data[0] % families.size()];
  const std::string_view settings = text.substr(size == 0 ? 0 : 1);
  try {
    const auto parsed = parse_settings(settings);
    const auto again = parse_settings(to_string(parsed));
    if (to_string(again) != to_string(parsed)) std::abort();
    const AnyProblem problem = find_problem(families, family.id, settings);
    for (const auto& p : problem.parameters) {
      const bool low = p.range.open_below ? p.value > p.range.lowest : p.value >= p.range.lowest;
      const bool high = p.range.open_above ? p.value < p.range.highest : p.value <= p.range.highest;
      if (!low || !high) std::abort();
    }
    if (!(problem.t_end > 0) || problem.size() != problem.initial.size()) std::abort();
  } catch (const BadInput& e) {
    if (*e.what() == '\0') std::abort();
  }
  try {
    if (!std::isfinite(parse_number("x", text))) std::abort();
  } catch (const BadInput&) {
  }
  return 0;
}
