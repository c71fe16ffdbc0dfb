// Claims 1, 2 and 4: how instability looks, whether a smaller dt removes it, whose limit is larger.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/chapter_words.hpp"
#include "reports/format.hpp"

namespace odemark::chapter_layout {

namespace {

const FaceRun* face_of(const ChapterData& data, std::string_view problem, Behaviour behaviour) {
  for (const FaceRun& run : data.faces)
    if (run.problem.substr(0, problem.size()) == problem && run.behaviour == behaviour) return &run;
  return nullptr;
}

constexpr std::string_view ship = "drag_ship", quadratic = "drag_ship_quadratic", spring = "oscillator",
                           light = "damped_spring{zeta=0.01}";

Chart face_chart(const ChapterData& data, std::string_view problem, std::string id, std::string title,
                 std::string caption, std::size_t points) {
  Chart chart;
  chart.id = std::move(id), chart.title = std::move(title), chart.caption = std::move(caption);
  chart.x.label = "step";
  chart.y.label = problem == spring ? "displacement [m]" : "speed [m/s]";
  int colour = 0;
  constexpr std::array markers{Marker::circle, Marker::square, Marker::triangle_up, Marker::diamond};
  for (const FaceRun& run : data.faces) {
    const bool wanted =
        problem == ship ? run.problem == ship : run.problem.substr(0, problem.size()) == problem;
    if (!wanted) continue;
    Series series{fmt::format("{}-{}", run.problem, colour),
                  fmt::format("{} dt = {} (dt = {} s)", problem == spring ? "ω" : "λ",
                              compact(run.rate_times_dt, 3), compact(run.dt, 4)),
                  "",
                  {},
                  {.colour = colour, .marker = markers.at(std::size_t(colour) % markers.size())}};
    ++colour;
    for (std::size_t i = 0; i < run.curve.t.size() && i <= points; ++i)
      series.points.push_back({static_cast<double>(i), run.curve.value[i]});
    if (series.points.size() > 60) series.style.marker = Marker::none;
    chart.series.push_back(std::move(series));
  }
  return chart;
}

std::string doubling(const GrowthPoint& point) {
  return point.doubles_in ? long_time(*point.doubles_in) : std::string("never");
}

std::string number_of(const LimitLine& line) { return line.dt ? compact(line.number, 4) : "none"; }

Chart growth_chart(const ChapterData& data) {
  Chart chart;
  chart.id = "growth";
  chart.title = "Growth of the amplitude, undamped 1 Hz spring";
  chart.caption =
      "Markers are measured over 10 s, dotted lines are ln|R(iω dt)| / dt. Euler's growth falls with dt, "
      "improved Euler's with dt³; neither reaches zero. Runge–Kutta 4 is not drawn: its amplitude shrinks.";
  chart.x = {"dt [s]", Scale::log10, {}};
  chart.y = {"d ln(amplitude) / dt [1/s]", Scale::log10, {}};
  for (const char* method : {"explicit_euler", "heun"}) {
    Series measured{method, method_name(method), "", {}, look(method)};
    Series theory{fmt::format("{}-theory", method), method_name(method) + ", theory", "", {}, look(method)};
    measured.style.line = Line::none;
    theory.style.line = Line::dotted, theory.style.marker = Marker::none;
    for (const GrowthPoint& point : data.growth)
      if (point.method == method)
        measured.points.push_back({point.dt, point.measured}),
            theory.points.push_back({point.dt, point.theory});
    chart.series.push_back(std::move(theory));
    chart.series.push_back(std::move(measured));
  }
  return chart;
}

Table growth_table(const ChapterData& data) {
  Table table{"growth-table",
              "Undamped 1 Hz spring: growth per second, and when the amplitude has doubled",
              "Growth measured over 10 s, in 1/s; theory from the method's own coefficients. Doubling times "
              "beyond that "
              "are extrapolated.",
              {{"steps/s", Align::right}},
              {}};
  std::string method;
  std::size_t row = 0;
  for (const GrowthPoint& point : data.growth) {
    if (point.method != method) {
      method = point.method, row = 0;
      for (const std::string& column :
           {method_name(method), std::string("theory"), std::string("doubles in")})
        table.columns.push_back({column, Align::right});
    }
    if (row == table.rows.size()) table.rows.push_back({digits(std::round(1 / point.dt), 5)});
    std::vector<Cell>& cells = table.rows.at(row++);
    cells.push_back({within_resolution(point.measured, point.resolution, 4), Status::plain, point.measured});
    cells.push_back({significant(point.theory, 4), Status::plain, point.theory});
    cells.push_back(point.doubles_in ? number_cell(*point.doubles_in, long_time(*point.doubles_in))
                                     : words("never", Status::muted));
  }
  return table;
}

Table stall_table(const ChapterData& data) {
  Table table{
      "stall",
      "The ship after 60 s in single precision",
      "A step adds a dt to the speed. Once that is less than half a unit in the last place it is rounded "
      "away, and the ship stops accelerating short of its limiting speed.",
      {{"dt", Align::right, "s"},
       {"float", Align::right, "m/s"},
       {"double", Align::right, "m/s"},
       {"exact", Align::right, "m/s"},
       {"stopped at", Align::right, "s"},
       {"predicted stop short by", Align::right, "m/s"}},
      {}};
  for (const Stall& line : data.stalls)
    table.rows.push_back({digits(line.dt, 3), digits(line.v_float, 7), digits(line.v_double, 7),
                          digits(line.exact, 7), digits_or(line.stalled_from, 4, "still moving"),
                          digits(line.dv_of_stall, 3)});
  return table;
}

}  // namespace

std::string verdict_1(const ChapterData& data) {
  const FaceRun *swings = face_of(data, ship, Behaviour::oscillates_for_ever),
                *grows = face_of(data, ship, Behaviour::grows),
                *settles = face_of(data, ship, Behaviour::overshoots_and_settles);
  std::string text;
  if (swings && grows)
    text = fmt::format(
        "Euler on the ship swings about the exact speed for ever at dt = {} s (deviation × {} per step) and "
        "diverges at "
        "{} s (× {}).",
        compact(swings->dt, 4), significant(swings->growth_per_step, 4), compact(grows->dt, 4),
        significant(grows->growth_per_step, 4));
  if (settles)
    text +=
        fmt::format(" Overshooting every step is not yet instability: at {} s it does, and settles (× {}).",
                    compact(settles->dt, 4), significant(settles->growth_per_step, 4));
  std::string lasting;
  for (const FaceRun& run : data.faces)
    if (run.problem.substr(0, quadratic.size()) == quadratic &&
        run.behaviour == Behaviour::oscillates_for_ever)
      lasting += (lasting.empty() ? "" : " and ") + compact(run.rate_times_dt, 3);
  if (!lasting.empty())
    text += fmt::format(
        " With linear drag the lasting swing needs λ dt = 2 exactly; with quadratic drag it was seen at λ dt "
        "= {}.",
        lasting);
  return text;
}

std::vector<Block> claim_1(const ChapterData& data) {
  Table table{
      "faces",
      "Euler at several dt",
      "λ dt and ω dt are the step in units of the problem's own rate. Growth per step: of the deviation from "
      "the exact solution, over the second half of the run; on the spring, of the amplitude.",
      {{"problem"},
       {"dt", Align::right, "s"},
       {"λ dt or ω dt", Align::right},
       {"steps", Align::right},
       {"changes of sign", Align::right},
       {"growth per step", Align::right},
       {"class"}},
      {}};
  for (const FaceRun& run : data.faces) {
    const bool bad = run.behaviour == Behaviour::oscillates_for_ever || run.behaviour == Behaviour::grows;
    table.rows.push_back({words(problem_name(run.problem)), digits(run.dt, 4), digits(run.rate_times_dt, 3),
                          number_cell(double(run.steps), std::to_string(run.steps)),
                          number_cell(double(run.sign_changes), std::to_string(run.sign_changes)),
                          digits(run.growth_per_step, 5),
                          words(behaviour_text(run.behaviour), bad ? Status::warn : Status::ok)});
  }
  return {
      table,
      face_chart(data, ship, "faces-ship", "The ship, Euler, four steps dt",
                 "Settling, settling with an overshoot every step, swinging for ever, diverging.", 20),
      face_chart(data, quadratic, "faces-quadratic", "The ship with quadratic drag, Euler",
                 "At both dt beyond λ dt = 2 the swing neither dies nor grows: the first face, and not only "
                 "at one dt.",
                 40),
      face_chart(data, spring, "faces-spring", "The undamped spring, Euler",
                 "The second face: growth at each of two steps dt, the smaller one slower per step.", 160)};
}

std::string verdict_2(const ChapterData& data) {
  const LimitLine& cured = limit_of(data, ship, "explicit_euler");
  const GrowthPoint &euler = growth_of(data, "explicit_euler", 60), &heun = growth_of(data, "heun", 60),
                    &finest = growth_of(data, "explicit_euler", 2000);
  const Stall& stall = data.stalls.back();
  return fmt::format(
      "True where the problem damps: Euler on the ship is stable up to dt = {} s. False on the undamped "
      "spring, where "
      "no dt is stable for Euler or improved Euler: at 1 Hz and 60 steps a second the amplitude doubles in "
      "{} and {}, "
      "and at 2000 steps a second Euler's still doubles in {}. In float, dt = {} s leaves the ship at {} m/s "
      "instead of "
      "{} m/s.",
      cured.dt ? compact(*cured.dt, 5) : "0", doubling(euler), doubling(heun), doubling(finest),
      compact(stall.dt, 3), significant(stall.v_float, 5), significant(stall.exact, 5));
}

std::vector<Block> claim_2(const ChapterData& data) {
  Table limits{"cured",
               "Where a smaller dt helps: the largest stable dt of Euler",
               "",
               {{"problem"}, {"measured", Align::right, "s"}, {"theory", Align::right, "s"}},
               {}};
  for (const LimitLine& line : data.limits)
    if (line.method == "explicit_euler")
      limits.rows.push_back({words(problem_name(line.problem)), digits_or(line.dt, 6, "no stable dt"),
                             digits_or(line.theory, 6, "no stable dt")});
  return {limits, growth_chart(data), growth_table(data), stall_table(data)};
}

std::string verdict_4(const ChapterData& data) {
  const auto number = [&](std::string_view problem, std::string_view method) {
    return number_of(limit_of(data, problem, method));
  };
  const auto per_evaluation = [&](std::string_view method) {
    return compact(limit_of(data, ship, method).number_per_evaluation, 3);
  };
  return fmt::format(
      "Largest stable step per step taken, Euler / improved Euler / Runge–Kutta 4: λ dt = {} / {} / {} on "
      "the ship, "
      "ω dt = {} / {} / {} on the undamped spring, {} / {} / {} with damping ζ = 0.01. Per evaluation on the "
      "ship: "
      "{} / {} / {}. The chapter's own listing reaches ω dt = {} on the undamped spring with one evaluation.",
      number(ship, "explicit_euler"), number(ship, "heun"), number(ship, "rk4"),
      number(spring, "explicit_euler"), number(spring, "heun"), number(spring, "rk4"),
      number(light, "explicit_euler"), number(light, "heun"), number(light, "rk4"),
      per_evaluation("explicit_euler"), per_evaluation("heun"), per_evaluation("rk4"),
      number(spring, "chapter_euler"));
}

std::vector<Block> claim_4(const ChapterData& data) {
  Table table{"limits",
              "The largest stable step, measured on the real steps",
              "In units of the rate λ or ω of the problem. “None”: unstable at every dt tried, down to a "
              "thousandth of "
              "1/ω. Theory is from the coefficients. The largest number of each problem is marked.",
              {{"problem"},
               {"method"},
               {"evaluations", Align::right},
               {"limit", Align::right},
               {"theory", Align::right},
               {"limit per evaluation", Align::right}},
              {}};
  for (const LimitLine& line : data.limits) {
    double best = 0, best_per = 0;
    for (const LimitLine& other : data.limits)
      if (other.problem == line.problem)
        best = std::max(best, other.number), best_per = std::max(best_per, other.number_per_evaluation);
    const auto cell = [&](double number, double largest) {
      if (!line.dt) return words("none", Status::fail);
      Cell out = digits(number, 5);
      if (number >= largest * (1 - 1e-6)) out.status = Status::ok;
      return out;
    };
    table.rows.push_back({words(problem_name(line.problem)), words(method_name(line.method)),
                          number_cell(line.evaluations, std::to_string(line.evaluations)),
                          cell(line.number, best),
                          line.theory ? digits(*line.theory * line.rate, 5) : words("none", Status::muted),
                          cell(line.number_per_evaluation, best_per)});
  }
  return {table};
}

}  // namespace odemark::chapter_layout
