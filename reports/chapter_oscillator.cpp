// Claim 5: how long improved Euler and Runge–Kutta stay alike on the undamped spring, and what that saves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/chapter_words.hpp"
#include "reports/format.hpp"

namespace odemark::chapter_layout {

namespace {

constexpr double degrees = 57.29577951308232;

Cell periods(const Halving& line) {
  return number_cell(line.periods, (line.extrapolated ? "≈ " : "") + compact(line.periods, 5));
}

Table doubling_table(const ChapterData& data) {
  Table table{"doubling",
              "Amplitudes: periods until a factor of two",
              "In periods, measured by stepping until it has happened; ≈ marks an extrapolation from the "
              "change over two million "
              "steps. Theory: ln 2 / ln|R(iω dt)| steps.",
              {{"ω dt", Align::right},
               {"steps per period", Align::right},
               {"improved Euler doubles", Align::right},
               {"theory", Align::right},
               {"at 60 steps/s", Align::right},
               {"Runge–Kutta 4 halves", Align::right},
               {"theory", Align::right}},
              {}};
  for (const DoublingLine& line : data.doublings)
    table.rows.push_back({digits(line.z, 4), digits(line.steps_per_period, 3), periods(line.heun_doubles),
                          digits(line.heun_doubles.theory, 5),
                          number_cell(line.heun_seconds_at_60, long_time(line.heun_seconds_at_60)),
                          periods(line.rk4_halves), digits(line.rk4_halves.theory, 5)});
  return table;
}

Table phase_table(const ChapterData& data) {
  Table table{"phase",
              "Per period, measured over 20: factor of the amplitude, and phase ahead of the exact motion",
              "",
              {{"ω dt", Align::right},
               {"improved Euler", Align::right},
               {"theory", Align::right},
               {"phase", Align::right, "°"},
               {"theory", Align::right, "°"},
               {"Runge–Kutta 4", Align::right},
               {"theory", Align::right},
               {"phase", Align::right, "°"},
               {"theory", Align::right, "°"}},
              {}};
  for (const DoublingLine& line : data.doublings)
    table.rows.push_back({digits(line.z, 4), digits(line.heun_amplitude, 6),
                          digits(line.heun_amplitude_theory, 6), digits(line.heun_phase * degrees, 3),
                          digits(line.heun_phase_theory * degrees, 3), digits(line.rk4_amplitude, 8),
                          digits(line.rk4_amplitude_theory, 8), digits(line.rk4_phase * degrees, 3),
                          digits(line.rk4_phase_theory * degrees, 3)});
  return table;
}

Table apart_table(const ChapterData& data) {
  Table table{"apart",
              "Periods until the two displacements are apart",
              "By a part of the starting amplitude; looked for over 100 periods.",
              {{"ω dt", Align::right}, {"by 1 %", Align::right}, {"by 10 %", Align::right}},
              {}};
  for (const DoublingLine& line : data.doublings)
    table.rows.push_back({digits(line.z, 4), digits_or(line.differ_1_percent, 3, "beyond 100"),
                          digits_or(line.differ_10_percent, 3, "beyond 100")});
  return table;
}

Chart doubling_chart(const ChapterData& data) {
  Chart chart;
  chart.id = "doubling-chart";
  chart.title = "Periods until the amplitude has doubled or halved";
  chart.caption =
      "Improved Euler doubles after about 0.88 / (ω dt)³ periods, Runge–Kutta 4 halves after about 15.9 / (ω "
      "dt)⁵. "
      "Markers are measured (hollow: extrapolated), dotted lines are theory.";
  chart.x = {"ω dt", Scale::log10, {}};
  chart.y = {"periods", Scale::log10, {}};
  const auto add = [&](const char* method, const char* what, Halving DoublingLine::*member) {
    Series theory{fmt::format("{}-theory", method),
                  fmt::format("{} {}, theory", method_name(method), what),
                  "",
                  {},
                  look(method)};
    Series measured{method, fmt::format("{} {}", method_name(method), what), "", {}, look(method)};
    Series guessed{fmt::format("{}-extrapolated", method),
                   fmt::format("{} {}, extrapolated", method_name(method), what),
                   "",
                   {},
                   look(method)};
    theory.style.line = Line::dotted, theory.style.marker = Marker::none;
    measured.style.line = guessed.style.line = Line::none;
    guessed.style.filled = false;
    for (const DoublingLine& line : data.doublings) {
      const Halving& h = line.*member;
      theory.points.push_back({line.z, h.theory});
      (h.extrapolated ? guessed : measured).points.push_back({line.z, h.periods});
    }
    chart.series.push_back(std::move(theory));
    chart.series.push_back(std::move(measured));
    if (!guessed.points.empty()) chart.series.push_back(std::move(guessed));
  };
  add("heun", "doubles", &DoublingLine::heun_doubles);
  add("rk4", "halves", &DoublingLine::rk4_halves);
  return chart;
}

Table equal_cost_table(const ChapterData& data) {
  Table table{
      "equal-cost",
      fmt::format("Equal evaluations per period: the state after {} periods",
                  compact(data.equal_cost.at(0).periods, 4)),
      "Runge–Kutta takes steps twice as long as improved Euler, and four times those of the chapter's "
      "listing. "
      "Error: distance from the exact state, as a part of the amplitude. The smallest is marked.",
      {{"evaluations", Align::right},
       {"error: improved Euler", Align::right},
       {"Runge–Kutta 4", Align::right},
       {"listing", Align::right},
       {"amplitude: improved Euler", Align::right},
       {"Runge–Kutta 4", Align::right},
       {"listing", Align::right}},
      {}};
  for (const EqualCostLine& line : data.equal_cost) {
    const double best = std::min({line.heun_error, line.rk4_error, line.listing_error});
    const auto error = [&](double x) {
      Cell cell = digits(x, 3);
      if (x <= best) cell.status = Status::ok;
      return cell;
    };
    table.rows.push_back({digits(line.evaluations_per_period, 5), error(line.heun_error),
                          error(line.rk4_error), error(line.listing_error), digits(line.heun_amplitude, 6),
                          digits(line.rk4_amplitude, 6), digits(line.listing_amplitude, 6)});
  }
  return table;
}

Table memory_table(const ChapterData& data) {
  Table table{
      "memory",
      "Working memory of a step",
      "One slope per evaluation, as this suite keeps them, for a rigid body of 13 floats. It is scratch: a "
      "loop over independent bodies needs it once, not once per body.",
      {{"method"}, {"slopes", Align::right}, {"bytes for one body", Align::right}},
      {}};
  for (const MemoryLine& line : data.memory)
    table.rows.push_back({words(method_name(line.method)),
                          number_cell(line.slopes, std::to_string(line.slopes)),
                          digits(line.bytes_per_body, 4)});
  return table;
}

std::string or_beyond(const std::optional<double>& x) { return x ? significant(*x, 2) : "more than 100"; }

}  // namespace

std::string verdict_5(const ChapterData& data) {
  const DoublingLine &fine = doubling_of(data, 0.1), &coarse = data.doublings.at(5);
  bool dearer = true;
  for (const EqualCostLine& line : data.equal_cost) dearer = dearer && line.heun_error > line.rk4_error;
  const EqualCostLine& cost = data.equal_cost.at(2);
  return fmt::format(
      "By eye only, and only for a while: at ω dt = 0.1 they are 1 % apart after {} periods, 10 % after {}, "
      "and improved "
      "Euler's amplitude has doubled after {}; for a 5 Hz spring at 60 steps a second after {} periods, {}. "
      "It is "
      "unstable at every dt that was tried. Nor does it save time: at equal cost Runge–Kutta 4 was {} ({} "
      "evaluations a "
      "period: error {} against {}). The memory saved is {} bytes of scratch.",
      or_beyond(fine.differ_1_percent), or_beyond(fine.differ_10_percent),
      significant(fine.heun_doubles.periods, 4), significant(coarse.heun_doubles.periods, 3),
      long_time(coarse.heun_seconds_at_60),
      dearer ? "more accurate at every cost" : "not always more accurate",
      compact(cost.evaluations_per_period, 4), significant(cost.rk4_error, 2),
      significant(cost.heun_error, 2),
      compact(data.memory.at(2).bytes_per_body - data.memory.at(1).bytes_per_body, 4));
}

std::vector<Block> claim_5(const ChapterData& data) {
  return {doubling_chart(data), doubling_table(data),   phase_table(data),
          apart_table(data),    equal_cost_table(data), memory_table(data)};
}

}  // namespace odemark::chapter_layout
