#pragma once
#include "integrators/step_function.hpp"

namespace odemark {

namespace detail {
struct Suvat {
  template <SecondOrderSystem P, class Real, class Y>
  void operator()(const P& problem, Real t, Y& y, Real h, Y& a) const {
    const std::size_t half = size_of(y) / 2;
    problem.acceleration(t, y, a.data());
    for (std::size_t i = 0; i < half; ++i) {
      const Real v = y.data()[half + i], gain = h * a.data()[i];
      y.data()[i] = y.data()[i] + h * (v + gain / Real(2));
      y.data()[half + i] = v + gain;
    }
  }
};
}  // namespace detail

inline constexpr StepFunction<detail::Suvat, Ability::second_order> suvat{
    .id = "suvat",
    .source =
        "VDrift documentation, Numerical Integration; G. Fiedler, Integration Basics, gafferongames.com, "
        "2004 "
        "(x += v dt + a dt^2/2, v += a dt)",
    .order = 1,
    .embedded_order = 0,
    .step = {},
    .moves =
        [] {
          using What = SecondOrderMove::What;
          return std::vector<SecondOrderMove>{{What::kick, 0.5L}, {What::drift, 1}, {What::kick_start, 0.5L}};
        },
    .advice = "projectiles under constant forces, exact there; not for springs: it gains energy at every dt",
};

}  // namespace odemark
