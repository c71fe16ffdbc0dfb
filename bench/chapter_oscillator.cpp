// Claim 5: the improved Euler method against Runge-Kutta on the undamped spring, in periods and per cost.
#include <algorithm>
#include <limits>

#include "bench/chapter_lab.hpp"

namespace odemark::chapter {

namespace {

// w = 1: one step of dt turns by z = dt, a period is 2 pi
AnyProblem unit_spring() { return problem_called("oscillator"); }

double size_of(const double* y) { return std::hypot(y[0], y[1]); }

/// Steps until the amplitude is `factor` times the start. Between the last two steps it is interpolated on
/// the logarithm, which is exact: every step multiplies by the same number.
Halving halving(const AnyMethod& method, const AnyProblem& spring, double z, double factor) {
  constexpr long budget = 2'000'000;
  double before = 1, last = 1;
  long n = 0;
  step<double>(method, spring, z, budget, [&](double, const double* y) {
    before = last, last = size_of(y), ++n;
    return factor > 1 ? last < factor : last > factor;
  });
  Halving out;
  const double per_period = z / (2 * pi);
  const bool reached = factor > 1 ? last >= factor : last <= factor;
  out.watched = double(n) * per_period;
  out.extrapolated = !reached;
  out.periods = reached ? (double(n - 1) + std::log(factor / before) / std::log(last / before)) * per_period
                        : std::log(factor) / std::log(last) * out.watched;
  const double per_step =
      double(std::log(std::norm(stability_function(method, {0, static_cast<long double>(z)})))) / 2;
  out.theory = std::log(factor) / per_step * per_period;
  return out;
}

struct PerPeriod {
  double amplitude, phase;
};

PerPeriod measured_per_period(const AnyMethod& method, const AnyProblem& spring, double z) {
  constexpr double periods = 20;
  const long count = std::lround(periods * 2 * pi / z);
  double phase = 0, angle = 0, size = 1;
  step<double>(method, spring, z, count, [&](double, const double* y) {
    const double now = spring.oscillation_call(spring.value.get(), y).phase;
    phase += std::remainder(now - angle, 2 * pi);
    angle = now, size = size_of(y);
    return true;
  });
  const double turns = double(count) * z / (2 * pi);
  return {std::pow(size, 1 / turns), (phase - double(count) * z) / turns};
}

PerPeriod theory_per_period(const AnyMethod& method, double z) {
  const auto r = stability_function(method, {0, static_cast<long double>(z)});
  return {std::pow(double(std::abs(r)), 2 * pi / z),
          2 * pi / z * double(std::arg(r) - static_cast<long double>(z))};
}

/// Periods until the displacements of two methods are `apart`, as a part of the starting amplitude.
std::optional<double> periods_until(const std::vector<double>& a, const std::vector<double>& b, double apart,
                                    double z) {
  for (std::size_t n = 0; n < a.size(); ++n)
    if (!(std::abs(a[n] - b[n]) <= apart)) return double(n) * z / (2 * pi);
  return std::nullopt;
}

struct AtEnd {
  double error, amplitude;
};

/// After `periods` in `count` steps.
AtEnd at_end(std::string_view method, const AnyProblem& spring, double periods, long count) {
  const double t_end = 2 * pi * periods;
  const auto y = step<double>(method_called(method), spring, t_end / double(count), count).y;
  const auto exact = exact_flow<double>(spring, t_end, initial_state<double>(spring));
  return {std::hypot(y[0] - exact[0], y[1] - exact[1]), size_of(y.data())};
}

}  // namespace

std::vector<DoublingLine> doublings() {
  const AnyProblem spring = unit_spring();
  const AnyMethod &heun = method_called("heun"), &rk4 = method_called("rk4");
  std::vector<DoublingLine> lines;
  for (const double z : {0.05, 0.1, 0.2, 0.3, 0.5, pi / 6, 1.0, 2.0}) {
    DoublingLine line;
    line.z = z, line.steps_per_period = 2 * pi / z;
    line.heun_doubles = halving(heun, spring, z, 2);
    line.heun_seconds_at_60 = line.heun_doubles.periods * line.steps_per_period / 60;
    line.rk4_halves = halving(rk4, spring, z, 0.5);
    const PerPeriod h = measured_per_period(heun, spring, z), h0 = theory_per_period(heun, z);
    const PerPeriod r = measured_per_period(rk4, spring, z), r0 = theory_per_period(rk4, z);
    line.heun_amplitude = h.amplitude, line.heun_amplitude_theory = h0.amplitude;
    line.heun_phase = h.phase, line.heun_phase_theory = h0.phase;
    line.rk4_amplitude = r.amplitude, line.rk4_amplitude_theory = r0.amplitude;
    line.rk4_phase = r.phase, line.rk4_phase_theory = r0.phase;
    const long count = std::lround(100 * 2 * pi / z);
    const auto a = stepped_curve("heun", spring, 0, z, count).value,
               b = stepped_curve("rk4", spring, 0, z, count).value;
    line.differ_1_percent = periods_until(a, b, 0.01, z);
    line.differ_10_percent = periods_until(a, b, 0.1, z);
    lines.push_back(line);
  }
  return lines;
}

std::vector<EqualCostLine> equal_cost() {
  const AnyProblem spring = unit_spring();
  // not a whole number of periods: there the listing's error in the amplitude would hide
  constexpr double periods = 10.25;
  std::vector<EqualCostLine> lines;
  for (const int evaluations : {16, 32, 64, 128, 256, 1024}) {
    EqualCostLine line;
    line.evaluations_per_period = evaluations, line.periods = periods;
    const long total = std::lround(evaluations * periods);
    line.listing_z = 2 * pi / evaluations, line.heun_z = 2 * line.listing_z, line.rk4_z = 4 * line.listing_z;
    const AtEnd h = at_end("heun", spring, periods, total / 2), r = at_end("rk4", spring, periods, total / 4),
                l = at_end("chapter_euler", spring, periods, total);
    line.heun_error = h.error, line.heun_amplitude = h.amplitude;
    line.rk4_error = r.error, line.rk4_amplitude = r.amplitude;
    line.listing_error = l.error, line.listing_amplitude = l.amplitude;
    lines.push_back(line);
  }
  return lines;
}

ListingOnSpring listing_on_spring() {
  const AnyProblem spring = unit_spring();
  ListingOnSpring out{0.1, 100};
  const auto largest = [&](const char* method) {
    double size = 1;
    step<double>(method_called(method), spring, out.dt, std::lround(2 * pi * out.periods / out.dt),
                 [&](double, const double* y) {
                   size = std::max(size, size_of(y));
                   return true;
                 });
    return size;
  };
  out.listing_amplitude = largest("chapter_euler"), out.euler_amplitude = largest("explicit_euler");
  return out;
}

std::vector<MemoryLine> memory() {
  constexpr double rigid_body_bytes = 13 * sizeof(float);  // position, orientation, velocity, spin
  const AnyProblem spring = unit_spring();
  std::vector<MemoryLine> lines;
  for (const char* id : {"explicit_euler", "heun", "rk4"}) {
    const int slopes =
        evaluations_per_step(method_called(id), spring);  // each is kept until the end of the step
    lines.push_back({id, slopes, slopes * rigid_body_bytes});
  }
  return lines;
}

}  // namespace odemark::chapter
