// The stages of an explicit Runge-Kutta step on a few doubles: two components to a register.
#pragma once

#include <limits>
#include <tuple>
#include <type_traits>

#include "integrators/stepper.hpp"

namespace odemark {

/// Row I of a tableau as weights: the stages, then the step, the error estimate and the second estimate.
template <const auto& method, std::size_t I>
struct TableauRow {
  static constexpr std::size_t step = method.stages, error = step + 1, second_error = step + 2;
  static constexpr std::size_t count = I < step ? I : step;
  static constexpr Coefficient value(std::size_t j) {
    if constexpr (I < step)
      return method.a[I][j];
    else if constexpr (I == step)
      return method.b[j];
    else if constexpr (I == error)
      return method.b[j] - method.b_embedded[j];
    else
      return method.b[j] - method.b_second_embedded[j];
  }
};

/// Where keeping the products pays: methods of few stages wait for their slopes, not for the processor, and
/// packing costs dormand_prince54 half as much again.
template <const auto& method, class S>
inline constexpr bool has_paired_stages =
    std::is_same_v<ComponentOf<S>, double>&& fixed_size<S> >= 2 && fixed_size<S> <= 8 && method.stages >= 10;

/// The same operations in the same order as one component after the other, so the same bits. What it saves:
/// h w_j is kept while h stays, which with a dead band is most of the time, and a pair costs what a component
/// costs. verner87 on lorenz63: 82 instead of 208 ns a step.
template <const auto& method, System P>
class PairedStages {
 public:
  using State = typename P::State;

  /// `first` is f(t, y). `last` is written where the last stage is the first of the next step, `second_error`
  /// where there are two estimates.
  [[gnu::always_inline]] void take_step(const P& system, double t, const State& y, double h,
                                        const State& first, State& next, State& error, State& second_error,
                                        State& last) {
    if (!(h == products_for_)) keep_products(h);
    evaluate_from<1>(system, t, y, h, next, error, second_error, last, Pairs(first));
  }

 private:
  static constexpr std::size_t n = fixed_size<State>;
  template <std::size_t I>
  using Row = TableauRow<method, I>;
  static constexpr std::size_t step = Row<0>::step, error_row = Row<0>::error,
                               second_error_row = Row<0>::second_error;
  typedef double Two __attribute__((vector_size(16)));

  /// A state in registers; the last half is unused where n is odd.
  struct Pairs {
    std::array<Two, (n + 1) / 2> pair;
    [[gnu::always_inline]] explicit Pairs(const State& s) {
      for (std::size_t i = 0; i < n / 2; ++i) pair[i] = Two{s[2 * i], s[2 * i + 1]};
      if constexpr (n % 2 == 1) pair[n / 2] = Two{s[n - 1], 0};
    }
  };

  template <std::size_t I>
  static constexpr auto used = nonzero_weights<Row<I>, Row<I>::count>();
  /// Where the products of row I start in the table.
  template <std::size_t I>
  static constexpr std::size_t place() {
    if constexpr (I <= 1)
      return 0;
    else
      return place<I - 1>() + used<I - 1>.size();
  }
  static constexpr std::size_t last_row = method.has_second_estimate()  ? second_error_row
                                          : method.has_error_estimate() ? error_row
                                                                        : step;

  template <std::size_t I>
  void keep_products_of(double h) {
    for (std::size_t u = 0; u < used<I>.size(); ++u) {
      const double product = h * static_cast<double>(Row<I>::value(used<I>[u]));
      product_[place<I>() + u] = Two{product, product};
    }
  }
  [[gnu::noinline]] void keep_products(double h) {
    products_for_ = h;
    [&]<std::size_t... I>(std::index_sequence<I...>) { (keep_products_of<I + 1>(h), ...); }
    (std::make_index_sequence<last_row>{});
  }

  /// out = base + h sum_j w_j k_j, or without a base the sum alone.
  template <std::size_t I, bool with_base, std::size_t Pair, class Slopes, std::size_t... U>
  [[gnu::always_inline]] void combine_pair(const State& base, State& out, const Slopes& k,
                                           std::index_sequence<U...>) const {
    constexpr std::size_t i = 2 * Pair;
    const auto sum_of = [&](auto start, auto product, auto slope) __attribute__((always_inline)) {
      if constexpr (with_base) {
        ((start = start + product(place<I>() + U) * slope(std::get<used<I>[U]>(k))), ...);
        return start;
      } else {
        return (... + (product(place<I>() + U) * slope(std::get<used<I>[U]>(k))));
      }
    };
    if constexpr (i + 1 < n) {
      const Two sum = sum_of(
          Two{base[i], base[i + 1]}, [&](std::size_t p) { return product_[p]; },
          [](const Pairs& s) { return s.pair[Pair]; });
      out[i] = sum[0], out[i + 1] = sum[1];
    } else {
      out[i] = sum_of(
          base[i], [&](std::size_t p) { return product_[p][0]; },
          [](const Pairs& s) { return s.pair[Pair][0]; });
    }
  }
  template <std::size_t I, bool with_base, class... Slopes>
  [[gnu::always_inline]] void combine(const State& base, State& out, const Slopes&... k) const {
    [&]<std::size_t... Pair>(std::index_sequence<Pair...>) __attribute__((always_inline)) {
      (combine_pair<I, with_base, Pair>(base, out, std::tie(k...),
                                        std::make_index_sequence<used<I>.size()>{}),
       ...);
    }
    (std::make_index_sequence<(n + 1) / 2>{});
  }

  template <std::size_t I, class... Slopes>
  [[gnu::always_inline]] void evaluate_from(const P& system, double t, const State& y, double h, State& next,
                                            State& error, State& second_error, State& last,
                                            const Slopes&... k) {
    if constexpr (I < method.stages) {
      State u, slope;
      combine<I, true>(y, u, k...);
      system.rhs(t + static_cast<double>(method.c(I)) * h, u, slope);
      if constexpr (I + 1 == method.stages && method.first_same_as_last()) next = u, last = slope;
      evaluate_from<I + 1>(system, t, y, h, next, error, second_error, last, k..., Pairs(slope));
    } else {
      if constexpr (!method.first_same_as_last()) combine<step, true>(y, next, k...);
      if constexpr (method.has_error_estimate()) combine<error_row, false>(y, error, k...);
      if constexpr (method.has_second_estimate()) combine<second_error_row, false>(y, second_error, k...);
    }
  }

  std::array<Two, place<last_row>() + used<last_row>.size()> product_{};
  double products_for_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace odemark
