// Exponential Runge-Kutta and exponential Rosenbrock methods: a linear part exactly, the rest by quadrature.
#pragma once

#include "integrators/compensated.hpp"
#include "integrators/jacobian.hpp"
#include "integrators/order_conditions.hpp"
#include "integrators/phi_functions.hpp"
#include "integrators/theory.hpp"
#include "integrators/time_derivative.hpp"

namespace odemark {

enum class LinearPart {
  of_the_problem,  // a constant L that the problem gives
  jacobian,        // df/dy and df/dt at the start of every step
};

template <const auto& method, System P>
class ExponentialStepper;

/// U_i = y + h c_i phi_1(c_i h L) f(t, y) + h sum_(0<j<i) a_ij(h L) D_j with D_j = N(t + c_j h, U_j) - N(t,
/// y) and N = f - L y; y+ likewise with b and c = 1 (M. Hochbruck, A. Ostermann, Acta Numerica 19 (2010)
/// 209-286, eq. 2.13). Only what deviates from exponential Euler is given: rows of `a`, and `b`, from column
/// 1 on. Column 0 holds what the weights of a row sum to beyond c phi_1(c z), times N(t, y): Lawson's methods
/// only. With the Jacobian as L the time derivative v enters as h^2 c^2 phi_2(c h L) v, and D_j loses c_j h
/// v.
template <std::size_t Stages, LinearPart Part = LinearPart::of_the_problem>
struct ExponentialRungeKutta {
  static constexpr std::string_view kind_name = "exponential";
  static constexpr unsigned needs =
      Ability::moderate_size | (Part == LinearPart::of_the_problem ? unsigned(Ability::linear_part) : 0);
  static constexpr bool compiled_apart = true;  // its matrix functions: for real numbers only
  static constexpr std::size_t stages = Stages;
  static constexpr bool from_jacobian = Part == LinearPart::jacobian;

  std::string_view id, source, advice;
  std::string_view note = "";
  int order;
  int embedded_order = 0;
  bool jumps_over_poles = false;  // see AnyMethod
  std::array<Coefficient, Stages> c{};
  std::array<std::array<PhiSum, Stages>, Stages> a{};
  std::array<PhiSum, Stages> b{}, b_embedded{};

  Theory theory() const {
    Theory theory;
    theory.exact_on_linear_part = true;
    return theory;
  }

  /// Sums by row and column: rows 0 .. Stages - 1 are the stages, row 0 being the new state and row Stages
  /// the error estimate; columns are those of `a`, then that of f, then that of v.
  static constexpr std::size_t columns = Stages + 2;
  using Sums = std::array<PhiSum, (Stages + 1) * columns>;
  constexpr Sums sums() const {
    Sums out{};
    for (std::size_t row = 0; row < Stages; ++row) {
      const Coefficient node = row == 0 ? 1 : c[row];
      for (std::size_t j = 0; j < Stages; ++j) out[row * columns + j] = row == 0 ? b[j] : a[row][j];
      out[row * columns + Stages] = node * phi(1, node);
      if (from_jacobian) out[row * columns + Stages + 1] = node * node * phi(2, node);
    }
    if (embedded_order > 0)
      for (std::size_t j = 0; j < Stages; ++j) out[Stages * columns + j] = b[j] - b_embedded[j];
    return out;
  }

  template <const auto& method, System P>
  requires(from_jacobian || HasLinearPart<P>)  //
      using Stepper = ExponentialStepper<method, P>;
};

/// What can be told from coefficients alone. With L of the problem: setting L = 0 leaves a Runge-Kutta
/// tableau of the claimed order. With the Jacobian: sum_j b_j c_j^(q-1) = (q-1)! phi_q for q = 3 .. order,
/// and up to order 4 nothing else is needed (Hochbruck, Ostermann & Schweitzer, SIAM J. Numer. Anal. 47
/// (2009), section 3).
template <std::size_t S, LinearPart Part>
constexpr bool orders_hold(const ExponentialRungeKutta<S, Part>& m) {
  if constexpr (Part == LinearPart::of_the_problem) {
    std::array<std::array<Coefficient, S>, S> a{};
    std::array<Coefficient, S> b{};
    for (std::size_t i = 0; i < S; ++i) {
      a[i][0] = m.c[i] + m.a[i][0].at_zero();
      for (std::size_t j = 1; j < S; ++j)
        a[i][j] = m.a[i][j].at_zero(), a[i][0] -= a[i][j], b[j] = m.b[j].at_zero();
    }
    b[0] = 1 + m.b[0].at_zero();
    for (std::size_t j = 1; j < S; ++j) b[0] -= b[j];
    return algebraic_order(a, b, m.order + 1) == m.order;
  } else {
    const auto holds_to = [&](const std::array<PhiSum, S>& b, int order) {
      Coefficient factorial = 1;
      for (int q = 3; q <= order; ++q) {
        factorial *= Coefficient(q - 1);
        PhiSum sum = -factorial * phi(q);
        for (std::size_t j = 1; j < S; ++j) {
          Coefficient power = 1;
          for (int k = 1; k < q; ++k) power *= m.c[j];
          sum = sum + power * b[j];
        }
        if (!sum.is_zero()) return false;
      }
      return true;
    };
    return holds_to(m.b, m.order) && !holds_to(m.b, m.order + 1) &&
           (m.embedded_order == 0 ||
            (holds_to(m.b_embedded, m.embedded_order) && !holds_to(m.b_embedded, m.embedded_order + 1)));
  }
}

template <const auto& method, System P>
class ExponentialStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  ExponentialStepper(const P& system, const State& model)
      : system_(system),
        autonomous_(is_autonomous(system)),
        weights_(size_of(model), sums_.data(), sums_.size()),
        slope_(model),
        time_derivative_(zeros_like(model)),
        stage_(model),
        increment_(model),
        nonlinear_(model) {
    deviations_.fill(model);
    if constexpr (!method.from_jacobian)
      system.linear_part(MatrixView<Real>{weights_.matrix(), size_of(model)});
  }

  void start() { linearized_ = false; }
  void accept() { linearized_ = false; }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    take_increment(t, y, h);
    for_each_component(y, [&](std::size_t i) { next.data()[i] = y.data()[i] + increment_.data()[i]; });
    if constexpr (method.embedded_order > 0) {
      for_each_component(y, [&](std::size_t i) { error.data()[i] = Real(0); });
      add_deviations<method.stages, method.stages>(error);
    }
    return StepStatus::ok;
  }
  StepStatus attempt_compensated(Real t, const State& y, const State& carry, Real h, State& next,
                                 State& next_carry) {
    take_increment(t, y, h);
    add_compensated(y, carry, increment_, next, next_carry);
    return StepStatus::ok;
  }

 private:
  static constexpr typename KindOf<method>::Sums sums_ = method.sums();

  template <std::size_t Row, std::size_t Column>
  void add(const State& in, State& out) const {
    constexpr std::size_t which = Row * KindOf<method>::columns + Column;
    if constexpr (!sums_[which].is_zero()) weights_.add_product(which, in.data(), out.data());
  }
  /// out += h sum_j a_ij D_j for 0 < j < Before.
  template <std::size_t Row, std::size_t Before>
  void add_deviations(State& out) const {
    [&]<std::size_t... J>(std::index_sequence<J...>) { (add<Row, J + 1>(deviations_[J + 1], out), ...); }
    (std::make_index_sequence<Before - 1>{});
  }

  void take_increment(Real t, const State& y, Real h) {
    if (!linearized_) linearize(t, y, h);
    linearized_ = true;
    if (!(h == prepared_)) weights_.prepare(prepared_ = h);  // with a constant L once per run of equal steps
    [&]<std::size_t... I>(std::index_sequence<I...>) { (evaluate_stage<I + 1>(t, y, h), ...); }
    (std::make_index_sequence<method.stages - 1>{});
    find_increment<0, method.stages>(h);
  }

  void linearize(Real t, const State& y, Real h) {
    system_.rhs(t, y, slope_);
    if constexpr (method.from_jacobian) {
      evaluate_jacobian(system_, t, y, MatrixView<Real>{weights_.matrix(), size_of(y)}, stage_, increment_,
                        nonlinear_);
      if (!autonomous_) evaluate_time_derivative(system_, t, h, y, slope_, time_derivative_);
      prepared_ = std::numeric_limits<Real>::quiet_NaN();
    } else if constexpr (!method.b[0].is_zero()) {
      nonlinear_ = slope_;
      weights_.subtract_linear(y.data(), nonlinear_.data());
    }
  }

  template <std::size_t Row, std::size_t Before>
  void find_increment(Real h) {
    for_each_component(increment_, [&](std::size_t i) { increment_.data()[i] = Real(0); });
    add<Row, method.stages>(slope_, increment_);
    if constexpr (method.from_jacobian)
      if (!autonomous_) {
        for_each_component(stage_, [&](std::size_t i) { stage_.data()[i] = h * time_derivative_.data()[i]; });
        add<Row, method.stages + 1>(stage_, increment_);
      }
    add<Row, 0>(nonlinear_, increment_);
    add_deviations<Row, Before>(increment_);
  }

  template <std::size_t I>
  void evaluate_stage(Real t, const State& y, Real h) {
    find_increment<I, I>(h);
    for_each_component(y, [&](std::size_t i) { stage_.data()[i] = y.data()[i] + increment_.data()[i]; });
    const Real lapse = static_cast<Real>(method.c[I]) * h;
    State& deviation = deviations_[I];
    system_.rhs(t + lapse, stage_, deviation);
    for_each_component(y, [&](std::size_t i) { deviation.data()[i] -= slope_.data()[i]; });
    if constexpr (method.from_jacobian)
      if (!autonomous_)
        for_each_component(y,
                           [&](std::size_t i) { deviation.data()[i] -= lapse * time_derivative_.data()[i]; });
    weights_.subtract_linear(increment_.data(), deviation.data());
  }

  const P& system_;
  bool autonomous_;
  PhiWeights<Real> weights_;
  State slope_, time_derivative_, stage_, increment_, nonlinear_;  // nonlinear_: N(t, y)
  std::array<State, method.stages> deviations_{};
  Real prepared_ = std::numeric_limits<Real>::quiet_NaN();
  bool linearized_ = false;
};

}  // namespace odemark
