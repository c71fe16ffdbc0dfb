// The contract between one step of a method and the loops that drive it.
#pragma once

#include <array>
#include <string_view>

#include "integrators/system.hpp"

namespace odemark {

/// Coefficients are kept wider than any scalar they are used with.
using Coefficient = long double;

enum class StepStatus { ok, newton_diverged };

/// start():   forget everything known about earlier steps.
/// attempt(): compute y(t + h) into `next` and, where the method has one, a local error estimate into
///            `error`. Leaves y and the history alone, so a rejected attempt costs only its evaluations.
/// accept():  the last attempt became the solution; move its slopes into the history.
template <class S>
concept Stepper = requires(S s, const typename S::State& y, typename S::State& next, typename S::State& error,
                           RealOf<typename S::State> t, RealOf<typename S::State> h) {
  s.start();
  { s.attempt(t, y, h, next, error) } -> std::same_as<StepStatus>;
  s.accept();
};

/// Can carry the rounding errors of y along: next + next_carry is y + carry advanced by one step, where carry
/// holds what y could not (Kahan 1965; Hairer, Lubich & Wanner, Geometric Numerical Integration, VIII.5).
template <class S>
concept CompensatedStepper = Stepper<S> &&
    requires(S s, const typename S::State& y, typename S::State& next, RealOf<typename S::State> t) {
  { s.attempt_compensated(t, y, y, t, next, next) } -> std::same_as<StepStatus>;
};

/// Keeps slopes of past steps. history(0) is the newest; assume_history() makes the stepper believe that all
/// history_length() of them are known, so that a measurement can set them.
template <class S>
concept HasHistory = Stepper<S> && requires(S s, std::size_t k) {
  { s.history_length() } -> std::convertible_to<std::size_t>;
  { s.history(k) } -> std::same_as<typename S::State&>;
  s.assume_history();
};

/// Work that happens inside an implicit stepper, where a counting problem cannot see it.
struct NewtonCounts {
  long lu = 0, newton = 0;
};

/// A method is a constexpr value: who it is, its coefficients, and the engine that runs them.
/// `needs` are Ability bits; `kind_name` is what a reader calls this kind of method.
template <class M>
concept MethodKind = requires(const M& m) {
  { m.id } -> std::convertible_to<std::string_view>;
  { m.source } -> std::convertible_to<std::string_view>;
  { m.order } -> std::convertible_to<int>;
  { m.embedded_order } -> std::convertible_to<int>;
  { M::needs } -> std::convertible_to<unsigned>;
  { M::kind_name } -> std::convertible_to<std::string_view>;
};

template <const auto& method>
using KindOf = std::remove_cvref_t<decltype(method)>;

/// The power of h that the error estimate goes with: one more than the lower of the two orders, unless the
/// kind knows better.
template <const auto& method>
constexpr int error_order() {
  if constexpr (requires { method.error_order(); })
    return method.error_order();
  else
    return (method.embedded_order < method.order ? method.embedded_order : method.order) + 1;
}

template <const auto& method, class Problem>
using StepperOf = typename KindOf<method>::template Stepper<method, Problem>;

template <const auto& method, class Problem>
concept Applicable = requires {
  typename StepperOf<method, Problem>;
};

/// base + h (w_0 k_0 + w_1 k_1 + ...) for one component, summed from the base with the newest slope last:
/// only the last addition waits for it. Zero weights leave no trace. `Weights` is a type with constexpr
/// value(j).
template <class Weights, std::size_t Count>
constexpr auto nonzero_weights() {
  constexpr std::size_t count = [] {
    std::size_t n = 0;
    for (std::size_t j = 0; j < Count; ++j) n += Weights::value(j) != 0;
    return n;
  }();
  std::array<std::size_t, count> indices{};
  for (std::size_t j = 0, n = 0; j < Count; ++j)
    if (Weights::value(j) != 0) indices[n++] = j;
  return indices;
}

}  // namespace odemark
