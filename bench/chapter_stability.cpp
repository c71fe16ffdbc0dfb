// Claims 1, 2 and 4: how instability looks, whether a smaller dt removes it, and whose limit is larger.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "bench/chapter_lab.hpp"

namespace odemark::chapter {

namespace {

double amplitude_of(const AnyProblem& problem, const double* y) {
  return problem.oscillation_call(problem.value.get(), y).amplitude;
}

Behaviour classify(const FaceRun& run) {
  constexpr double as_one = 1e-3;
  const bool swings = run.sign_changes > run.steps / 2;
  if (run.growth_per_step > 1 + as_one) return Behaviour::grows;
  if (run.growth_per_step < 1 - as_one)
    return swings ? Behaviour::overshoots_and_settles : Behaviour::settles;
  return Behaviour::oscillates_for_ever;
}

/// The growth is that of the deviation from the closed form; of an oscillation, that of its amplitude.
FaceRun face(const AnyProblem& problem, std::size_t i, double dt, double rate, long steps) {
  FaceRun run{problem.id, "explicit_euler", dt, rate * dt, steps};
  run.curve = stepped_curve(run.method, problem, i, dt, steps);
  const auto start = initial_state<double>(problem);
  std::vector<double> size;
  double before = 0;
  step<double>(method_called(run.method), problem, dt, steps, [&](double t, const double* y) {
    const double gap = y[i] - exact_flow<double>(problem, t, start)[i];
    if (gap * before < 0) ++run.sign_changes;
    before = gap;
    size.push_back(problem.oscillation_call ? amplitude_of(problem, y) : std::abs(gap));
    return true;
  });
  const std::size_t half = size.size() / 2;
  run.last_deviation = std::abs(before);
  run.growth_per_step = std::pow(size.back() / size[size.size() - 1 - half], 1.0 / static_cast<double>(half));
  run.behaviour = classify(run);
  return run;
}

/// The first dt at which `radius` exceeds 1, looked for upwards from `low`; absent if it does so at once.
template <class Radius>
std::optional<double> first_limit(double low, double high, Radius&& radius) {
  constexpr long double rounding = 1e-15L;
  const auto stable = [&](double dt) { return radius(dt) <= 1 + rounding; };
  if (!stable(low)) return std::nullopt;
  constexpr double ratio = 1.01;
  double inside = low;
  while (inside < high && stable(inside * ratio)) inside *= ratio;
  double outside = inside * ratio;
  for (int n = 0; n < 60; ++n) {
    const double middle = (inside + outside) / 2;
    (stable(middle) ? inside : outside) = middle;
  }
  return inside;
}

/// x' = v, v' = p x + q v.
struct LinearForce {
  double p, q;

  explicit LinearForce(const AnyProblem& homogeneous) {
    double l[4];
    homogeneous.system<double>().linear_part_call(homogeneous.value.get(), l);
    p = l[1], q = l[3];
  }
  std::complex<long double> rate(int sign) const {
    const auto wide_p = static_cast<long double>(p), wide_q = static_cast<long double>(q);
    return (wide_q + static_cast<long double>(sign) *
                         std::sqrt(std::complex<long double>(wide_q * wide_q + 4 * wide_p))) /
           2.0L;
  }
};

long double theory_radius(const AnyMethod& method, const LinearForce& force, double dt) {
  const Theory theory = method.theory();
  if (theory.moves.empty())
    return std::max(std::abs(stability_function(method, force.rate(1) * static_cast<long double>(dt))),
                    std::abs(stability_function(method, force.rate(-1) * static_cast<long double>(dt))));
  long double image[2][2];
  for (int j = 0; j < 2; ++j) {
    long double x = j == 0, v = j == 1;
    for (const SecondOrderMove& move : theory.moves) {
      const long double h = move.weight * static_cast<long double>(dt);
      if (move.what == SecondOrderMove::What::drift)
        x += h * v;
      else  // the listing's one kick comes first: its velocity is the old one
        v += h * (static_cast<long double>(force.p) * x + static_cast<long double>(force.q) * v);
    }
    image[j][0] = x, image[j][1] = v;
  }
  return spectral_radius(image[0][0], image[1][0], image[0][1], image[1][1]);
}

LimitLine limit(std::string_view method_id, std::string_view problem_id, std::string_view settings,
                double rate) {
  const AnyMethod& method = method_called(method_id);
  const AnyProblem problem = problem_called(problem_id, settings);
  const AnyProblem& free = *problem.homogeneous;
  LimitLine line{problem.id, std::string(method_id), evaluations_per_step(method, problem), {}, {}, rate};
  line.tried_down_to = 1e-3 / rate;
  const double high = 10 / rate;
  line.dt = first_limit(line.tried_down_to, high, [&](double dt) {
    const auto m =
        method.runs<long double>().transition(free.system<long double>(), static_cast<long double>(dt));
    return spectral_radius(m.columns[0], m.columns[2], m.columns[1], m.columns[3]);
  });
  if (line.dt) line.number = rate * *line.dt, line.number_per_evaluation = line.number / line.evaluations;
  const LinearForce force(free);
  line.theory =
      first_limit(line.tried_down_to, high, [&](double dt) { return theory_radius(method, force, dt); });
  return line;
}

}  // namespace

std::vector<FaceRun> faces() {
  constexpr long steps = 40;
  std::vector<FaceRun> runs;
  const AnyProblem ship = problem_called("drag_ship");
  constexpr double rate = 0.1;  // C/m
  for (const double product : {0.5, 1.5, 2.0, 2.1})
    runs.push_back(face(ship, 1, product / rate, rate, steps));
  // F - c v|v| about its limiting speed sqrt(F/c): the rate there is 2 sqrt(F c) / m
  const AnyProblem quadratic = problem_called("drag_ship_quadratic", "t_reverse=1e9");
  const double rate_there = 2 * std::sqrt(1e6 * 25000) / 5e6;
  runs.push_back(face(quadratic, 1, 1.5 / rate_there, rate_there, steps));
  for (const double product : {2.2, 2.4})
    runs.push_back(face(quadratic, 1, product / rate_there, rate_there, 10 * steps));
  const AnyProblem spring = problem_called("oscillator");
  for (const double product : {0.05, 0.2})
    runs.push_back(face(spring, 0, product, 1, std::lround(8 * pi / product)));
  return runs;
}

std::vector<GrowthPoint> growth() {
  const AnyProblem spring = problem_called("oscillator", fmt::format("omega={:.17g}", 2 * pi));
  constexpr double seconds = 10;
  std::vector<GrowthPoint> points;
  for (const char* id : {"explicit_euler", "heun", "rk4"})
    for (const int per_second : {15, 30, 60, 120, 240, 480, 1000, 2000}) {
      const AnyMethod& method = method_called(id);
      const double dt = 1.0 / per_second;
      const auto end = step<double>(method, spring, dt, std::lround(seconds * per_second)).y;
      GrowthPoint point{id, dt};
      const double start = amplitude_of(spring, spring.initial.data());
      point.measured = std::log(amplitude_of(spring, end.data()) / start) / seconds;
      const auto r = stability_function(method, {0, static_cast<long double>(2 * pi * dt)});
      point.theory = double(std::log(std::norm(r))) / (2 * dt);
      point.resolution =
          4 * std::numeric_limits<double>::epsilon() * std::sqrt(seconds * per_second) / seconds;
      if (point.measured > point.resolution) point.doubles_in = std::log(2) / point.measured;
      points.push_back(point);
    }
  return points;
}

std::vector<Stall> stalls() {
  const AnyProblem ship = problem_called("drag_ship");
  const AnyMethod& euler = method_called("explicit_euler");
  constexpr double seconds = 60, rate = 0.1;
  std::vector<Stall> lines;
  for (const long steps : {120L, 6000L, 60'000L, 600'000L, 6'000'000L}) {
    Stall line{seconds / double(steps), steps};
    float last = 0;
    double changed = 0;
    line.v_float = double(step<float>(euler, ship, line.dt, steps, [&](float t, const float* y) {
                            if (y[1] != last) changed = double(t);
                            last = y[1];
                            return true;
                          }).y[1]);
    if (changed < seconds - 2 * line.dt) line.stalled_from = changed;
    line.v_double = step<double>(euler, ship, line.dt, steps).y[1];
    line.exact = exact_flow<double>(ship, seconds, initial_state<double>(ship))[1];
    const float v = float(line.exact);
    const double ulp = double(std::nextafter(v, 2 * v) - v);
    line.dv_of_stall = ulp / 2 / (rate * line.dt);
    lines.push_back(line);
  }
  return lines;
}

std::vector<LimitLine> limits() {
  std::vector<LimitLine> lines;
  struct Case {
    const char *problem, *settings;
    double rate;
  };
  for (const Case& c :
       {Case{"drag_ship", "", 0.1}, Case{"oscillator", "", 1}, Case{"damped_spring", "zeta=0.01", 1},
        Case{"damped_spring", "zeta=0.1", 1}, Case{"damped_spring", "zeta=1", 1}})
    for (const char* method : {"explicit_euler", "heun", "rk4", "chapter_euler"})
      lines.push_back(limit(method, c.problem, c.settings, c.rate));
  return lines;
}

}  // namespace odemark::chapter
