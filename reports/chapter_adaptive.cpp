// Claim 7: the adaptive listing beside the correct controller.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/chapter_words.hpp"
#include "reports/format.hpp"

namespace odemark::chapter_layout {

namespace {

constexpr std::string_view listing = "chapter_adaptive_euler", correct = "step_doubling_euler";

Table kept_table(const ChapterData& data) {
  Table table{
      "adaptive",
      "Is the limit kept? Errors over the tolerance on the speed",
      "Local: of one step, against the exact flow from where the step began. Above 1 is above the set limit.",
      {{"problem"},
       {"method"},
       {"tolerance", Align::right, "m/s"},
       {"worst local error", Align::right},
       {"steps over", Align::right},
       {"error of the run", Align::right},
       {"energy, end / start", Align::right}},
      {}};
  for (const AdaptiveRun& run : data.adaptive) {
    Cell local = digits(run.worst_local, 3);
    local.status = run.worst_local <= 1 ? Status::ok : Status::fail;
    table.rows.push_back({words(problem_name(run.problem)), words(method_name(run.method)),
                          digits(run.tolerance, 2), local,
                          number_cell(run.share_over, percent(run.share_over, 0)),
                          digits(run.global_error, 3), digits_or(run.energy_ratio, 3, "")});
  }
  return table;
}

Table work_table(const ChapterData& data) {
  Table table{"adaptive-work",
              "What it costs",
              "The listing starts every step from the nominal dt; the correct controller only the first.",
              {{"problem"},
               {"method"},
               {"tolerance", Align::right, "m/s"},
               {"steps", Align::right},
               {"rejected", Align::right},
               {"evaluations", Align::right},
               {"dt from", Align::right, "s"},
               {"to", Align::right, "s"}},
              {}};
  for (const AdaptiveRun& run : data.adaptive)
    table.rows.push_back({words(problem_name(run.problem)), words(method_name(run.method)),
                          digits(run.tolerance, 2), number_cell(double(run.steps), std::to_string(run.steps)),
                          number_cell(double(run.rejected), std::to_string(run.rejected)),
                          number_cell(double(run.evaluations), std::to_string(run.evaluations)),
                          digits(run.smallest_dt, 3), digits(run.largest_dt, 3)});
  return table;
}

Table listing_table(const ChapterData& data) {
  Table table{
      "adaptive-listing",
      "The listing's own estimate, its position and its clock",
      "e_t / tolerance: the worst |V1 − V2| of the steps as taken, after the one retry. e_t = 0: the share "
      "of "
      "steps, but for rounding. Position error: the worst of one step. Clock: how far the simulation is "
      "behind when a loop that adds the nominal dt reads the end.",
      {{"problem"},
       {"tolerance", Align::right, "m/s"},
       {"nominal dt", Align::right, "s"},
       {"end", Align::right, "s"},
       {"e_t / tolerance", Align::right},
       {"e_t = 0", Align::right},
       {"position error", Align::right, "m"},
       {"clock behind", Align::right, "s"}},
      {}};
  const auto add = [&](const AdaptiveRun& run) {
    table.rows.push_back(
        {words(problem_name(run.problem)), digits(run.tolerance, 2), digits(run.nominal, 3),
         digits(run.t_end, 4), digits(run.worst_estimate, 3),
         number_cell(run.zero_estimates, percent(run.zero_estimates, 0)), digits(run.worst_position, 3),
         number_cell(run.clock_lag, compact(std::abs(run.clock_lag) < 1e-9 ? 0 : run.clock_lag, 3))});
  };
  for (const AdaptiveRun& run : data.adaptive)
    if (run.method == listing) add(run);
  add(data.zero_estimate.at_limit);
  return table;
}

Chart local_chart(const ChapterData& data, std::string_view problem, double tolerance, std::string id,
                  std::string title, std::string caption) {
  Chart chart;
  chart.id = std::move(id), chart.title = std::move(title), chart.caption = std::move(caption);
  chart.x.label = "t [s]";
  chart.y = {"local error of the speed / tolerance", Scale::log10, AxisRange{0.01, 10}};
  chart.lines = {{Direction::horizontal, 1, "the set limit"}};
  for (const std::string_view method : {listing, correct}) {
    const AdaptiveRun& run = adaptive_of(data, problem, method, tolerance);
    Series series{std::string(method), method_name(method), "", {}, look(method)};
    series.style.line = Line::none;
    for (std::size_t i = 0; i < run.t.size(); ++i) series.points.push_back({run.t[i], run.local[i]});
    chart.series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace

std::string verdict_7(const ChapterData& data) {
  const AdaptiveRun &taken = adaptive_of(data, "drag_ship", listing, 1e-3),
                    &right = adaptive_of(data, "drag_ship", correct, 1e-3),
                    &spring = adaptive_of(data, "oscillator", correct, 1e-2);
  return fmt::format(
      "Not the listing: on the ship at a tolerance of {} m/s its steps err by up to {} times that, because "
      "it keeps V1 "
      "where |V1 − V2| is the error of V2. The correct controller keeps it ({} times) on a smooth force. "
      "Neither keeps "
      "the error of the run: {} and {} times the tolerance. And it is no cure for instability: within {} m/s "
      "per step "
      "the undamped 5 Hz spring's energy grew {} times in {} s.",
      compact(taken.tolerance, 2), significant(taken.worst_local, 3), significant(right.worst_local, 2),
      significant(taken.global_error, 2), significant(right.global_error, 2), compact(spring.tolerance, 2),
      significant(spring.energy_ratio.value_or(NAN), 2), compact(spring.t_end, 3));
}

std::vector<Block> claim_7(const ChapterData& data) {
  const AdaptiveRun &taken = adaptive_of(data, "drag_ship", listing, 1e-3),
                    &seen = adaptive_of(data, "drag_ship_quadratic{t_reverse=60.12}", listing, 1e-3),
                    &blind = adaptive_of(data, "drag_ship_quadratic{t_reverse=60.3}", listing, 1e-3),
                    &stepped_over = adaptive_of(data, "drag_ship_quadratic{t_reverse=60.12}", correct, 1e-3),
                    &blind_too = adaptive_of(data, "drag_ship_quadratic{t_reverse=60.3}", correct, 1e-3),
                    &still = adaptive_of(data, "oscillator", listing, 1e-2),
                    &spring = adaptive_of(data, "oscillator", correct, 1e-2);
  const ZeroEstimate& zero = data.zero_estimate;
  std::vector<Block> blocks;
  blocks.push_back(local_chart(
      data, "drag_ship", 1e-3, "local-ship", "The ship: local error of each step over the tolerance",
      "The listing sits at twice its limit for as long as the tolerance binds, then "
      "drops because its step may not grow beyond the nominal dt. The correct controller stays below "
      "the limit and lets the step grow."));
  blocks.push_back(kept_table(data));
  blocks.push_back(work_table(data));
  blocks.push_back(listing_table(data));
  blocks.push_back(Paragraph{fmt::format(
      "It keeps V1. Two half steps are the better answer and have been paid for, but the listing goes on "
      "with the one "
      "whole step, whose error is twice |V1 − V2|: {} of its steps on the ship are over the limit.",
      percent(taken.share_over, 0))});
  blocks.push_back(Paragraph{
      fmt::format("The retaken step is not checked again. On the linear ship e_t falls exactly with dt², so "
                  "one retry is exact (worst "
                  "{} times the tolerance). Where the force jumps e_t falls only with dt: with the thrust "
                  "reversed within the first "
                  "half of a step the retaken step is at {} times the tolerance, and its error at {}.",
                  significant(taken.worst_estimate, 4), significant(seen.worst_estimate, 3),
                  significant(seen.worst_local, 3))});
  blocks.push_back(
      Paragraph{fmt::format("Neither method sees a jump in the second half of a step, for neither evaluates "
                            "the force there: reversed at "
                            "60.3 s the worst step errs by {} times the tolerance (listing) and {} times "
                            "(correct controller), which also stepped "
                            "over the one at 60.12 s ({} times). A jump in time must be stopped at.",
                            significant(blind.worst_local, 3), significant(blind_too.worst_local, 3),
                            significant(stepped_over.worst_local, 3))});
  blocks.push_back(Paragraph{fmt::format(
      "The step never grows: the largest dt is the nominal {} s. And the clock is wrong: a game loop that "
      "adds the "
      "nominal dt after each call reads {} s when the simulation has done {} s.",
      compact(taken.largest_dt, 3), compact(taken.t_end, 3), significant(taken.t_end - taken.clock_lag, 3))});
  blocks.push_back(Paragraph{fmt::format(
      "e_t = 0 divides by zero. With IEEE numbers that is harmless: dt sqrt(e_to / 0) is {}, which is not "
      "smaller than "
      "dt, so the step is {}; so it is for 0 / 0 ({}). The ship started at its limiting speed has e_t = 0 in "
      "{} of its "
      "steps and the run {}. Trapped floating-point exceptions would stop the program there.",
      std::isinf(zero.wished) ? "infinite" : compact(zero.wished, 3), zero.step_kept ? "kept" : "not kept",
      zero.step_kept_both ? "kept" : "not kept", percent(zero.at_limit.zero_estimates, 0),
      zero.at_limit.reached_end ? "reaches its end" : "fails")});
  blocks.push_back(Paragraph{fmt::format("On a spring the estimate is blind. Only the speed takes the half "
                                         "step, so a force that depends on the "
                                         "position alone is the same in V1 and V2, and e_t = 0 in {} of the "
                                         "steps (the listing is written for the "
                                         "ship; this is its literal extension). It never shortens a step of "
                                         "{} s; the local error of the speed reaches "
                                         "{} times the tolerance.",
                                         percent(still.zero_estimates, 0), compact(still.nominal, 3),
                                         significant(still.worst_local, 3)),
                             Status::warn});
  blocks.push_back(
      Paragraph{fmt::format("Error control is not stability. The correct controller holds every step of the "
                            "undamped 5 Hz spring within "
                            "{} m/s ({} times the limit at most) and takes {} steps for {} s, yet the energy "
                            "grows {} times, because each "
                            "small error points outwards. The listing ends with {} times the energy at its "
                            "fixed dt: its base step is the "
                            "semi-implicit one, whose energy swings but does not grow (last section).",
                            compact(spring.tolerance, 2), significant(spring.worst_local, 2), spring.steps,
                            compact(spring.t_end, 3), significant(spring.energy_ratio.value_or(NAN), 3),
                            significant(still.energy_ratio.value_or(NAN), 3)),
                Status::warn});
  return blocks;
}

}  // namespace odemark::chapter_layout
