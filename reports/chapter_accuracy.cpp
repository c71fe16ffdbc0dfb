// Claims 3 and 6: error against dt down to round-off, clocks, and error against cost.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "reports/chapter_words.hpp"
#include "reports/format.hpp"

namespace odemark::chapter_layout {

namespace {

constexpr std::array<std::string_view, 3> methods{"explicit_euler", "heun", "rk4"};

Chart error_chart(const ChapterData& data, std::string_view problem) {
  Chart chart;
  chart.id = fmt::format("error-{}", problem);
  chart.title = fmt::format("Error against dt: {}", problem_name(problem));
  chart.caption =
      "Filled and solid: double. Hollow and dashed: float. Each curve falls with its order until round-off "
      "takes over; the left branch is what a smaller dt costs. The error is the largest at up to 64 (in few "
      "steps "
      "up to 127) evenly spaced times, in units of the limiting speed or of the amplitude.";
  chart.x = {"dt [s]", Scale::log10, {}};
  chart.y = {"error", Scale::log10, {}};
  chart.slopes = SlopeFan{{1, 2, 4}, "order"};
  for (const std::string_view scalar : {"double", "float"})
    for (const std::string_view method : methods) {
      const ErrorCurve& curve = error_of(data, problem, method, scalar);
      Series series{fmt::format("{}-{}", method, scalar),
                    fmt::format("{}, {}", method_name(method), scalar),
                    std::string(scalar),
                    {},
                    look(method)};
      if (scalar == "float") series.style.line = Line::dashed, series.style.filled = false;
      for (const ErrorPoint& point : curve.points) series.points.push_back({point.dt, point.error});
      chart.series.push_back(std::move(series));
    }
  return chart;
}

Table minimum_table(const ChapterData& data) {
  Table table{"minimum",
              "The dt of the smallest error",
              "Rises again: below the best dt the error at least doubles. Not reached: it still falls, or "
              "lies flat, at the smallest "
              "dt that was run.",
              {{"problem"},
               {"method"},
               {"number"},
               {"best dt", Align::right, "s"},
               {"error there", Align::right},
               {"smallest dt", Align::right, "s"},
               {"error there", Align::right},
               {"rises again"}},
              {}};
  for (const ErrorCurve& curve : data.errors) {
    const ErrorPoint& last = curve.points.back();
    table.rows.push_back(
        {words(problem_name(curve.problem)), words(method_name(curve.method)), words(curve.scalar),
         digits(curve.best.dt, 3), digits(curve.best.error, 2), digits(last.dt, 3), digits(last.error, 2),
         curve.minimum_inside ? words("yes", Status::warn) : words("not reached", Status::muted)});
  }
  return table;
}

Table clock_table(const ChapterData& data) {
  Table table{
      "clock",
      "A scene clock in single precision",
      "Accumulated: t += dt each step. Computed: t = n dt. 1/64 s is exact in binary, so its sums are too.",
      {{"dt", Align::right, "s"},
       {"after", Align::right, "s"},
       {"accumulated clock is off by", Align::right, "s"},
       {"computed clock is off by", Align::right, "s"},
       {"t + dt = t from", Align::right, "s"}},
      {}};
  for (const ClockLine& line : data.clocks)
    table.rows.push_back({digits(line.dt, 5), digits(line.duration, 6), digits(line.accumulated_error, 4),
                          digits(line.computed_error, 2), digits(line.stops_at, 7)});
  return table;
}

Chart cost_chart(const ChapterData& data, std::string_view problem) {
  Chart chart;
  chart.id = fmt::format("cost-{}", problem);
  chart.title = fmt::format("Error against evaluations: {}", problem_name(problem));
  chart.caption =
      "In double precision, up to 20 000 evaluations. Lower is better at equal cost; where two curves cross, "
      "the winner changes.";
  chart.x = {"evaluations of the force", Scale::log10, {}};
  chart.y = {"error", Scale::log10, {}};
  for (const ErrorCurve& curve : data.errors) {
    if (curve.problem != problem || curve.scalar != "double") continue;
    Series series{curve.method, method_name(curve.method), "", {}, look(curve.method)};
    constexpr long shown = 20000;
    for (const ErrorPoint& point : curve.points)
      if (point.evaluations <= shown) series.points.push_back({double(point.evaluations), point.error});
    chart.series.push_back(std::move(series));
  }
  return chart;
}

Table cost_table(const ChapterData& data, std::string_view problem) {
  Table table{fmt::format("cost-table-{}", problem),
              fmt::format("Evaluations for a given error: {}", problem_name(problem)),
              "Interpolated between measured runs; the cheapest is marked.",
              {{"error", Align::right}},
              {}};
  for (const CostLine& line : data.costs) {
    if (line.problem != problem) continue;
    if (table.columns.size() == 1)
      for (const auto& [method, cost] : line.evaluations)
        table.columns.push_back({method_name(method), Align::right});
    table.rows.push_back({digits(line.error, 2)});
    const std::optional<double>* best = nullptr;
    for (const auto& [method, cost] : line.evaluations)
      if (cost && (!best || *cost < **best)) best = &cost;
    for (const auto& [method, cost] : line.evaluations) {
      Cell cell = digits_or(cost, 3, "beyond the runs");
      if (cost && &cost == best) cell.status = Status::ok;
      table.rows.back().push_back(cell);
    }
  }
  return table;
}

Table same_step_table(const ChapterData& data) {
  Table table{"same-step", "Error at the same dt", "", {{"problem"}, {"dt", Align::right, "s"}}, {}};
  for (const std::string_view method : methods) table.columns.push_back({method_name(method), Align::right});
  for (const SameStep& line : data.same_step) {
    table.rows.push_back({words(problem_name(line.problem)), digits(line.dt, 4)});
    for (const auto& [method, error] : line.errors) table.rows.back().push_back(digits(error, 3));
  }
  return table;
}

Table crossover_table(const ChapterData& data) {
  Table table{"crossover",
              "At equal cost",
              "For errors below the crossing the second method needs fewer evaluations, above it the first.",
              {{"problem"},
               {"first"},
               {"second"},
               {"cross at error", Align::right},
               {"evaluations there", Align::right},
               {"cheaper throughout"}},
              {}};
  for (const Crossover& line : data.crossovers)
    table.rows.push_back({words(problem_name(line.problem)), words(method_name(line.cheap)),
                          words(method_name(line.dear)), digits_or(line.error, 2, "no crossing"),
                          digits_or(line.evaluations, 3, ""),
                          words(line.error ? "" : method_name(line.winner))});
  return table;
}

}  // namespace

std::string verdict_3(const ChapterData& data) {
  const auto best = [&](std::string_view method, std::string_view scalar) {
    const ErrorCurve& curve = error_of(data, "drag_ship", method, scalar);
    return curve.minimum_inside ? compact(curve.best.dt, 2) + " s"
                                : fmt::format("none down to {} s", compact(curve.points.back().dt, 2));
  };
  const ErrorCurve& euler = error_of(data, "drag_ship", "explicit_euler", "float");
  const ClockLine& clock = data.clocks.at(1);
  return fmt::format(
      "On the ship in float the error is smallest at dt = {} (Euler), {} (improved Euler) and {} "
      "(Runge–Kutta 4); Euler "
      "at {} s is {} times worse than at its best. Such a dt in double: {} (Euler), {} (improved Euler), {} "
      "(Runge–Kutta 4). A float clock that adds dt = 1/60 s is off "
      "by {} s after {} hours; t = n dt by {} s.",
      best("explicit_euler", "float"), best("heun", "float"), best("rk4", "float"),
      compact(euler.points.back().dt, 2), significant(euler.points.back().error / euler.best.error, 2),
      best("explicit_euler", "double"), best("heun", "double"), best("rk4", "double"),
      significant(clock.accumulated_error, 3), compact(clock.duration / 3600, 3),
      significant(std::abs(clock.computed_error), 2));
}

std::vector<Block> claim_3(const ChapterData& data) {
  return {error_chart(data, "drag_ship"), error_chart(data, "oscillator"), minimum_table(data),
          clock_table(data)};
}

std::string verdict_6(const ChapterData& data) {
  const Crossover &ship = crossover_of(data, "drag_ship", "explicit_euler", "rk4"),
                  &spring = crossover_of(data, "oscillator", "heun", "rk4"),
                  &listing = crossover_of(data, "oscillator", "chapter_euler", "rk4");
  const SameStep& step = data.same_step.at(0);
  const auto crossing = [](const Crossover& line) {
    return line.error ? fmt::format("for errors below {}", percent(*line.error, 0))
                      : fmt::format("nowhere: {} is cheaper throughout", method_name(line.winner));
  };
  std::string at_step = fmt::format("At dt = {} s on the ship the errors are", compact(step.dt, 3));
  for (const auto& [method, error] : step.errors)
    at_step += fmt::format("{} {} ({})", method == step.errors.front().first ? "" : ",", scientific(error, 2),
                           method_name(method));
  return fmt::format(
      "{}. At equal cost Runge–Kutta 4 beats Euler on the ship {}, and the chapter's own listing on the "
      "undamped "
      "spring {}; against improved Euler on the spring {}.",
      at_step, crossing(ship), crossing(listing),
      spring.error
          ? "it wins " + crossing(spring)
          : fmt::format("{} is cheaper at every error that was reached", method_name(spring.winner)));
}

std::vector<Block> claim_6(const ChapterData& data) {
  return {same_step_table(data),         cost_chart(data, "drag_ship"),  cost_chart(data, "oscillator"),
          cost_table(data, "drag_ship"), cost_table(data, "oscillator"), crossover_table(data)};
}

}  // namespace odemark::chapter_layout
