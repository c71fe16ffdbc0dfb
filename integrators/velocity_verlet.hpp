// Velocity Verlet where the force depends on velocity: programs of this name differ in the velocity they put
// in.
#pragma once

#include "integrators/dense_lu.hpp"
#include "integrators/jacobian.hpp"
#include "integrators/theory.hpp"

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
        scratch_{a_, a_, a_},
        full_(size_of(model)),
        velocity_block_(half_) {}

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
      evaluate_jacobian(system_, t, moved_, MatrixView<Real>{full_.jacobian(), 2 * half_}, scratch_[0],
                        scratch_[1], scratch_[2]);
      const MatrixView<Real> all{full_.jacobian(), 2 * half_}, block{velocity_block_.jacobian(), half_};
      for (std::size_t r = 0; r < half_; ++r)
        for (std::size_t c = 0; c < half_; ++c) block(r, c) = all(half_ + r, half_ + c);
      velocity_block_.factorize(h / 2);
      ++counts_.lu, ++counts_.newton;
      system_.acceleration(t, moved_, b_.data());
      for (std::size_t i = 0; i < half_; ++i)
        b_.data()[i] = y.data()[half_ + i] + h / 2 * (a_.data()[i] + b_.data()[i]) - moved_.data()[half_ + i];
      velocity_block_.solve_in_place(b_.data());
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
  std::array<State, 3> scratch_;
  struct NoMatrix {
    explicit NoMatrix(std::size_t) {}
  };
  using Matrix =
      std::conditional_t<method.velocity == VelocityVerlet::Velocity::implicit, DenseLu<Real>, NoMatrix>;
  Matrix full_, velocity_block_;
  NewtonCounts counts_;
};

}  // namespace odemark
