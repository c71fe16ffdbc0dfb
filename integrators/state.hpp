// What an engine may ask of a state: its numbers, how many there are, and a copy of the same shape.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace odemark {

/// The type of time and of the step for a component type: the component itself, or one lane of a pack.
template <class Component>
struct TimeOf {
  using type = Component;
};

/// A contiguous block of numbers that can be copied: std::array, std::vector, an Eigen column.
/// Components may be plain numbers or packs of lanes (integrators/lanes.hpp).
template <class S>
concept State = std::semiregular<S> && requires(S& s) {
  { s.size() } -> std::convertible_to<std::size_t>;
  s.data();
};

template <State S>
using ComponentOf = std::remove_cvref_t<decltype(*std::declval<S&>().data())>;

template <State S>
using RealOf = typename TimeOf<ComponentOf<S>>::type;

/// Number of components where the type fixes it, else 0.
template <class S>
inline constexpr std::size_t fixed_size = 0;
template <class T, std::size_t N>
inline constexpr std::size_t fixed_size<std::array<T, N>> = N;

template <State S>
constexpr std::size_t size_of(const S& s) {
  if constexpr (fixed_size < S >> 0)
    return fixed_size<S>;
  else
    return static_cast<std::size_t>(s.size());
}

/// A state of the same shape whose contents will be overwritten. Costs nothing where the type fixes the size.
template <State S>
S blank_like(const S& model) {
  if constexpr (fixed_size < S >> 0)
    return S{};
  else
    return model;
}

template <State S>
S zeros_like(const S& model) {
  S zeros = model;
  for (std::size_t i = 0; i < size_of(zeros); ++i) zeros.data()[i] = ComponentOf<S>(0);
  return zeros;
}

/// f(i) for every component: unrolled up to eight, because a loop over two or three components keeps GCC from
/// holding them in registers; a plain loop above, where unrolling costs.
template <State S, class F>
[[gnu::always_inline]] inline void for_each_component(const S& model, F&& f) {
  if constexpr (fixed_size < S >> 0 && fixed_size<S> <= 8) {
    [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) { (f(I), ...); }
    (std::make_index_sequence<fixed_size<S>>{});
  } else {
    const std::size_t count = size_of(model);
    for (std::size_t i = 0; i < count; ++i) f(i);
  }
}

}  // namespace odemark
