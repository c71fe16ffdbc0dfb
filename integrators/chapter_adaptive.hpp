// The chapter's adaptive Euler as its listing has it, faults kept: what the correct controller is compared
// with.
#pragma once

#include "integrators/integrate.hpp"
#include "integrators/methods/chapter_euler.hpp"
#include "integrators/theory.hpp"

namespace odemark {

/// Every call starts from the nominal step. e_t = |V1 - V2|, one Euler step against two half steps, of the
/// velocity; dt_new = dt sqrt(e_to / e_t); if that is smaller the step is retaken once with it and not
/// checked again, else V1 (not the better V2) is kept; the step never grows. Only e_t = 0 is made safe. The
/// clock advances by the step that was taken: a loop that adds the nominal dt, as the chapter's does, falls
/// behind its own simulation.
struct ChapterAdaptive {
  static constexpr std::string_view kind_name = "chapter listing";
  static constexpr unsigned needs = Ability::second_order;
  static constexpr bool takes_fixed_steps = false;

  std::string_view id, source;
  int order;
  int embedded_order;

  Theory theory() const {
    Theory theory;
    theory.blank_reason = "its step depends on the state, so no single limit exists";
    return theory;
  }

  /// One step of a given size is the chapter's Euler step; it serves values between the listing's own steps.
  template <const auto& method, SecondOrderSystem P>
  using Stepper = StepperOf<chapter_euler, P>;

  /// `first_step` of the control is the nominal dt, `absolute_tolerance` the listing's e_to in the unit of v.
  template <const auto& method, SecondOrderSystem P, class Observer>
  static RunReport drive(const P& system, const Control& control, double t0, double t1, typename P::State& y,
                         Observer&& observe) {
    using Real = RealOf<typename P::State>;
    RunReport report;
    report.t_reached = t0;
    const auto* adaptive = std::get_if<ErrorControl>(&control);
    if (!adaptive) {
      report.status = RunStatus::not_applicable;
      report.reason = "chooses its own steps: give a tolerance";
      return report;
    }
    const std::size_t half = size_of(y) / 2;
    const Real allowed = Real(adaptive->absolute_tolerance);
    const Real nominal = Real(first_step(system, *adaptive, 2, t0, t1, y));
    auto next = blank_like(y), middle = blank_like(y), a = zeros_like(y), b = zeros_like(y);
    Real t = Real(t0);
    while (t < Real(t1)) {
      if (report.accepted >= adaptive->step_limit) return stop(report, RunStatus::step_limit, t);
      if (!all_finite(y)) return stop(report, RunStatus::not_finite, t);
      Real dt = nominal;
      system.acceleration(t, y, a.data());
      for (std::size_t i = 0; i < half; ++i) {
        middle.data()[i] = y.data()[i];
        middle.data()[half + i] = y.data()[half + i] + a.data()[i] * (dt / 2);
      }
      system.acceleration(t + dt / 2, middle, b.data());
      Real truncation = 0;
      for (std::size_t i = 0; i < half; ++i) {
        const Real v1 = y.data()[half + i] + a.data()[i] * dt,
                   v2 = middle.data()[half + i] + b.data()[i] * (dt / 2);
        const Real gap = std::abs(v1 - v2);
        if (!(gap <= truncation)) truncation = gap;
      }
      const Real wished = truncation > 0 ? dt * std::sqrt(allowed / truncation) : dt;
      if (wished < dt) dt = wished;
      const bool last = t + dt >= Real(t1);
      if (last) dt = Real(t1) - t;
      if (!last && !(t + dt > t))
        return stop(report, all_finite(y) ? RunStatus::step_underflow : RunStatus::not_finite, t);
      for (std::size_t i = 0; i < half; ++i) {
        const Real v = y.data()[half + i] + a.data()[i] * dt;
        next.data()[half + i] = v;
        next.data()[i] = y.data()[i] + v * dt;
      }
      const Real t_next = last ? Real(t1) : t + dt;
      ++report.accepted;
      const bool go_on = observe(t, y, t_next, next);
      std::swap(y, next);
      t = t_next;
      if (!go_on) return stop(report, RunStatus::time_limit, t);
    }
    return stop(report, all_finite(y) ? RunStatus::reached_end : RunStatus::not_finite, t);
  }

 private:
  template <class Real>
  static RunReport stop(RunReport report, RunStatus status, Real t) {
    report.status = status;
    report.t_reached = double(t);
    return report;
  }
};

}  // namespace odemark
