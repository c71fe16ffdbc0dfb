// The chapter: every printed digit of its table, its figures, and the measured facts behind the seven
// verdicts.
#include "bench/chapter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

#include "reports/chapter_page.hpp"

namespace odemark::chapter_test {
namespace {

const ChapterData& data() {
  static const ChapterData all = chapter_data();
  return all;
}

template <class Lines, class Test>
const auto& find(const Lines& lines, Test&& test) {
  const auto found = std::find_if(lines.begin(), lines.end(), test);
  if (found == lines.end()) throw std::out_of_range("not measured");
  return *found;
}

const ChapterTable& table_in(const std::string& scalar) {
  return find(data().tables, [&](const ChapterTable& table) { return table.scalar == scalar; });
}

const LimitLine& limit_of(const std::string& problem, const std::string& method) {
  return find(data().limits,
              [&](const LimitLine& line) { return line.problem == problem && line.method == method; });
}

const ErrorCurve& errors_of(const std::string& problem, const std::string& method,
                            const std::string& scalar) {
  return find(data().errors, [&](const ErrorCurve& curve) {
    return curve.problem == problem && curve.method == method && curve.scalar == scalar;
  });
}

std::vector<AdaptiveRun> runs_of(const std::string& family, const std::string& method) {
  std::vector<AdaptiveRun> found;
  std::copy_if(data().adaptive.begin(), data().adaptive.end(), std::back_inserter(found),
               [&](const AdaptiveRun& run) {
                 return run.problem.substr(0, run.problem.find('{')) == family && run.method == method;
               });
  EXPECT_FALSE(found.empty()) << family << ' ' << method;
  return found;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

TEST(ChapterTable71, EveryPrintedDigitAndMeanInDouble) {
  struct Line {
    double t;
    const char *exact, *euler, *error;
  };
  const Line book[] = {{6.5, "9.559084", "9.733158", "1.82"},
                       {7.0, "10.06829", "10.2465", "1.77"},
                       {7.5, "10.55267", "10.73418", "1.72"},
                       {8.0, "11.01342", "11.19747", "1.67"},
                       {8.5, "11.4517", "11.63759", "1.62"}};
  const auto& lines = table_in("double").lines;
  ASSERT_EQ(lines.size(), std::size(book));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].t, book[i].t);
    EXPECT_EQ(lines[i].exact.ours, book[i].exact);
    EXPECT_EQ(lines[i].euler.ours, book[i].euler);
    EXPECT_EQ(lines[i].error.ours, book[i].error);
    EXPECT_TRUE(lines[i].exact.agrees && lines[i].euler.agrees && lines[i].error.agrees);
  }
  const auto& means = table_in("double").means;
  ASSERT_EQ(means.size(), 3u);
  EXPECT_EQ(means[0].percent.ours, "1.72");
  EXPECT_EQ(means[1].percent.ours, "0.03");
  EXPECT_EQ(means[2].percent.ours, "3.6e-6");
  for (const MeanError& mean : means) EXPECT_TRUE(mean.percent.agrees);
}

TEST(ChapterTable71, FloatIsWithinItsRoundingAndCannotShowRungeKutta) {
  const ChapterTable &single = table_in("float"), &wide = table_in("double");
  for (std::size_t i = 0; i < single.lines.size(); ++i) {
    EXPECT_NEAR(single.lines[i].exact.value, wide.lines[i].exact.value, 4e-6);
    EXPECT_NEAR(single.lines[i].euler.value, wide.lines[i].euler.value, 4e-6);
    EXPECT_TRUE(single.lines[i].error.agrees);
  }
  EXPECT_FALSE(single.means[2].percent.agrees);
}

TEST(ChapterFigures, EightWithTheirCurves) {
  ASSERT_EQ(data().figures.size(), 8u);
  const auto& errors = data().local_errors;  // 7-1
  EXPECT_NEAR(errors.at(errors.size() - 2).error / errors.back().error, 4, 0.1);
  for (std::size_t i = 0; i < 8; ++i) {
    const ChapterFigure& figure = data().figures[i];
    EXPECT_EQ(figure.number, "7-" + std::to_string(i + 1));
    EXPECT_GE(figure.curves.size(), 2u);
    EXPECT_EQ(figure.curves[0].method, "exact");
    for (const Trajectory& curve : figure.curves) EXPECT_GE(curve.t.size(), 5u) << figure.number;
  }
  const auto last_gap = [](const ChapterFigure& f, std::size_t curve) {
    return std::abs(f.curves[curve].value.back() - f.curves[0].value.back());
  };
  const auto largest = [](const Trajectory& curve) {
    return std::abs(*std::max_element(curve.value.begin(), curve.value.end(),
                                      [](double a, double b) { return std::abs(a) < std::abs(b); }));
  };
  EXPECT_LT(last_gap(data().figures[3], 1), last_gap(data().figures[1], 1) / 10);  // 7-4: it converges
  EXPECT_GT(largest(data().figures[4].curves[1]), 6);                              // 7-5: Euler grows,
  EXPECT_LT(largest(data().figures[4].curves[2]), 1.01);                           // the listing does not
  EXPECT_LT(last_gap(data().figures[6], 2), 0.004);                                // 7-7
  EXPECT_LT(last_gap(data().figures[6], 3), 1e-6);
  for (const std::size_t curve : {1u, 2u}) EXPECT_LT(largest(data().figures[7].curves[curve]), 1.01);  // 7-8
}

TEST(ChapterListing, IsSemiImplicitEulerToTheBit) {
  ASSERT_EQ(data().listing.size(), 4u);
  for (const ListingHash& line : data().listing) {
    EXPECT_EQ(line.listing, line.semi_implicit);
    EXPECT_NE(line.listing, line.explicit_euler);
    if (line.problem != "drag_ship") continue;
    EXPECT_EQ(line.speed_gap, 0);
    EXPECT_NEAR(line.position_gap / line.dt_times_change, 1, line.scalar == "double" ? 1e-12 : 1e-5);
  }
  EXPECT_LT(data().listing_on_spring.listing_amplitude, 1.06);
  EXPECT_GT(data().listing_on_spring.euler_amplitude, 1e13);
}

TEST(ChapterAnswers, AreWhatTheMeasurementsSay) {
  using enum Answer;
  const std::array<Answer, 7> expected{holds,
                                       holds_with_limits,
                                       holds,
                                       holds_with_limits,
                                       holds_with_limits,
                                       holds_with_limits,
                                       holds_with_limits};
  EXPECT_EQ(data().answers, expected);
}

TEST(ChapterClaim1, FacesAreClassified) {
  for (const FaceRun& run : data().faces) {
    if (run.problem == "drag_ship") {
      EXPECT_NEAR(run.growth_per_step,
                  std::max(std::abs(1 - run.rate_times_dt), std::exp(-run.rate_times_dt)), 2e-3);
      const Behaviour expected = run.rate_times_dt < 1    ? Behaviour::settles
                                 : run.rate_times_dt < 2  ? Behaviour::overshoots_and_settles
                                 : run.rate_times_dt == 2 ? Behaviour::oscillates_for_ever
                                                          : Behaviour::grows;
      EXPECT_EQ(run.behaviour, expected) << run.dt;
    } else if (run.problem == "oscillator") {
      EXPECT_EQ(run.behaviour, Behaviour::grows);
      EXPECT_NEAR(run.growth_per_step, std::hypot(1, run.rate_times_dt), 1e-9);
    } else {
      EXPECT_EQ(run.behaviour,
                run.rate_times_dt < 2 ? Behaviour::overshoots_and_settles : Behaviour::oscillates_for_ever);
    }
  }
}

TEST(ChapterClaim2, GrowthIsTheorysAtEveryStep) {
  for (const GrowthPoint& point : data().growth) {
    EXPECT_NEAR(point.measured, point.theory, 10 * point.resolution + 1e-9 * std::abs(point.theory))
        << point.method << ' ' << point.dt;
    EXPECT_EQ(point.doubles_in.has_value(), point.method != "rk4") << point.method << ' ' << point.dt;
  }
}

TEST(ChapterClaim2, ATinyStepStallsTheFloatShip) {
  const Stall& fine = data().stalls.back();
  EXPECT_TRUE(fine.stalled_from && !data().stalls.front().stalled_from);
  EXPECT_NEAR(20 - fine.v_float, fine.dv_of_stall, 0.01 * fine.dv_of_stall);
  EXPECT_NEAR(fine.v_double, fine.exact, 1e-6);
}

TEST(ChapterClaim3, FloatTurnsUpAndTheClockDrifts) {
  for (const std::string problem : {"drag_ship", "oscillator"})
    for (const std::string method : {"explicit_euler", "heun", "rk4"}) {
      const ErrorCurve& curve = errors_of(problem, method, "float");
      EXPECT_TRUE(curve.minimum_inside) << problem << ' ' << method;
      EXPECT_GT(curve.points.back().error, 2 * curve.best.error);
      EXPECT_LT(errors_of(problem, method, "double").best.error, curve.best.error);
    }
  EXPECT_TRUE(errors_of("drag_ship", "rk4", "double").minimum_inside);
  for (const ClockLine& line : data().clocks) {
    EXPECT_LE(std::abs(line.computed_error), 0.002);
    EXPECT_TRUE(line.dt != 1.0 / 64 || line.accumulated_error == 0);
    EXPECT_TRUE(line.dt != 1.0 / 60 || line.duration < 20000 || line.accumulated_error > 600);
  }
}

TEST(ChapterClaim4, LimitsPerStepAndPerEvaluation) {
  for (const LimitLine& line : data().limits) {
    ASSERT_EQ(line.dt.has_value(), line.theory.has_value()) << line.problem << ' ' << line.method;
    EXPECT_NEAR(line.dt.value_or(1) / line.theory.value_or(1), 1, 1e-6) << line.problem << ' ' << line.method;
  }
  EXPECT_NEAR(limit_of("drag_ship", "explicit_euler").number, 2, 1e-6);
  EXPECT_NEAR(limit_of("drag_ship", "heun").number, 2, 1e-6);
  EXPECT_NEAR(limit_of("drag_ship", "rk4").number, 2.785294, 1e-5);
  EXPECT_NEAR(limit_of("drag_ship", "rk4").number_per_evaluation, 0.696323, 1e-5);
  EXPECT_FALSE(limit_of("oscillator", "explicit_euler").dt);
  EXPECT_FALSE(limit_of("oscillator", "heun").dt);
  EXPECT_NEAR(limit_of("oscillator", "rk4").number, std::sqrt(8), 1e-6);
  EXPECT_NEAR(limit_of("oscillator", "chapter_euler").number, 2, 1e-6);
  EXPECT_NEAR(limit_of("damped_spring{zeta=0.01}", "heun").number, 0.444, 1e-3);
}

TEST(ChapterClaim5, RungeKuttaWinsAtEqualCostAndDoublingTimesAreTheorys) {
  for (const EqualCostLine& line : data().equal_cost) EXPECT_LT(line.rk4_error, line.heun_error);
  struct Line {
    double z, doubles, halves;
  };
  // stability-definitions, section 5
  for (const Line& line :
       {Line{0.05, 7060, 5e7}, Line{0.1, 882.6, 1.6e6}, Line{0.2, 110.3, 49892}, Line{0.3, 32.7, 6612},
        Line{0.5, 7.12, 525}, Line{0.5236, 6.21, 418}, Line{1.0, 0.989, 18.0}, Line{2.0, 0.274, 0.75}}) {
    const DoublingLine& found =
        find(data().doublings, [&](const DoublingLine& d) { return std::abs(d.z / line.z - 1) < 1e-4; });
    EXPECT_NEAR(found.heun_doubles.periods / found.heun_doubles.theory, 1, 1e-3) << line.z;
    EXPECT_NEAR(found.rk4_halves.periods / found.rk4_halves.theory, 1, 1e-3) << line.z;
    EXPECT_NEAR(found.heun_doubles.periods / line.doubles, 1, 2e-3) << line.z;
    EXPECT_NEAR(found.rk4_halves.periods / line.halves, 1, 0.02) << line.z;
    EXPECT_FALSE(found.heun_doubles.extrapolated);
    EXPECT_NEAR(found.heun_phase, found.heun_phase_theory, 1e-6 + 1e-6 * found.heun_phase_theory);
    EXPECT_NEAR(found.rk4_phase, found.rk4_phase_theory, 1e-9);
  }
}

TEST(ChapterClaim6, BestPerStepAndTheCrossovers) {
  for (const SameStep& line : data().same_step) {
    ASSERT_EQ(line.errors.size(), 3u);
    EXPECT_GT(line.errors[0].second, line.errors[1].second);
    EXPECT_GT(line.errors[1].second, line.errors[2].second);
  }
  for (const Crossover& line : data().crossovers) {
    EXPECT_NE(line.error.has_value(), !line.winner.empty());
    EXPECT_TRUE(!line.error || *line.error > 0.05);
    EXPECT_TRUE(line.cheap != "chapter_euler" || line.error);
  }
}

TEST(ChapterClaim7, TheListingExceedsItsToleranceAndTheCorrectControllerDoesNot) {
  for (const AdaptiveRun& run : data().adaptive) EXPECT_TRUE(run.reached_end);
  for (const AdaptiveRun& run : runs_of("drag_ship", "chapter_adaptive_euler")) {
    EXPECT_NEAR(run.worst_local, 2, 0.05);     // it keeps V1
    EXPECT_NEAR(run.worst_estimate, 1, 1e-6);  // on a linear force one retry is exact
    EXPECT_LE(run.largest_dt, run.nominal * (1 + 1e-12));
    EXPECT_GT(run.clock_lag, 0.1);
  }
  for (const AdaptiveRun& run : runs_of("drag_ship", "step_doubling_euler")) {
    EXPECT_LE(run.worst_local, 1);
    EXPECT_GT(run.largest_dt, run.nominal);
    EXPECT_GT(run.global_error, 1);
  }
  for (const AdaptiveRun& run : runs_of("oscillator", "chapter_adaptive_euler")) {
    EXPECT_EQ(run.zero_estimates, 1);  // blind to a force of the position
    EXPECT_GT(run.worst_local, 4);
  }
  for (const AdaptiveRun& run : runs_of("oscillator", "step_doubling_euler")) {
    EXPECT_LE(run.worst_local, 1);
    EXPECT_GT(*run.energy_ratio, 5);  // error control is not stability
  }
  const auto switched = runs_of("drag_ship_quadratic", "chapter_adaptive_euler");
  EXPECT_GT(switched.at(0).worst_estimate, 5);  // the retaken step is not checked
  EXPECT_GT(switched.at(1).worst_local, 50);    // a jump in the second half is not seen
}

TEST(ChapterClaim7, AnEstimateOfZeroKeepsTheStep) {
  const ZeroEstimate& zero = data().zero_estimate;
  EXPECT_TRUE(std::isinf(zero.wished) && zero.step_kept);
  EXPECT_TRUE(std::isnan(zero.wished_both) && zero.step_kept_both);
  EXPECT_TRUE(zero.at_limit.reached_end);
  EXPECT_EQ(zero.at_limit.zero_estimates, 1);
}

TEST(ChapterPage, HasEightFiguresAndSevenVerdictsInTheSameBytes) {
  const std::string html = to_html(chapter_page(data()));
  for (int n = 1; n <= 8; ++n) {
    EXPECT_EQ(count(html, "id=\"figure-7-" + std::to_string(n) + "\""), 1u) << n;
    EXPECT_EQ(count(html, "id=\"claim-" + std::to_string(n) + "\""), n < 8 ? 1u : 0u) << n;
  }
  EXPECT_EQ(count(html, "Measured: true"), 7u);
  EXPECT_NE(html.find("18 of the 18 printed numbers"), html.npos);
  EXPECT_EQ(html.find(">nan"), html.npos);
  EXPECT_EQ(html.find("w dt"), html.npos) << "ω dt";
  EXPECT_EQ(html, to_html(chapter_page(data())));
}

}  // namespace
}  // namespace odemark::chapter_test
