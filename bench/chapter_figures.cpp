// The curves of figures 7-1 to 7-8, stepped.
#include <fmt/format.h>

#include "bench/chapter_lab.hpp"

namespace odemark::chapter {

namespace {

constexpr std::size_t displacement = 0, speed = 1;

/// One Euler step of each size: the straight line along which the step leaves the curve.
Trajectory single_steps(const AnyProblem& ship, double longest) {
  Trajectory line = stepped_curve("explicit_euler", ship, speed, longest, 0);
  constexpr int sizes = 10;
  for (int n = 1; n <= sizes; ++n) {
    const double dt = longest * n / sizes;
    line.t.push_back(dt);
    line.value.push_back(step<double>(method_called("explicit_euler"), ship, dt, 1).y[speed]);
  }
  return line;
}

}  // namespace

std::vector<ChapterFigure> figures(double k, double m, double dt) {
  const AnyProblem ship = problem_called("drag_ship");
  const AnyProblem spring = problem_called("oscillator", fmt::format("k={:.17g},m={:.17g}", k, m));
  const auto ship_curve = [&](std::string_view method, double to) {
    return stepped_curve(method, ship, speed, table_dt, std::lround(to / table_dt));
  };
  const auto ship_exact = [&](double from, double to) { return exact_curve(ship, speed, from, to, 120); };
  const double period = 2 * pi * std::sqrt(m / k), spring_end = 6 * period;
  const auto spring_curve = [&](std::string_view method) {
    return stepped_curve(method, spring, displacement, dt, std::lround(spring_end / dt));
  };
  const Trajectory spring_exact = exact_curve(spring, displacement, 0, spring_end, 480);

  std::vector<ChapterFigure> all;
  constexpr double one_step = 5;
  all.push_back({"7-1", {ship_exact(0, one_step), single_steps(ship, one_step)}, 0, one_step});
  all.push_back({"7-2", {ship_exact(0, 20), ship_curve("explicit_euler", 20)}, 0, 20});
  all.push_back({"7-3", {ship_exact(6.5, 8.5), ship_curve("explicit_euler", 8.5)}, 6.5, 8.5});
  all.push_back({"7-4", {ship_exact(40, 60), ship_curve("explicit_euler", 60)}, 40, 60});
  all.push_back(
      {"7-5", {spring_exact, spring_curve("explicit_euler"), spring_curve("chapter_euler")}, 0, spring_end});
  const auto three = [&](double to) {
    return std::vector{ship_curve("explicit_euler", to), ship_curve("heun", to), ship_curve("rk4", to)};
  };
  for (const auto& [number, from, to] : {std::tuple{"7-6", 0.0, 20.0}, std::tuple{"7-7", 6.5, 8.5}}) {
    ChapterFigure figure{number, three(to), from, to};
    figure.curves.insert(figure.curves.begin(), ship_exact(from, to));
    all.push_back(std::move(figure));
  }
  all.push_back({"7-8", {spring_exact, spring_curve("heun"), spring_curve("rk4")}, 0, spring_end});
  for (ChapterFigure& figure : all)
    for (Trajectory& curve : figure.curves) {  // only what the figure shows
      Trajectory shown = curve;
      shown.t.clear(), shown.value.clear();
      for (std::size_t i = 0; i < curve.t.size(); ++i)
        if (curve.t[i] >= figure.from - 1e-9 && curve.t[i] <= figure.to + 1e-9)
          shown.t.push_back(curve.t[i]), shown.value.push_back(curve.value[i]);
      curve = std::move(shown);
    }
  return all;
}

}  // namespace odemark::chapter
