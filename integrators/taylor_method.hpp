// The Taylor-series method of a chosen order: the chapter's own derivation of Euler, carried on.
#pragma once

#include "integrators/compensated.hpp"
#include "integrators/taylor_series.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, System P>
class NamedTaylorStepper;

template <class P>
concept RecordableSystem = System<P> && requires(const P& p) {
  p.tape();
  p.count_series();
};

/// y+ = sum_k y^(k) h^k / k!, derivatives by automatic differentiation of the same right-hand side (R.
/// Barrio, Appl. Math. Comput. 163 (2005) 525-545). The last term is the error estimate.
struct Taylor {
  static constexpr std::string_view kind_name = "Taylor series";
  static constexpr unsigned needs = Ability::recordable;

  std::string_view id, source;
  int order;
  int embedded_order;

  /// R(z) is the exponential series cut after z^order.
  Theory theory() const {
    Theory theory;
    theory.denominator = {1};
    Coefficient term = 1;
    for (int k = 0; k <= order; ++k) {
      theory.numerator.push_back(term);
      term /= Coefficient(k + 1);
    }
    return theory;
  }

  template <const auto& method, RecordableSystem P>
  using Stepper = NamedTaylorStepper<method, P>;
};

/// The order is a run-time number: one engine serves all twenty methods.
template <System P>
class TaylorStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  TaylorStepper(const P& system, const State& model, int order)
      : system_(system),
        tape_(system.tape()),
        order_(order),
        series_(tape_, size_of(model), order),
        increment_(model) {}
  TaylorStepper(const TaylorStepper&) = delete;
  TaylorStepper& operator=(const TaylorStepper&) = delete;

  void start() { known_ = false; }
  void accept() { known_ = false; }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    expand(t, y);
    for_each_component(y, [&](std::size_t i) {
      next.data()[i] = y.data()[i] + sum_from_first(i, h);
      Real last = series_.coefficient(i, order_);
      for (int k = 0; k < order_; ++k) last *= h;
      error.data()[i] = last;
    });
    return StepStatus::ok;
  }
  StepStatus attempt_compensated(Real t, const State& y, const State& carry, Real h, State& next,
                                 State& next_carry) {
    expand(t, y);
    for_each_component(y, [&](std::size_t i) { increment_.data()[i] = sum_from_first(i, h); });
    add_compensated(y, carry, increment_, next, next_carry);
    return StepStatus::ok;
  }

 private:
  void expand(Real t, const State& y) {
    if (known_) return;  // a rejected attempt: the same series, a shorter step
    series_.expand(t, y.data(), order_);
    system_.count_series();
    known_ = true;
  }
  /// sum_{k>=1} c_k h^k by Horner: the large y is added last.
  Real sum_from_first(std::size_t i, Real h) const {
    Real sum = series_.coefficient(i, order_);
    for (int k = order_ - 1; k >= 1; --k) sum = sum * h + series_.coefficient(i, k);
    return sum * h;
  }

  const P& system_;
  const Tape<Real> tape_;
  int order_;
  TaylorSeries<Real> series_;
  State increment_;
  bool known_ = false;
};

template <const auto& method, System P>
class NamedTaylorStepper : public TaylorStepper<P> {
 public:
  using Engine = TaylorStepper<P>;
  NamedTaylorStepper(const P& system, const typename P::State& model) : Engine(system, model, method.order) {}
};

}  // namespace odemark
