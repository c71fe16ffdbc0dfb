// The implicit methods of structural codes: Newmark, Hilber-Hughes-Taylor, generalised alpha, one engine.
#pragma once

#include <cmath>

#include "integrators/second_order_jacobian.hpp"
#include "integrators/shifted_lu.hpp"
#include "integrators/theory.hpp"

namespace odemark {

template <const auto& method, SecondOrderSystem P>
class GeneralisedAlphaStepper;

/// x+ = x + h v + h^2 ((1/2 - beta) a + beta a+),  v+ = v + h ((1 - gamma) a + gamma a+), where a+ solves
/// (1 - alpha_m) a+ + alpha_m a = force at (1 - alpha_f) (t + h, x+, v+) + alpha_f (t, x, v)
/// (J. Chung, G. M. Hulbert, J. Appl. Mech. 60 (1993) 371-375, doi:10.1115/1.2900803). Unless both alphas are
/// 0, a is no force at any time but a number that the method carries along; it starts as the force at t0.
struct GeneralisedAlpha {
  static constexpr std::string_view kind_name = "generalised alpha";
  static constexpr unsigned needs = Ability::second_order | Ability::jacobian;

  std::string_view id, source;
  int order = 2;
  int embedded_order = 0;
  Coefficient alpha_m = 0, alpha_f = 0, beta = 0.25L, gamma = 0.5L;
  std::string_view starter = "";  // said where an acceleration is carried along
  std::string_view note = "", advice = "";

  constexpr bool carries() const { return alpha_m != 0 || alpha_f != 0; }
  /// Second order is gamma = 1/2 - alpha_m + alpha_f; stable at every step is alpha_m <= alpha_f <= 1/2 and
  /// beta >= 1/4 + (alpha_f - alpha_m)/2 (Chung and Hulbert).
  constexpr bool second_order_and_stable() const {
    const Coefficient off = gamma - (0.5L - alpha_m + alpha_f);
    return off < 1e-18L && off > -1e-18L && alpha_m <= alpha_f && alpha_f <= 0.5L &&
           beta >= 0.25L + (alpha_f - alpha_m) / 2 - 1e-18L;
  }
  constexpr bool says_how_it_starts() const { return carries() == !starter.empty(); }

  Theory theory() const {
    Theory theory;
    theory.second_order_step = [m = *this](Coefficient k, Coefficient c, Coefficient h) {
      const Coefficient share = 1 - m.alpha_f, mass = 1 - m.alpha_m, ratio = m.gamma / m.beta;
      const Coefficient below = mass + share * (m.beta * h * h * k + m.gamma * h * c);
      // columns: what x = 1, v = 1 and a = 1 become; s is the mean velocity of the step
      std::vector<Coefficient> out;
      const auto column = [&](Coefficient x, Coefficient v, Coefficient a) {
        const Coefficient old_v = v * (1 - share * ratio) + share * h * (1 - ratio / 2) * a;
        const Coefficient s =
            (mass * (v + h * (0.5L - m.beta) * a) - m.beta * h * (m.alpha_m * a + k * x + c * old_v)) / below;
        out.push_back(x + h * s);
        out.push_back(v * (1 - ratio) + ratio * s + h * (1 - ratio / 2) * a);
        if (m.carries()) out.push_back((s - v - h * (0.5L - m.beta) * a) / (m.beta * h));
      };
      column(1, 0, m.carries() ? 0 : -k), column(0, 1, m.carries() ? 0 : -c);
      if (m.carries()) column(0, 0, 1);
      return out;
    };
    return theory;
  }

  template <const auto& method, SecondOrderSystem P>
  using Stepper = GeneralisedAlphaStepper<method, P>;
};

template <const auto& method, SecondOrderSystem P>
class GeneralisedAlphaStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  GeneralisedAlphaStepper(const P& system, const State& model)
      : system_(system),
        half_(size_of(model) / 2),
        jacobian_(system, model),
        matrix_(jacobian_.block_shape()),
        lu_(matrix_.shape()),
        look_(model),
        carried_(zeros_like(model)),
        new_(carried_),
        mean_(half_),
        correction_(half_) {}

  void start() { known_ = false; }
  void accept() {
    known_ = method.carries();
    std::swap(carried_, new_);
  }
  NewtonCounts newton_counts() const { return counts_; }
  /// The carried acceleration lies where the velocities lie.
  std::size_t history_length() const requires(method.carries()) { return 1; }
  State& history(std::size_t) requires(method.carries()) { return carried_; }
  void assume_history() requires(method.carries()) { known_ = true; }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State&) {
    const Real* v = y.data() + half_;
    Real* a = carried_.data() + half_;
    if (!known_) system_.acceleration(t, y, a);
    if (!solve(t, y, h)) return StepStatus::newton_diverged;
    for (std::size_t i = 0; i < half_; ++i) {
      next.data()[i] = y.data()[i] + h * mean_[i];
      next.data()[half_ + i] = v[i] + gain(v[i], a[i], h, i);
      new_.data()[half_ + i] = new_acceleration(v[i], a[i], h, i);
    }
    return StepStatus::ok;
  }

 private:
  static constexpr int most_iterations = 25;
  static constexpr Real beta = static_cast<Real>(method.beta), early = static_cast<Real>(0.5L - method.beta);
  static constexpr Real gamma = static_cast<Real>(method.gamma),
                        ratio = static_cast<Real>(method.gamma / method.beta);
  static constexpr Real rest = static_cast<Real>(1 - method.gamma / method.beta / 2);
  static constexpr Real mass_old = static_cast<Real>(method.alpha_m),
                        mass_new = static_cast<Real>(1 - method.alpha_m);
  static constexpr Real share = static_cast<Real>(1 - method.alpha_f);

  // The unknown is the mean velocity s = (x+ - x)/h: with a+ for the unknown a stiff spring would cost
  // digits.
  Real gain(Real v, Real a, Real h, std::size_t i) const { return ratio * (mean_[i] - v) + rest * h * a; }
  Real new_acceleration(Real v, Real a, Real h, std::size_t i) const {
    return ((mean_[i] - v) - h * early * a) / (beta * h);
  }

  /// Newton's method for s, with a Jacobian of every iterate.
  bool solve(Real t, const State& y, Real h) {
    const Real *v = y.data() + half_, *a = carried_.data() + half_;
    for (std::size_t i = 0; i < half_; ++i) mean_[i] = v[i];
    Real previous = std::numeric_limits<Real>::infinity();
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      for (std::size_t i = 0; i < half_; ++i) {
        look_.data()[i] = y.data()[i] + share * h * mean_[i];
        look_.data()[half_ + i] = v[i] + share * gain(v[i], a[i], h, i);
      }
      system_.acceleration(t + share * h, look_, correction_.data());
      jacobian_.evaluate(t + share * h, look_);
      const auto block = matrix_.view();
      Real size = std::numeric_limits<Real>::min(), terms = 0;  // sums, because std::max would swallow a NaN
      for (std::size_t r = 0; r < half_; ++r) {
        const Real force = beta * h / mass_new * (correction_[r] - mass_old * a[r]);
        correction_[r] = force - ((mean_[r] - v[r]) - h * early * a[r]);
        jacobian_.for_each_near(r, [&](std::size_t c) {
          const Real by_x = jacobian_.by_position(r, c), by_v = jacobian_.by_velocity(r, c);
          block(r, c) = share / mass_new * (h * beta * by_x + gamma * by_v);
          // what the force is the small difference of: its rounding is that of these
          terms += beta * std::abs(h) *
                   (std::abs(by_x * look_.data()[c]) + std::abs(by_v * look_.data()[half_ + c]));
        });
      }
      lu_.factorize_step(matrix_, h);
      lu_.solve_in_place(correction_.data());
      ++counts_.lu, ++counts_.newton;
      Real moved = 0;
      for (std::size_t i = 0; i < half_; ++i) {
        mean_[i] += correction_[i];
        moved += std::abs(correction_[i]), size += std::abs(mean_[i]) + std::abs(v[i]);
      }
      if (!std::isfinite(moved + size)) return false;
      const Real tolerance = 4 * std::numeric_limits<Real>::epsilon();
      const bool stalled = moved >= previous / 2 && moved <= 1024 * tolerance * (size + terms);
      if (moved <= tolerance * size || stalled) return true;
      previous = moved;
    }
    return false;
  }

  const P& system_;
  std::size_t half_;
  SecondOrderJacobian<P> jacobian_;
  JacobianMatrix<Real> matrix_;  // of the force for the mean velocity
  ShiftedLu<Real> lu_;
  State look_, carried_, new_;
  std::vector<Real> mean_, correction_;
  bool known_ = false;
  NewtonCounts counts_;
};

}  // namespace odemark
