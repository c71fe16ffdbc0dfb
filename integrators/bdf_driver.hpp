// Runs a BDF of variable order: quasi-constant steps in backward differences, simplified Newton, order
// selection.
#pragma once

#include "integrators/bdf_formulas.hpp"
#include "integrators/integrate.hpp"
#include "integrators/jacobian.hpp"
#include "integrators/shifted_lu.hpp"

namespace odemark {

/// L. F. Shampine, M. W. Reichelt, SIAM J. Sci. Comput. 18 (1997) 1-22.
template <System P>
class BdfDriver {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  BdfDriver(const P& system, const BdfFormulas& formulas, const ErrorControl& control, const State& model)
      : system_(system),
        formulas_(formulas),
        control_(control),
        size_(size_of(model)),
        predicted_(model),
        known_(model),
        distance_(model),
        correction_(model),
        next_(model),
        scratch_(model),
        jacobian_(jacobian_shape(system, model)),
        lu_(jacobian_.shape()) {
    differences_.fill(zeros_like(model));
    // a looser solve costs rejections on relaxation oscillations, a tighter one evaluations everywhere
    const double tolerance = control.relative_tolerance + control.absolute_tolerance;
    newton_tolerance_ = std::max(10 * double(std::numeric_limits<Real>::epsilon()) / tolerance, 0.003);
  }

  template <class Observer>
  RunReport run(double t0, double t1, State& y, Observer& observe) {
    RunReport report;
    t_ = Real(t0);
    const auto stop = [&](RunStatus status) {
      report.status = status, report.t_reached = double(t_), report.newton = counts_;
      return report;
    };
    begin(t0, t1, y);
    bool newton_failed = false;
    while (t_ < Real(t1)) {
      if (report.accepted + report.rejected >= control_.step_limit) return stop(RunStatus::step_limit);
      if (!(h_ > std::numeric_limits<Real>::epsilon() * std::abs(t_)) ||
          !(h_ > std::numeric_limits<Real>::min())) {
        if (!all_finite(y)) return stop(RunStatus::not_finite);
        return stop(newton_failed ? RunStatus::newton_diverged : RunStatus::step_underflow);
      }
      const bool last = t_ + h_ * Real(1.0001) >= Real(t1);
      if (last) resize((Real(t1) - t_) / h_);
      newton_failed = !solve(last ? Real(t1) : t_ + h_);
      if (newton_failed) {
        ++report.rejected;
        resize(Real(0.25));
        continue;
      }
      const double error = scaled_norm(distance_, formulas_.error_constant(order_));
      if (!(error <= 1)) {
        ++report.rejected;
        const double wished = control_.safety * std::pow(error, -1 / double(order_ + 1));
        resize(Real(wished > control_.smallest_factor ? std::min(wished, 0.9) : control_.smallest_factor));
        continue;
      }
      const Real t_next = last ? Real(t1) : t_ + h_;
      push();
      ++report.accepted;
      const bool go_on = observe(t_, y, t_next, next_);
      y = next_;
      t_ = t_next;
      if (!go_on) return stop(RunStatus::time_limit);
      if (++equal_steps_ > order_) choose_order(error);
    }
    return stop(all_finite(y) ? RunStatus::reached_end : RunStatus::not_finite);
  }

 private:
  static constexpr std::size_t highest = BdfFormulas::highest_order;
  static constexpr int most_iterations = 4;

  /// Order 1; a step such that h^2 y'' / 2, with the time derivative of f left out, is within tolerance.
  void begin(double t0, double t1, const State& y) {
    order_ = 1, equal_steps_ = 0;
    double h = first_step(system_, control_, 2, t0, t1, y);
    predicted_ = next_ = y;
    system_.rhs(t_, y, correction_);
    refresh_jacobian(t_, y);
    jacobian_.multiply(correction_.data(), scratch_.data());
    if (control_.first_step <= 0) {
      const double bend = scaled_norm(scratch_, 0.5L);
      const double bent = 0.5 / std::sqrt(bend);
      if (bent < h) h = bent;
    }
    h_ = Real(h);
    for_each_component(y, [&](std::size_t i) {
      differences_[0].data()[i] = y.data()[i];
      differences_[1].data()[i] = h_ * correction_.data()[i];
    });
  }

  void refresh_jacobian(Real t, const State& at) {
    evaluate_jacobian(system_, t, at, jacobian_, scratch_, distance_, next_);
    jacobian_fresh_ = true, factored_ = false;
  }

  /// Tolerance is met where this is at most 1; NaN stays NaN.
  double scaled_norm(const State& x, Coefficient factor) const {
    double sum = 0;
    for_each_component(x, [&](std::size_t i) {
      const double before = std::abs(double(predicted_.data()[i])), after = std::abs(double(next_.data()[i]));
      const double ratio = double(x.data()[i]) / error_weight(control_, i, before > after ? before : after);
      sum += ratio * ratio;
    });
    return std::abs(double(factor)) * std::sqrt(sum / double(size_));
  }

  /// The state at t, into next_, and its distance from the prediction; once more with a Jacobian of here
  /// where an old one does not serve.
  bool solve(Real t) {
    const Real leading = static_cast<Real>(formulas_.leading(order_));
    for_each_component(predicted_, [&](std::size_t i) {
      Real sum = 0, slope = 0;
      for (std::size_t j = order_; j > 0; --j) {
        sum += differences_[j].data()[i];
        slope += static_cast<Real>(BdfFormulas::gamma(j)) * differences_[j].data()[i];
      }
      predicted_.data()[i] = differences_[0].data()[i] + sum;
      known_.data()[i] = slope / leading;
    });
    while (true) {
      if (iterate(t, h_ / leading)) return true;
      if (jacobian_fresh_) return false;
      refresh_jacobian(t, predicted_);
    }
  }

  bool iterate(Real t, Real diagonal) {
    if (!factored_) {
      lu_.factorize_step(jacobian_, diagonal);
      ++counts_.lu;
      factored_ = true, rate_ = 1;
    }
    next_ = predicted_;
    for_each_component(next_, [&](std::size_t i) { distance_.data()[i] = 0; });
    double previous = 0;
    for (int iteration = 1; iteration <= most_iterations; ++iteration) {
      system_.rhs(t, next_, correction_);
      for_each_component(next_, [&](std::size_t i) {
        correction_.data()[i] = diagonal * correction_.data()[i] - known_.data()[i] - distance_.data()[i];
      });
      lu_.solve_in_place(correction_.data());
      ++counts_.newton;
      const double moved = scaled_norm(correction_, 1);
      if (!std::isfinite(moved)) return false;
      for_each_component(next_, [&](std::size_t i) {
        distance_.data()[i] += correction_.data()[i];
        next_.data()[i] = predicted_.data()[i] + distance_.data()[i];
      });
      if (moved == 0) return true;
      if (previous > 0) {
        rate_ = std::max(0.3 * rate_, moved / previous);
        if (rate_ >= 1) return false;
      }
      const double left = rate_ < 1 ? moved * rate_ / (1 - rate_) : moved;
      if (left <= newton_tolerance_) return true;
      if (previous > 0 && left * std::pow(rate_, most_iterations - iteration - 1) > newton_tolerance_)
        return false;
      previous = moved;
    }
    return false;
  }

  /// The step was accepted: differences of the new state.
  void push() {
    for_each_component(next_, [&](std::size_t i) {
      const Real d = distance_.data()[i];
      differences_[order_ + 2].data()[i] = d - differences_[order_ + 1].data()[i];
      differences_[order_ + 1].data()[i] = d;
      Real sum = d;
      for (std::size_t j = order_; j > 0; --j) sum = differences_[j].data()[i] += sum;
      differences_[0].data()[i] = next_.data()[i];
    });
    jacobian_fresh_ = false;
  }

  /// Order and step that promise most, where they are worth a new factorization.
  void choose_order(double error) {
    const auto promise = [](double norm, std::size_t order, double bias) {
      return 1 / (bias * std::pow(std::max(norm, 1e-30), 1 / double(order + 1)));
    };
    double best = promise(error, order_, same_bias);
    std::size_t order = order_;
    if (order_ > 1) {
      const double lower = promise(scaled_norm(differences_[order_], formulas_.error_constant(order_ - 1)),
                                   order_ - 1, lower_bias);
      if (lower > best) best = lower, order = order_ - 1;
    }
    if (order_ < highest) {
      const double higher =
          promise(scaled_norm(differences_[order_ + 2], formulas_.error_constant(order_ + 1)), order_ + 1,
                  higher_bias);
      if (higher > best) best = higher, order = order_ + 1;
    }
    if (order == order_ && best < worthwhile) return;
    order_ = order;
    resize(Real(std::min(best, BdfFormulas::step_ratio_cap[order_])));
  }

  void resize(Real ratio) {
    if (ratio == 1) return;
    const auto weights = BdfFormulas::rescaling(order_, ratio);
    for_each_component(next_, [&](std::size_t i) {
      std::array<Real, highest + 1> old{};
      for (std::size_t j = 0; j <= order_; ++j) old[j] = differences_[j].data()[i];
      for (std::size_t j = 1; j <= order_; ++j) {
        Real sum = 0;
        for (std::size_t m = 1; m <= order_; ++m) sum += weights[m][j] * old[m];
        differences_[j].data()[i] = sum;
      }
    });
    h_ *= ratio, equal_steps_ = 0, factored_ = false;
  }

  static constexpr double same_bias = 1.2, lower_bias = 1.3, higher_bias = 1.4, worthwhile = 1.2;

  const P& system_;
  BdfFormulas formulas_;
  const ErrorControl& control_;
  std::size_t size_;
  std::array<State, highest + 3> differences_;
  State predicted_, known_, distance_, correction_, next_, scratch_;
  JacobianMatrix<Real> jacobian_;
  ShiftedLu<Real> lu_;
  NewtonCounts counts_;
  Real t_ = 0, h_ = 0;
  std::size_t order_ = 1, equal_steps_ = 0;
  double newton_tolerance_, rate_ = 1;
  bool jacobian_fresh_ = false, factored_ = false;
};

}  // namespace odemark
