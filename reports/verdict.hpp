// The verdicts that the report prints and the gate acts on: one function decides for both. NaN is never good.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "bench/data/stability.hpp"

namespace odemark {

enum class OrderVerdict { holds, fails, exceeds, inconclusive };

constexpr std::string_view to_string(OrderVerdict verdict) {
  switch (verdict) {
    case OrderVerdict::holds: return "holds";
    case OrderVerdict::fails: return "fails";
    case OrderVerdict::exceeds: return "exceeds";
    case OrderVerdict::inconclusive: return "inconclusive";
  }
  return "unknown";
}

inline OrderVerdict judge_order(double slope, double claimed, double slack) {
  if (!std::isfinite(slope)) return OrderVerdict::inconclusive;
  if (!(slope >= claimed - slack)) return OrderVerdict::fails;
  return slope > claimed + slack ? OrderVerdict::exceeds : OrderVerdict::holds;
}

/// What became of a quantity of which less is better, or of a run.
enum class Change { same, better, worse };

/// Growth by more than `factor` and by more than `floor` is worse; below the floor differences are round-off.
inline Change judge_change(double now, double before, double factor, double floor) {
  if (!std::isfinite(now)) return std::isfinite(before) ? Change::worse : Change::same;
  if (!std::isfinite(before)) return Change::better;
  if (std::abs(now - before) <= floor) return Change::same;
  if (now > before * factor) return Change::worse;
  return now * factor < before ? Change::better : Change::same;
}

inline Change judge_status(std::string_view now, std::string_view before) {
  const bool now_good = now == "reached_end", before_good = before == "reached_end";
  if (now_good == before_good) return Change::same;
  return now_good ? Change::better : Change::worse;
}

/// Times differ only if the medians do by `factor` and by more than three times their deviations together.
inline Change judge_time(double now, double before, double now_mad, double before_mad, double factor) {
  if (!(now > 0) || !(before > 0) || !std::isfinite(now / before)) return Change::same;
  if (!(std::abs(now - before) > 3 * (now_mad + before_mad))) return Change::same;
  if (now > before * factor) return Change::worse;
  return now * factor < before ? Change::better : Change::same;
}

enum class StabilityMatch { agrees, differs, nothing_to_compare };

/// A measured stability limit against theory, strict or through the tolerance of the measurement; a limit may
/// differ by a part of it and the resolution.
inline StabilityMatch judge_stability(const StabilityRow& row, double relative) {
  const auto agrees = [&](const std::string& verdict, const std::optional<double>& limit) {
    if (verdict.empty() || row.verdict != verdict) return false;
    if (verdict != "limit") return true;
    return row.measured && limit && std::abs(*row.measured - *limit) <= relative * *limit + row.resolution;
  };
  if (!row.failure.empty()) return StabilityMatch::differs;
  if (row.theory_verdict.empty() || row.verdict == "blank") return StabilityMatch::nothing_to_compare;
  return agrees(row.theory_verdict, row.theory) || agrees(row.theory_as_seen_verdict, row.theory_as_seen)
             ? StabilityMatch::agrees
             : StabilityMatch::differs;
}

}  // namespace odemark
