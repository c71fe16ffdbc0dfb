// Methods with the faults people really make, beside their right versions; all enter through the public door.
#pragma once

#include "integrators/erase_method.hpp"
#include "integrators/explicit_runge_kutta.hpp"
#include "integrators/methods/adams_bashforth3.hpp"
#include "integrators/methods/adams_bashforth_moulton33.hpp"
#include "integrators/methods/bdf3.hpp"
#include "integrators/methods/explicit_euler.hpp"
#include "integrators/methods/implicit_euler.hpp"
#include "integrators/methods/pefrl.hpp"
#include "integrators/step_function.hpp"

namespace odemark::planted {

/// k3 is taken at 0.49 of the step instead of one half: what orders_hold() would not let compile.
inline constexpr ExplicitRungeKutta<4> rk4_wrong_coefficient{
    .id = "rk4_wrong_coefficient",
    .source = "planted",
    .order = 4,
    .a = {{{}, {1.0L / 2}, {0, 0.49L}, {0, 0, 1}}},
    .b = {1.0L / 6, 1.0L / 3, 1.0L / 3, 1.0L / 6},
};

/// One digit of a drift is wrong: still symmetric and consistent, so of order 2. What orders_hold() would not
/// let compile.
inline constexpr Splitting<5> pefrl_wrong_digit{
    .id = "pefrl_wrong_digit",
    .source = "planted",
    .order = 4,
    .drift = mirrored<5, 5>(
        std::array<Coefficient, 2>{0.178617895844809067059903767081L, -0.0692645826698184962780156217646L}),
    .kick = pefrl.kick,
};
static_assert(!orders_hold(pefrl_wrong_digit));

/// The outer weights in integers: 1 / 6 is 0, and what is left moves at two thirds of the speed.
inline constexpr ExplicitRungeKutta<4> rk4_integer_division{
    .id = "rk4_integer_division",
    .source = "planted",
    .order = 4,
    .a = {{{}, {1.0L / 2}, {0, 1.0L / 2}, {0, 0, 1}}},
    .b = {1 / 6, 1.0L / 3, 1.0L / 3, 1 / 6},
};

/// Half a step with one slope, half with another; which ones makes the difference.
enum class Average { now_and_before, now_and_next };

template <Average average>
struct Averaging {
  template <System P, class Real, class Y>
  void operator()(const P& problem, Real t, Y& y, Real h) const {
    Y now = y, other = y, moved = y;
    problem.rhs(t, y, now);
    if constexpr (average == Average::now_and_before) {
      // "the average of the last two slopes": centred half a step too early, so of order one
      for (std::size_t i = 0; i < size_of(y); ++i) moved.data()[i] = y.data()[i] - h * now.data()[i];
      problem.rhs(t - h, moved, other);
    } else {
      for (std::size_t i = 0; i < size_of(y); ++i) moved.data()[i] = y.data()[i] + h * now.data()[i];
      problem.rhs(t + h, moved, other);
    }
    for (std::size_t i = 0; i < size_of(y); ++i)
      y.data()[i] = y.data()[i] + h / 2 * (now.data()[i] + other.data()[i]);
  }
};
inline constexpr auto trapezoid_of_old_slopes =
    wrap_step("trapezoid_of_old_slopes", 2, Averaging<Average::now_and_before>{}, "planted");
inline constexpr auto trapezoid_of_new_slopes =
    wrap_step("trapezoid_of_new_slopes", 2, Averaging<Average::now_and_next>{}, "the right version");

template <const auto& method, System P>
class CopiedStartStepper;

/// Adams-Bashforth 3 whose history is filled with copies of f(0) instead of being built by steps of order 3.
struct CopiedStart {
  static constexpr std::string_view kind_name = "explicit multistep";
  static constexpr unsigned needs = 0;
  std::string_view id, source;
  int order, embedded_order = 0;
  Theory theory() const { return adams_bashforth3.theory(); }

  template <const auto& method, System P>
  using Stepper = CopiedStartStepper<method, P>;
};

template <const auto& method, System P>
class CopiedStartStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;
  CopiedStartStepper(const P& system, const State& model)
      : system_(system), steps_(system, model), slope_(model), empty_(true) {}

  void start() { steps_.start(), empty_ = true; }
  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    if (empty_) {
      system_.rhs(t, y, slope_);
      steps_.assume_history();
      for (std::size_t k = 0; k < steps_.history_length(); ++k) steps_.history(k) = slope_;
      empty_ = false;
    }
    return steps_.attempt(t, y, h, next, error);
  }
  void accept() { steps_.accept(); }

 private:
  const P& system_;
  StepperOf<adams_bashforth3, P> steps_;
  State slope_;
  bool empty_;
};

/// The right formulas behind a starter of too low an order: what multistep_holds() would not let compile.
inline constexpr ExplicitMultistep<3, explicit_euler> adams_bashforth_poor_start{
    .id = "adams_bashforth_poor_start",
    .source = "planted",
    .order = 3,
    .formula = adams_bashforth3.formula,
};
inline constexpr PredictorCorrector<3, explicit_euler> adams_bashforth_moulton_poor_start{
    .id = "adams_bashforth_moulton_poor_start",
    .source = "planted",
    .order = 3,
    .predictor = adams_bashforth_moulton33.predictor,
    .corrector = adams_bashforth_moulton33.corrector,
};
inline constexpr ImplicitMultistep<3, implicit_euler> bdf_poor_start{
    .id = "bdf_poor_start",
    .source = "planted",
    .order = 3,
    .formula = bdf3.formula,
};
static_assert(!multistep_holds(adams_bashforth_poor_start) &&
              !multistep_holds(adams_bashforth_moulton_poor_start) && !multistep_holds(bdf_poor_start));

inline constexpr CopiedStart adams_copied_start{.id = "adams_copied_start", .source = "planted", .order = 3};

}  // namespace odemark::planted
