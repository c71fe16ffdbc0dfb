#include "reference/truth_compare.hpp"

#include <algorithm>
#include <cmath>

#include "reference/truth_solver.hpp"

namespace odemark {

namespace {

constexpr int best_possible = 44;

/// floor(-log10(bound / size)), within what can be certified at all
int digits_of(const Wide& bound, const Wide& size) {
  if (bound == 0) return best_possible;
  if (size == 0) return 0;
  const long double bits = log2_size(size) - log2_size(bound);
  return std::clamp(int(std::floor(bits * std::log10(2.0L) + 1e-9L)), 0, best_possible);
}

/// "-1.2345e-03": sign, digits and exponent of a scientific decimal.
struct Scientific {
  bool negative = false;
  std::string digits;
  int exponent = 0;
};

Scientific scientific(const Wide& x, int digits) {
  std::string text = x.str(digits - 1, std::ios_base::scientific);
  Scientific parts;
  if (text.front() == '-') parts.negative = true, text.erase(0, 1);
  const std::size_t e = text.find('e');
  parts.exponent = std::stoi(text.substr(e + 1));
  for (const char c : text.substr(0, e))
    if (c != '.') parts.digits += c;
  return parts;
}

}  // namespace

TruthValue truth_value(const std::string& decimal, long double bound) {
  TruthValue value;
  const Wide wide(decimal);
  value.decimal = decimal;
  value.hi = static_cast<long double>(wide);
  value.lo = static_cast<long double>(Wide(wide - Wide(value.hi)));
  value.bound = bound;
  value.digits = digits_of(Wide(bound), abs(wide));
  return value;
}

TruthValue truth_value(const Wide& value, const Wide& bound) {
  const int digits = std::min(digits_of(bound, abs(value)) + 4, 47);
  const std::string decimal = value == 0 ? "0" : value.str(std::max(digits, 8));
  const Wide total = bound + abs(Wide(decimal) - value);
  return truth_value(decimal, static_cast<long double>(total) * 1.0001L);
}

int digits_in_scale(const std::vector<TruthValue>& values, const std::vector<double>& scale) {
  int worst = best_possible;
  for (std::size_t i = 0; i < values.size(); ++i)
    worst = std::min(worst, digits_of(Wide(values[i].bound), Wide(scale[i] > 0 ? scale[i] : 1)));
  return worst;
}

TruthPoint compare(const Wide& t, const std::vector<Wide>& a, const std::vector<Wide>& b,
                   const std::vector<double>& scale) {
  TruthPoint point;
  point.t = static_cast<double>(t);
  Wide worst = Wide("1e-45");
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Wide distance = abs(a[i] - b[i]) / error_unit(a[i], 1, scale[i]);
    if (!(distance <= worst)) worst = distance;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Wide own = 10 * abs(a[i] - b[i]), least = worst * abs(a[i]);
    point.values.push_back(truth_value(a[i], own > least ? own : least));
  }
  point.digits = digits_in_scale(point.values, scale);
  return point;
}

std::vector<TruthEvent> compare(const std::vector<WideEvent>& a, const std::vector<WideEvent>& b) {
  if (a.size() != b.size())
    throw RunFailed("one computation finds " + std::to_string(a.size()) + " events and the other " +
                    std::to_string(b.size()));
  std::vector<TruthEvent> events;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].event != b[i].event) throw RunFailed("two computations find events in different order");
    const Wide own = 10 * abs(a[i].t - b[i].t), least = Wide("1e-45") * abs(a[i].t);
    events.push_back({a[i].event, b[i].phase, truth_value(a[i].t, own > least ? own : least)});
  }
  return events;
}

std::string certain_digits(const TruthValue& value, int most) {
  const Wide centre(value.decimal), bound(value.bound);
  if (bound == 0 && centre == 0) return "0";
  const Wide inner = abs(centre) - bound, outer = abs(centre) + bound;
  if (inner <= 0) return "0";
  const Scientific low = scientific(inner, 49), high = scientific(outer, 49);
  std::string digits;
  if (low.exponent == high.exponent)
    for (std::size_t i = 0; i < std::size_t(most) && low.digits[i] == high.digits[i]; ++i)
      digits += low.digits[i];
  if (digits.empty()) return "0";
  const int e = low.exponent;
  std::string text = centre < 0 ? "-" : "";
  if (e < -5 || e >= std::max(int(digits.size()), 1)) {
    text += digits.substr(0, 1) + (digits.size() > 1 ? "." + digits.substr(1) : "");
    return text + "e" + std::to_string(e);
  }
  if (e < 0) return text + "0." + std::string(std::size_t(-e - 1), '0') + digits;
  const std::size_t whole = std::size_t(e) + 1;
  return text + digits.substr(0, whole) + (digits.size() > whole ? "." + digits.substr(whole) : "");
}

}  // namespace odemark
