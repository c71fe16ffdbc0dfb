// What the chapter page shows: the book's table, figures and seven claims, each beside what our methods did.
// Plain data, all of it computed by bench/chapter*.cpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/data/trajectory.hpp"

namespace odemark {

enum class Answer { holds, holds_with_limits, does_not_hold };

/// One printed number of the book and ours, printed by the same rule.
struct PrintedNumber {
  std::string book{}, ours{};
  double value = 0;  // ours, unrounded
  bool agrees = false;
};

struct TableLine {
  double t = 0;  // s
  PrintedNumber exact{}, euler{}, error{};
};

struct MeanError {
  std::string method{};
  PrintedNumber percent{};
};

struct ChapterTable {
  std::string scalar{};
  std::vector<TableLine> lines{};
  std::vector<MeanError> means{};
};

struct LocalError {
  double dt = 0, error = 0;  // s, m/s: one Euler step from rest
};

struct ChapterFigure {
  std::string number{};  // "7-1"
  std::vector<Trajectory> curves{};
  double from = 0, to = 0;  // s: the part that is shown
};

/// Whether the chapter's first listing is the method of another name.
struct ListingHash {
  std::string problem{}, scalar{}, listing{}, semi_implicit{}, explicit_euler{};  // hashes of the final state
  double speed_gap = 0;        // |v of the listing - v of explicit Euler| at the end, m/s
  double position_gap = 0;     // s of the listing - s of explicit Euler at the end, m
  double dt_times_change = 0;  // dt (v_end - v_0), m: what the gap is for a force without position
};

// claim 1

enum class Behaviour { settles, overshoots_and_settles, oscillates_for_ever, grows };

struct FaceRun {
  std::string problem{}, method{};
  double dt = 0, rate_times_dt = 0;  // lambda dt, or w dt
  long steps = 0, sign_changes = 0;  // of the deviation from the exact solution
  double growth_per_step = 0;        // of the deviation, or of the amplitude, over the second half of the run
  double last_deviation = 0;         // from the exact solution, in units of the component
  Behaviour behaviour = Behaviour::settles;
  Trajectory curve{};
};

// claim 2

struct GrowthPoint {
  std::string method{};
  double dt = 0;                       // s
  double measured = 0, theory = 0;     // d ln(amplitude) / dt, 1/s
  double resolution = 0;               // of `measured`
  std::optional<double> doubles_in{};  // s, where it grows beyond the resolution
};

/// A ship in single precision: below some dt the increment of the speed is lost and it stops accelerating.
struct Stall {
  double dt = 0;
  long steps = 0;
  double v_float = 0, v_double = 0, exact = 0;  // m/s at the end
  std::optional<double> stalled_from{};         // s: no step after it changed the speed
  double dv_of_stall =
      0;  // m/s: distance from the limiting speed at which half an ulp swallows the increment
};

// claims 3 and 6

struct ErrorPoint {
  long steps = 0, evaluations = 0;
  double dt = 0, error = 0;
};

struct ErrorCurve {
  std::string problem{}, method{}, scalar{};
  std::vector<ErrorPoint> points{};  // from the largest dt to the smallest
  ErrorPoint best{};                 // the smallest error
  bool minimum_inside = false;       // the error rises again below best.dt, by a factor of two or more
};

/// One scene clock in single precision after `duration` of steps of dt.
struct ClockLine {
  double dt = 0, duration = 0;                       // s, as asked
  double accumulated_error = 0, computed_error = 0;  // s: t += dt against t = n dt, both float
  double stops_at = 0;                               // s: float t from which t + dt == t
};

struct Crossover {
  std::string problem{}, cheap{}, dear{};  // below `error` the dear method costs less
  std::optional<double> error{};           // absent: one of them costs less over the whole common range
  std::optional<double> evaluations{};
  std::string winner{};  // where there is no crossover
};

struct CostLine {
  std::string problem{};
  double error = 0;
  std::vector<std::pair<std::string, std::optional<double>>> evaluations{};  // per method, interpolated
};

struct SameStep {
  std::string problem{};
  double dt = 0;
  std::vector<std::pair<std::string, double>> errors{};
};

// claim 4

struct LimitLine {
  std::string problem{}, method{};
  int evaluations = 0;                           // per step, counted
  std::optional<double> dt{};                    // s; absent: unstable at every dt that was tried
  std::optional<double> theory{};                // s, from the coefficients
  double rate = 0;                               // 1/s
  double number = 0, number_per_evaluation = 0;  // rate * dt, and that per evaluation; 0 where dt is absent
  double tried_down_to = 0;                      // s
};

// claim 5

/// An amplitude that grows or shrinks: periods until it has changed by a factor of two.
struct Halving {
  double periods = 0, theory = 0;
  bool extrapolated = false;  // from the change over `watched` periods
  double watched = 0;
};

struct DoublingLine {
  double z = 0, steps_per_period = 0;  // z = w dt
  double heun_seconds_at_60 = 0;       // s until the amplitude doubles if the steps are 1/60 s
  Halving heun_doubles{}, rk4_halves{};
  double heun_amplitude = 0, heun_amplitude_theory = 0;  // factor per period
  double rk4_amplitude = 0, rk4_amplitude_theory = 0;
  double heun_phase = 0, heun_phase_theory = 0;  // rad per period
  double rk4_phase = 0, rk4_phase_theory = 0;
  std::optional<double> differ_1_percent{},
      differ_10_percent{};  // periods until the two displacements are apart
};

struct EqualCostLine {
  double evaluations_per_period = 0, periods = 0, heun_z = 0, rk4_z = 0, listing_z = 0;
  double heun_error = 0, rk4_error = 0, listing_error = 0;  // of the state, as a part of the amplitude
  double heun_amplitude = 0, rk4_amplitude = 0, listing_amplitude = 0;
};

struct MemoryLine {
  std::string method{};
  int slopes = 0;
  double bytes_per_body = 0;  // a rigid body of 13 floats
};

// claim 7

struct AdaptiveRun {
  std::string problem{}, method{};
  double tolerance = 0;  // of the speed, in its unit
  double nominal = 0, t_end = 0;
  bool reached_end = false, has_switch = false;  // has_switch: the force jumps at an instant
  long steps = 0, rejected = 0, evaluations = 0;
  double smallest_dt = 0, largest_dt = 0;
  double worst_estimate = 0;  // largest |V1 - V2| of a step as taken, over the tolerance
  double worst_local = 0;     // largest local error of the speed, over the tolerance
  double share_over = 0;      // of the steps whose local error is above the tolerance
  double worst_position = 0;  // largest local error of the position, m: nobody controls it in the listing
  double global_error = 0;    // of the speed: largest over the run, over the tolerance
  double clock_lag = 0;       // s: nominal clock - simulated time when the nominal clock reads t_end
  double zero_estimates = 0;  // share of the steps in which |V1 - V2| is 0 but for rounding
  std::optional<double> energy_ratio{};  // end over start
  std::vector<double> t{}, local{};      // local error over the tolerance, per step
};

/// e_to / 0 as the printed listing divides.
struct ZeroEstimate {
  double wished = 0;  // dt * sqrt(e_to / 0)
  bool step_kept = false;
  double wished_both = 0;  // dt * sqrt(0 / 0)
  bool step_kept_both = false;
  AdaptiveRun at_limit{};  // started at the limiting speed: every e_t is 0
};

/// The chapter's first listing is semi-implicit: what that does on the undamped spring, where Euler grows.
struct ListingOnSpring {
  double dt = 0, periods = 0, listing_amplitude = 0, euler_amplitude = 0;  // largest over the run, over start
};

struct ChapterData {
  std::array<Answer, 7> answers{};  // to the claims, in the book's order

  std::vector<ChapterTable> tables{};  // double, float
  std::vector<ChapterFigure> figures{};
  std::vector<LocalError> local_errors{};
  double oscillator_k = 0, oscillator_m = 0, oscillator_dt = 0;  // N/m, kg, s of figures 7-5 and 7-8
  std::vector<ListingHash> listing{};
  ListingOnSpring listing_on_spring{};

  std::vector<FaceRun> faces{};
  std::vector<GrowthPoint> growth{};
  std::vector<Stall> stalls{};
  std::vector<ErrorCurve> errors{};
  std::vector<ClockLine> clocks{};
  std::vector<LimitLine> limits{};
  std::vector<DoublingLine> doublings{};
  std::vector<EqualCostLine> equal_cost{};
  std::vector<MemoryLine> memory{};
  std::vector<SameStep> same_step{};
  std::vector<Crossover> crossovers{};
  std::vector<CostLine> costs{};
  std::vector<AdaptiveRun> adaptive{};
  ZeroEstimate zero_estimate{};
};

}  // namespace odemark
