// Claims 3 and 6: error against dt down to round-off, clocks in single precision, and error against cost.
#include <algorithm>
#include <array>
#include <limits>

#include "bench/chapter_lab.hpp"

namespace odemark::chapter {

namespace {

constexpr long sample_count = 64;

struct Scene {
  const char* problem;
  double t_end;       // s; 2^-n of it is exact in single precision
  long coarsest;      // steps
  std::size_t first;  // components from here on are compared
  double size;        // of one component, in its unit
};
constexpr std::array scenes{Scene{"drag_ship", 64, 4, 1, 20}, Scene{"oscillator", 10, 8, 0, 1}};

/// Numbers of steps: octaves, in double precision with quarters between them where steps are few.
std::vector<long> step_counts(long coarsest, long finest, bool quarters) {
  std::vector<long> counts;
  if (quarters) counts.push_back(3 * coarsest / 4);
  for (long n = coarsest; n <= finest; n *= 2) {
    counts.push_back(n);
    if (quarters && n < 128)
      for (const long quarter : {5 * n / 4, 6 * n / 4, 7 * n / 4}) counts.push_back(quarter);
  }
  return counts;
}

/// The largest error at up to 64 evenly spaced times: one time alone can be right by accident.
template <class T>
ErrorPoint error_at(const AnyMethod& method, const AnyProblem& problem, const Scene& scene, long steps) {
  ErrorPoint point{steps, 0, scene.t_end / double(steps), 0};
  const long stride = std::max(1L, steps / sample_count);
  const auto start = initial_state<long double>(problem);
  const long double h = static_cast<long double>(point.dt);
  long n = 0;
  point.evaluations = step<T>(method, problem, point.dt, steps, [&](T, const T* y) {
                        if (++n % stride != 0) return true;
                        const auto exact =
                            exact_flow<long double>(problem, h * static_cast<long double>(n), start);
                        for (std::size_t i = scene.first; i < exact.size(); ++i) {
                          const double gap = double(std::abs(static_cast<long double>(y[i]) - exact[i]));
                          if (!(gap / scene.size <= point.error)) point.error = gap / scene.size;
                        }
                        return true;
                      }).evaluations;
  return point;
}

template <class T>
ErrorCurve curve(const char* method_id, const Scene& scene, const char* scalar, long finest) {
  const AnyMethod& method = method_called(method_id);
  const AnyProblem problem = problem_called(scene.problem);
  ErrorCurve curve{problem.id, method_id, scalar, {}, {}, false};
  for (const long steps : step_counts(scene.coarsest, finest, std::is_same_v<T, double>))
    curve.points.push_back(error_at<T>(method, problem, scene, steps));
  const auto best = std::min_element(curve.points.begin(), curve.points.end(),
                                     [](const auto& a, const auto& b) { return a.error < b.error; });
  curve.best = *best;
  curve.minimum_inside = std::any_of(best, curve.points.end(),
                                     [&](const ErrorPoint& p) { return p.error >= 2 * curve.best.error; });
  return curve;
}

/// Evaluations for an error, on the part of the curve where a smaller dt still gives a smaller error.
std::optional<double> cost_of(const ErrorCurve& curve, double error) {
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const ErrorPoint &coarse = curve.points[i], &fine = curve.points[i + 1];
    if (coarse.dt <= curve.best.dt) break;
    if (!(coarse.error >= error && error >= fine.error)) continue;
    const double part = std::log(coarse.error / error) / std::log(coarse.error / fine.error);
    return double(coarse.evaluations) * std::pow(double(fine.evaluations) / double(coarse.evaluations), part);
  }
  return std::nullopt;
}

bool has(const std::vector<ErrorCurve>& curves, std::string_view problem, std::string_view method) {
  return std::any_of(curves.begin(), curves.end(),
                     [&](const ErrorCurve& c) { return c.problem == problem && c.method == method; });
}

const ErrorCurve& find(const std::vector<ErrorCurve>& curves, std::string_view problem,
                       std::string_view method) {
  return *std::find_if(curves.begin(), curves.end(), [&](const ErrorCurve& c) {
    return c.problem == problem && c.method == method && c.scalar == "double";
  });
}

ClockLine clock(double dt, double duration) {
  ClockLine line{dt, duration};
  const long count = std::lround(duration / dt);
  const float step = float(dt);
  float t = 0;
  for (long n = 0; n < count; ++n) t += step;
  const double right = double(count) * dt;
  line.accumulated_error = double(t) - right;
  line.computed_error = double(float(count) * step) - right;
  float stop = 1;
  while (stop + step > stop) stop *= 2;
  line.stops_at = double(stop);
  return line;
}

}  // namespace

std::vector<ErrorCurve> error_curves() {
  struct Reach {
    const char* method;
    long in_float, in_double;
  };
  constexpr long k = 1024;
  std::vector<ErrorCurve> curves;
  for (const Scene& scene : scenes)
    for (const Reach& reach : {Reach{"explicit_euler", 4096 * k, 2048 * k}, Reach{"heun", 2048 * k, 8192 * k},
                               Reach{"rk4", 256 * k, 512 * k}}) {
      curves.push_back(curve<float>(reach.method, scene, "float", reach.in_float));
      curves.push_back(curve<double>(reach.method, scene, "double", reach.in_double));
    }
  curves.push_back(curve<double>("chapter_euler", scenes[1], "double", 2048 * k));
  return curves;
}

std::vector<ClockLine> clocks() {
  constexpr double hour = 3600;
  return {clock(1.0 / 60, hour), clock(1.0 / 60, 8 * hour), clock(0.01, hour), clock(0.001, hour),
          clock(1.0 / 64, 8 * hour)};
}

std::vector<SameStep> same_step(const std::vector<ErrorCurve>& curves) {
  std::vector<SameStep> lines;
  for (const auto& [problem, dt] : {std::pair{"drag_ship", 0.5}, std::pair{"drag_ship", 8.0},
                                    std::pair{"oscillator", 0.3125}, std::pair{"oscillator", 1.25}}) {
    SameStep line{problem, dt, {}};
    for (const char* method : {"explicit_euler", "heun", "rk4"})
      for (const ErrorPoint& p : find(curves, problem, method).points)
        if (std::abs(p.dt / dt - 1) < 1e-9) line.errors.emplace_back(method, p.error);
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<Crossover> crossovers(const std::vector<ErrorCurve>& curves) {
  std::vector<Crossover> found;
  for (const Scene& scene : scenes)
    for (const auto& [cheap, dear] : {std::pair{"explicit_euler", "heun"}, std::pair{"explicit_euler", "rk4"},
                                      std::pair{"heun", "rk4"}, std::pair{"chapter_euler", "rk4"}}) {
      if (!has(curves, scene.problem, cheap)) continue;
      const ErrorCurve &a = find(curves, scene.problem, cheap), &b = find(curves, scene.problem, dear);
      Crossover line{scene.problem, cheap, dear, {}, {}, ""};
      std::optional<double> last;  // ln of the costs' ratio at the next larger error
      constexpr double ratio = 0.98;
      for (double error = 1; error > 1e-14; error *= ratio) {
        const auto ca = cost_of(a, error), cb = cost_of(b, error);
        if (!ca || !cb) continue;
        const double now = std::log(*cb / *ca);
        if (last && (*last > 0) != (now > 0)) line.error = error, line.evaluations = *cb;
        last = now;
      }
      if (last && !line.error) line.winner = *last > 0 ? cheap : dear;
      found.push_back(std::move(line));
    }
  return found;
}

std::vector<CostLine> costs(const std::vector<ErrorCurve>& curves) {
  std::vector<CostLine> lines;
  for (const Scene& scene : scenes)
    for (const double error : {1e-1, 3e-2, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8}) {
      CostLine line{scene.problem, error, {}};
      for (const char* method : {"explicit_euler", "heun", "rk4", "chapter_euler"})
        if (has(curves, scene.problem, method))
          line.evaluations.emplace_back(method, cost_of(find(curves, scene.problem, method), error));
      lines.push_back(std::move(line));
    }
  return lines;
}

}  // namespace odemark::chapter
