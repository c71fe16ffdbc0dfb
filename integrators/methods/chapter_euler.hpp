#pragma once
#include "integrators/step_function.hpp"

namespace odemark {

namespace detail {
struct ChapterEuler {
  /// F, then A = F / m, then the new speed from the old state, then the position with the new speed.
  template <SecondOrderSystem P, class Real, class Y>
  void operator()(const P& problem, Real t, Y& y, Real h, Y& a) const {
    const std::size_t half = size_of(y) / 2;
    problem.acceleration(t, y, a.data());
    for (std::size_t i = 0; i < half; ++i) {
      const Real v_new = y.data()[half + i] + a.data()[i] * h;
      y.data()[i] = y.data()[i] + v_new * h;
      y.data()[half + i] = v_new;
    }
  }
};
}  // namespace detail

inline constexpr StepFunction<detail::ChapterEuler, Ability::second_order> chapter_euler{
    .id = "chapter_euler",
    .source = "the source chapter's first listing, as printed",
    .order = 1,
    .embedded_order = 0,
    .step = {},
    .moves =
        [] {
          using What = SecondOrderMove::What;
          return std::vector<SecondOrderMove>{{What::kick, 1}, {What::drift, 1}};
        },
};

}  // namespace odemark
