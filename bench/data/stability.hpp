// The largest stable step of a method on a linear problem: measured, in theory, and their difference. Plain
// data.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace odemark {

struct StabilityRow {
  std::string problem, family, settings, method, kind, provider;
  std::string scalar = "double";
  /// "limit": stable up to `measured`; "unstable": at every dt that was tried, down to the resolution;
  /// "unlimited": stable as far as was looked, `scanned_to`; "blank": see `reason`.
  std::string verdict, reason;
  /// The same words from the coefficients alone; "" where theory says nothing, for `theory_reason`.
  std::string theory_verdict, theory_reason;
  /// The same through the tolerance of the measurement, which growth below 1e-12 a step passes as stable
  /// (float: 3e-6). Filled only where the measurement differs from the strict theory; then it has to agree
  /// with this.
  std::string theory_as_seen_verdict;
  std::optional<double> theory_as_seen;  // s
  std::vector<std::pair<double, double>> theory_as_seen_bands;
  /// What must never happen: a stage of a linear problem that could not be solved, a NaN. "" when all is
  /// well.
  std::string failure;
  std::optional<double> measured, theory;  // dt, s; 0 where unstable, absent where unlimited
  double resolution = 0;                   // of `measured`, s
  std::optional<double> difference;        // measured - theory, s
  double scanned_to = 0;                   // s
  double fastest_rate = 0;  // largest |lambda| of the problem, 1/s; dt * fastest_rate is the usual z
  /// Stable intervals of dt beyond the first instability. A band cut by the end of the scan ends at
  /// `scanned_to`; one in theory that never ends has no end there: it is written as ending at infinity.
  std::vector<std::pair<double, double>> later_bands, theory_later_bands;
  std::vector<double> touches;              // dt where theory touches the boundary from within, s
  double reference_dt = 0;                  // the problem's suggested dt ...
  std::optional<double> growth_per_second;  // ... and ln(amplitude) per second measured there, where it grows
  std::optional<double> theory_growth_per_second;
  std::vector<std::complex<double>> eigenvalues;
};

}  // namespace odemark
