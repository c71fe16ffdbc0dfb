// What can be known of a method from its coefficients alone: orders proved, intervals, kinds of stability.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "integrators/linear_stability.hpp"

namespace odemark {

/// A value, or the sentence that says why there is none.
template <class T>
struct Fact {
  std::optional<T> value;
  std::string reason;  // where a value is there: what it means beyond its name, mostly empty

  Fact() : reason("not known") {}
  Fact(T known, std::string meaning = "") : value(std::move(known)), reason(std::move(meaning)) {}
  static Fact none(std::string why) {
    Fact out;
    out.reason = std::move(why);
    return out;
  }
  explicit operator bool() const { return value.has_value(); }
  const T& operator*() const { return *value; }
  const T* operator->() const { return &*value; }
};

/// coefficient * y^power + ..., for small y.
struct PowerLaw {
  Coefficient coefficient = 0;
  int power = 0;
};

/// Intervals are in z = h lambda, oscillator limits in omega h; infinity where there is no end.
struct StabilityFacts {
  Fact<Coefficient> real_interval, imaginary_interval;
  Fact<Intervals> real_islands, imaginary_bands;  // stable again beyond the interval
  /// Largest y with |R(iy')| <= 1 + 1e-3 for every y' <= y.
  Fact<Coefficient> imaginary_interval_eps;
  Fact<PowerLaw> log_amplification, phase_error;  // ln |R(iy)| and arg R(iy) - y, per step
  Fact<Coefficient> r_infinity;                   // lim R(z), z -> -infinity; multistep: the largest root
  Fact<bool> a_stable, l_stable;
  Fact<Coefficient> a_alpha_degrees;
};

struct MethodFacts {
  Fact<int> stages, order, embedded_order, stage_order;
  Fact<bool> fsal, stiffly_accurate, algebraically_stable, symplectic, symmetric, zero_stable;
  Fact<int> evaluations_per_step, linear_solves_per_step;
  Fact<Coefficient> error_constant, embedded_error_constant;
  StabilityFacts stability, embedded;
  Fact<Coefficient> ssp_coefficient, internal_amplification, step_ratio_limit;
  Fact<Coefficient> oscillator_limit;
  Fact<Intervals> oscillator_windows;
  Fact<std::map<Coefficient, Coefficient>> damped_limit;  // zeta -> limit of omega h
  /// Spectral radius of step control at the end of the real interval: below 1 step sizes settle there.
  Fact<std::map<std::string, Coefficient>> controller_spectral_radius;
};

/// `order` and `embedded_order` are what the method claims; an order that can be proved replaces the claim.
MethodFacts method_facts(const Theory& theory, int order, int embedded_order = 0);

inline constexpr Coefficient damping_ratios[] = {0.01L, 0.1L, 0.5L, 1, 2};

}  // namespace odemark
