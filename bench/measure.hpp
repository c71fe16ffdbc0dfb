// Pieces of a measurement: hashes, errors against a truth, drifts, phase along a run.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "bench/data/row.hpp"
#include "reference/any_problem.hpp"
#include "reference/truth.hpp"

namespace odemark {

/// FNV-1a over the value bytes; padding of long double is left out. Every NaN is the same: which of two NaNs
/// a sum hands on, and so its sign, is the compiler's choice.
template <class T>
std::string hash_bits(const std::vector<T>& y) {
  constexpr std::size_t used =
      sizeof(T) == 16 ? 10 : sizeof(T);  // x87 extended: 10 bytes of value, 6 of padding
  std::uint64_t hash = 14695981039346656037u;
  for (const T& x : y) {
    const T value = std::isnan(x) ? std::numeric_limits<T>::quiet_NaN() : x;
    const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
    for (std::size_t i = 0; i < used; ++i) hash = (hash ^ bytes[i]) * 1099511628211u;
  }
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; hash >>= 4) text[i] = "0123456789abcdef"[hash & 15];
  return text;
}

/// Fills the distances at the end; `y` has the problem's size. Of a large problem only some components are
/// known, and compared.
RowErrors errors_at_end(const AnyProblem& problem, const Truth& truth, const std::vector<long double>& y);

/// Adds the distances over the grid: rows of `samples` belong to the points of `truth`. Absent where a sample
/// is NaN.
void add_trajectory_errors(RowErrors& errors, const AnyProblem& problem, const Truth& truth,
                           const std::vector<long double>& samples);

/// Watches a run step by step: invariants, the unwrapped phase of an oscillation, and the clock.
class Watch {
 public:
  Watch(const AnyProblem& problem, double time_limit_seconds);

  /// False when the time is up. `y` is the state after an accepted step.
  bool operator()(const std::vector<long double>& y);
  void fill(Row& row) const;
  std::optional<Oscillation> oscillation() const;

 private:
  const AnyProblem& problem_;
  std::vector<long double> initial_, now_;
  std::vector<double> worst_;
  std::optional<Oscillation> oscillation_;
  std::chrono::steady_clock::time_point deadline_;
  long calls_ = 0;
};

}  // namespace odemark
