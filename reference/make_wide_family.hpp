// Instantiates a family on wide numbers: right-hand side, tape, Jacobian, closed form, invariants.
#pragma once

#include "reference/make_family.hpp"
#include "reference/wide_problem.hpp"

namespace odemark {

/// "0.1" or "8/3" at full width; the text was checked by parse_number before.
inline Wide parse_wide(std::string_view, std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == text.npos) return Wide(std::string(text));
  return Wide(std::string(text.substr(0, slash))) / Wide(std::string(text.substr(slash + 1)));
}

template <class F>
WideProblem make_wide_problem(std::shared_ptr<const F> values) {
  WideProblem problem;
  const std::size_t size = size_of_family(*values);
  problem.size = size;
  problem.t_end = Wide(values->t_end);
  problem.initial.resize(size);
  problem.rhs = [](const void* p, const Wide& t, const Wide* y, Wide* dydt) {
    static_cast<const F*>(p)->rhs(t, y, dydt);
  };
  problem.jacobian = [](const void* p, const Wide& t, const Wide* y, Wide* column_major) {
    const F& self = *static_cast<const F*>(p);
    dual_jacobian(self, t, y, MatrixView<Wide>{column_major, size_of_family(self)});
  };
  if constexpr (requires(const Wide& t, Wide* y) { values->exact(t, y, y); })
    problem.exact = [](const void* p, const Wide& t, const Wide* y0, Wide* y) {
      static_cast<const F*>(p)->exact(t, y0, y);
    };
  if constexpr (requires { F::invariant_names; })
    problem.invariants = [](const void* p, const Wide* y, Wide* out) {
      static_cast<const F*>(p)->invariants(y, out);
    };
  if constexpr (HasSwitches<F>)
    for (const auto& t : values->switch_times()) problem.switch_times.emplace_back(t);
  for (const F& phase : phases_of(*values)) {
    const auto held = std::make_shared<const F>(phase);
    problem.phases.push_back({held, record<Wide>(*held, size)});
  }
  if (problem.phases.empty()) problem.phases.push_back({values, record<Wide>(*values, size)});
  if constexpr (HasEvents<F>) {
    problem.events.count = F::events.size();
    problem.events.look_every = Wide(values->suggested_dt());
    problem.events.values = [](const void* p, const Wide& t, const Wide* y, Wide* g) {
      static_cast<const F*>(p)->event_values(t, y, g);
    };
    if constexpr (requires(const Wide& t, Wide* y) { values->exact(t, y, y); })
      problem.exact_events = [](const void* p, const Wide& t, const Wide* y0, std::vector<WideEvent>& found) {
        std::vector<Wide> y(size_of_family(*static_cast<const F*>(p)));
        static_cast<const F*>(p)->exact(t, y0, y.data(), [&](std::size_t event, const Wide& at) {
          found.push_back({event, 0, at});
        });
      };
  }
  if constexpr (HasJumps<F>) {
    problem.events.jumps = true;
    problem.events.after = [](const void* p, std::size_t event, const Wide& t, Wide* y, std::size_t phase) {
      const F& now = *static_cast<const F*>(p);
      if constexpr (std::is_void_v<decltype(now.after_event(event, t, y))>)
        now.after_event(event, t, y);
      else
        phase = now.after_event(event, t, y);
      return phase;
    };
  }
  problem.value = values;
  return problem;
}

template <template <class> class Family>
WideFamily make_wide_family() {
  WideFamily family;
  family.id = Family<double>::id;
  family.rounded = [](const AnyProblem& problem) {
    auto wide = make_wide_problem(
        std::make_shared<const Family<double>>(*static_cast<const Family<double>*>(problem.value.get())));
    for (std::size_t i = 0; i < wide.size; ++i) wide.initial[i] = Wide(problem.initial[i]);
    return wide;
  };
  family.as_written = [](const AnyProblem& problem) {
    const auto preset = parse_settings(problem.preset_settings);
    const auto user = parse_settings(problem.user_settings);
    const auto values =
        std::make_shared<const Family<Wide>>(configure<Family<Wide>, Wide>(preset, user, parse_wide));
    auto wide = make_wide_problem(values);
    values->initial(wide.initial.data());
    return wide;
  };
  using F = Family<double>;
  if constexpr (requires(const F& f, const Wide& t, Wide* y) { f.exact_at(t, {}, y); })
    family.sampled = [](const AnyProblem& problem, const Wide& t, const std::vector<std::size_t>& places) {
      const F& values = *static_cast<const F*>(problem.value.get());
      SampledSolution out{std::vector<Wide>(places.size()), {}, {}};
      values.exact_at(t, places, out.y.data());
      for (const std::size_t place : places)
        out.spread.push_back(values.spread(place)), out.reach.push_back(values.reach(place));
      return out;
    };
  return family;
}

}  // namespace odemark
