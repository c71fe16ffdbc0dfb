// Velocity Verlet where the force depends on velocity: programs of this name differ in the velocity they put
// in.
#pragma once

#include "integrators/theory.hpp"
#include "integrators/velocity_block_lu.hpp"

namespace odemark {

template <const auto& method, SecondOrderSystem P>
class VelocityVerletStepper;

/// x+ = x + h v + h^2/2 a(x, v);  v+ = v + h/2 (a(x, v) + a(x+, V)) with V as named. For forces without
/// velocity all are the same method.
struct VelocityVerlet {
  enum class Velocity { old, predicted, implicit };
  static constexpr std::string_view kind_name = "velocity Verlet";
  static constexpr unsigned needs = Ability::second_order;

  std::string_view id, source;
  int order;
  int embedded_order = 0;
  Velocity velocity;
  std::string_view note = "";

  Theory theory() const {
    using What = SecondOrderMove::What;
    const What last = velocity == Velocity::old         ? What::kick_old
                      : velocity == Velocity::predicted ? What::kick_predicted
                                                        : What::kick_implicit;
    Theory theory;
    // half a kick before the drift is what makes x + h v + h^2/2 a of it
    theory.moves = {{What::kick, 0.5L}, {What::drift, 1}, {last, 0.5L}};
    return theory;
  }

  template <const auto& method, SecondOrderSystem P>
  using Stepper = VelocityVerletStepper<method, P>;
};

template <const auto& method, SecondOrderSystem P>
class VelocityVerletStepper {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;

  VelocityVerletStepper(const P& system, const State& model)
      : system_(system),
        half_(size_of(model) / 2),
        a_(zeros_like(model)),
        b_(a_),
        moved_(model),
        solver_(system, model) {}

  void start() {}
  void accept() {}
  NewtonCounts newton_counts() const { return counts_; }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State&) {
    system_.acceleration(t, y, a_.data());
    for (std::size_t i = 0; i < half_; ++i) {
      const Real v = y.data()[half_ + i], a = a_.data()[i];
      next.data()[i] = y.data()[i] + (h * v + h * h / 2 * a);
      moved_.data()[i] = next.data()[i];
      moved_.data()[half_ + i] = method.velocity == VelocityVerlet::Velocity::old ? v : v + h * a;
    }
    if constexpr (method.velocity == VelocityVerlet::Velocity::implicit)
      if (system_.force_depends_on_velocity() && !solve_velocity(t + h, y, h))
        return StepStatus::newton_diverged;
    system_.acceleration(t + h, moved_, b_.data());
    for (std::size_t i = 0; i < half_; ++i)
      next.data()[half_ + i] = y.data()[half_ + i] + h / 2 * (a_.data()[i] + b_.data()[i]);
    return StepStatus::ok;
  }

 private:
  static constexpr int most_iterations = 12;

  /// Newton for V = v + h/2 (a + a(x+, V)) with the velocity block of the Jacobian; V ends up in moved_.
  bool solve_velocity(Real t, const State& y, Real h) {
    Real previous = std::numeric_limits<Real>::infinity();
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      solver_.factorize(t, moved_, h / 2);
      ++counts_.lu, ++counts_.newton;
      system_.acceleration(t, moved_, b_.data());
      for (std::size_t i = 0; i < half_; ++i)
        b_.data()[i] = y.data()[half_ + i] + h / 2 * (a_.data()[i] + b_.data()[i]) - moved_.data()[half_ + i];
      solver_.solve_in_place(b_.data());
      Real moved = 0, size = std::numeric_limits<Real>::min();
      for (std::size_t i = 0; i < half_; ++i) {
        moved_.data()[half_ + i] += b_.data()[i];
        // in units of what the velocity is made of: it may itself come out as zero
        moved += std::abs(b_.data()[i]);
        size +=
            std::abs(moved_.data()[half_ + i]) + std::abs(y.data()[half_ + i]) + std::abs(h * a_.data()[i]);
      }
      const Real tolerance = 4 * std::numeric_limits<Real>::epsilon() * size;
      if (!std::isfinite(moved + size)) return false;
      if (moved <= tolerance || (moved >= previous / 2 && moved <= 1024 * tolerance)) return true;
      previous = moved;
    }
    return false;
  }

  const P& system_;
  std::size_t half_;
  State a_, b_, moved_;
  struct NoSolver {
    NoSolver(const P&, const State&) {}
  };
  std::conditional_t<method.velocity == VelocityVerlet::Velocity::implicit, VelocityBlockLu<P>, NoSolver>
      solver_;
  NewtonCounts counts_;
};

}  // namespace odemark
