// Names and looks on the chapter page, and finding one measurement among many.
#include "reports/chapter_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "reports/format.hpp"
#include "reports/palette.hpp"

namespace odemark::chapter_layout {

namespace {

struct Name {
  std::string_view id, name;
};
constexpr std::array method_names{Name{"explicit_euler", "Euler"},
                                  Name{"heun", "improved Euler"},
                                  Name{"rk4", "Runge–Kutta 4"},
                                  Name{"chapter_euler", "Euler as listed"},
                                  Name{"chapter_adaptive_euler", "adaptive listing"},
                                  Name{"step_doubling_euler", "correct controller"},
                                  Name{"exact", "exact"}};
constexpr std::array problem_names{Name{"drag_ship", "ship"},
                                   Name{"drag_ship{v0=20}", "ship at its limiting speed"},
                                   Name{"drag_ship_quadratic{t_reverse=1e9}", "ship, quadratic drag"},
                                   Name{"drag_ship_quadratic{t_reverse=60.12}", "thrust reversed at 60.12 s"},
                                   Name{"drag_ship_quadratic{t_reverse=60.3}", "thrust reversed at 60.3 s"},
                                   Name{"oscillator", "undamped spring"},
                                   Name{"damped_spring{zeta=0.01}", "spring, ζ = 0.01"},
                                   Name{"damped_spring{zeta=0.1}", "spring, ζ = 0.1"},
                                   Name{"damped_spring{zeta=1}", "spring, ζ = 1"}};

template <std::size_t N>
std::string name_in(const std::array<Name, N>& names, std::string_view id) {
  for (const Name& name : names)
    if (name.id == id) return std::string(name.name);
  return std::string(id);
}

template <class Lines, class Test>
const auto& find(const Lines& lines, const char* what, Test&& test) {
  const auto found = std::find_if(lines.begin(), lines.end(), test);
  if (found == lines.end()) throw std::invalid_argument(fmt::format("the chapter page lacks {}", what));
  return *found;
}

bool same(double a, double b) { return std::abs(a / b - 1) < 1e-9; }

}  // namespace

std::string method_name(std::string_view id) { return name_in(method_names, id); }

std::string problem_name(std::string_view id) {
  if (id.substr(0, 16) == "oscillator{omega") return "undamped 5 Hz spring";
  return name_in(problem_names, id);
}

std::string answer_text(Answer answer) {
  switch (answer) {
    case Answer::holds: return "true";
    case Answer::holds_with_limits: return "true with limits";
    case Answer::does_not_hold: return "false";
  }
  return "";
}

Status answer_status(Answer answer) {
  switch (answer) {
    case Answer::holds: return Status::ok;
    case Answer::holds_with_limits: return Status::warn;
    case Answer::does_not_hold: return Status::fail;
  }
  return Status::plain;
}

std::string behaviour_text(Behaviour behaviour) {
  switch (behaviour) {
    case Behaviour::settles: return "settles";
    case Behaviour::overshoots_and_settles: return "overshoots, settles";
    case Behaviour::oscillates_for_ever: return "oscillates for ever";
    case Behaviour::grows: return "grows without limit";
  }
  return "";
}

Style look(std::string_view method) {
  static const Palette palette({{"heun", "a"},
                                {"explicit_euler", "b"},
                                {"rk4", "c"},
                                {"chapter_euler", "d"},
                                {"exact", "e"},
                                {"chapter_adaptive_euler", "f"},
                                {"step_doubling_euler", "g"}});
  Style style = palette.style_of(method);
  if (method == "exact") style.marker = Marker::none;
  return style;
}

Series series_of(const Trajectory& curve) {
  Series series{curve.method, method_name(curve.method), "", {}, look(curve.method)};
  for (std::size_t i = 0; i < curve.t.size(); ++i) series.points.push_back({curve.t[i], curve.value[i]});
  constexpr std::size_t crowded = 60;
  if (series.points.size() > crowded) {
    series.style.marker = Marker::none;
    if (curve.method == "exact") series.style.line = Line::dotted;
    if (curve.method == "rk4") series.style.line = Line::dashed;
  }
  return series;
}

std::string long_time(double seconds) {
  constexpr double hour = 3600, day = 24 * hour, year = 365.25 * day;
  if (seconds < hour) return duration(seconds);
  if (seconds < 2 * day) return significant(seconds / hour, 3) + " h";
  if (seconds < 2 * year) return significant(seconds / day, 3) + " days";
  return significant(seconds / year, 3) + " years";
}

Cell words(std::string text, Status status) { return {std::move(text), status}; }

Cell digits(double x, int significant_digits) { return number_cell(x, compact(x, significant_digits)); }

Cell digits_or(const std::optional<double>& x, int significant_digits, std::string_view otherwise) {
  return x ? digits(*x, significant_digits) : words(std::string(otherwise), Status::muted);
}

const LimitLine& limit_of(const ChapterData& data, std::string_view problem, std::string_view method) {
  return find(data.limits, "a limit",
              [&](const LimitLine& line) { return line.problem == problem && line.method == method; });
}

const GrowthPoint& growth_of(const ChapterData& data, std::string_view method, double per_second) {
  return find(data.growth, "a growth rate", [&](const GrowthPoint& point) {
    return point.method == method && same(point.dt, 1 / per_second);
  });
}

const ErrorCurve& error_of(const ChapterData& data, std::string_view problem, std::string_view method,
                           std::string_view scalar) {
  return find(data.errors, "an error curve", [&](const ErrorCurve& curve) {
    return curve.problem == problem && curve.method == method && curve.scalar == scalar;
  });
}

const DoublingLine& doubling_of(const ChapterData& data, double z) {
  return find(data.doublings, "a doubling time", [&](const DoublingLine& line) { return same(line.z, z); });
}

const AdaptiveRun& adaptive_of(const ChapterData& data, std::string_view problem, std::string_view method,
                               double tolerance) {
  return find(data.adaptive, "an adaptive run", [&](const AdaptiveRun& run) {
    return run.problem.substr(0, problem.size()) == problem && run.method == method &&
           same(run.tolerance, tolerance);
  });
}

const Crossover& crossover_of(const ChapterData& data, std::string_view problem, std::string_view cheap,
                              std::string_view dear) {
  return find(data.crossovers, "a crossover", [&](const Crossover& line) {
    return line.problem == problem && line.cheap == cheap && line.dear == dear;
  });
}

}  // namespace odemark::chapter_layout
