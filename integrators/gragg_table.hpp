// Gragg's modified midpoint rule with 2, 4, 6, ... substeps, extrapolated in h^2 row by row.
#pragma once

#include "integrators/theory.hpp"

namespace odemark {

/// W. B. Gragg, SIAM J. Numer. Anal. 2 (1965) 384-403; R. Bulirsch, J. Stoer, Numer. Math. 8 (1966) 1-13;
/// Hairer, Norsett & Wanner, Solving ODEs I, II.9. Without Gragg's final smoothing: what it damps does not
/// grow within one step, and it costs an evaluation per row. Row j (from 0) ends in a value of order 2j + 2.
template <System P, std::size_t Rows>
class GraggTable {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;
  static constexpr std::size_t rows = Rows;
  static constexpr int substeps(std::size_t row) { return 2 * int(row + 1); }
  /// Evaluations up to this row; the slope at the start serves all of them.
  static constexpr double work(std::size_t row) { return 1 + double((row + 1) * (row + 1)); }
  /// The difference of the last two entries of a row shrinks as h to this power.
  static constexpr int error_power(std::size_t row) { return 2 * int(row) + 1; }
  /// Of h / substeps, what the expansion of the error proceeds in.
  static constexpr int expansion_power = 2;

  GraggTable(const P& system, const State& model)
      : system_(system), start_slope_(model), slope_(model), even_(model), odd_(model) {
    entries_.fill(model);
  }

  void begin(Real t, const State& y) { system_.rhs(t, y, start_slope_); }
  NewtonCounts counts() const { return {}; }

  /// Adds the next row; `best` and `difference` are its last entry and how far that is from the one before.
  bool add_row(std::size_t row, Real t, const State& y, Real h, State& best, State& difference) {
    const int count = substeps(row);
    const Real small = h / static_cast<Real>(count), twice = small + small;
    even_ = y;
    for_each_component(y,
                       [&](std::size_t i) { odd_.data()[i] = y.data()[i] + small * start_slope_.data()[i]; });
    for (int m = 1; m < count; ++m) {
      const bool is_odd = m % 2 == 1;
      State& to = is_odd ? even_ : odd_;
      system_.rhs(t + static_cast<Real>(m) * small, is_odd ? odd_ : even_, slope_);
      for_each_component(y, [&](std::size_t i) { to.data()[i] = to.data()[i] + twice * slope_.data()[i]; });
    }
    extrapolate(row, even_, best, difference);
    return true;
  }

 private:
  /// Aitken-Neville: entries_ holds the row before and becomes this one.
  void extrapolate(std::size_t row, const State& first, State& best, State& difference) {
    const auto& factor = factors[row];
    for_each_component(first, [&](std::size_t i) {
      auto entry = first.data()[i];
      auto gap = entry;
      for (std::size_t k = 1; k <= row; ++k) {
        gap = factor[k] * (entry - entries_[k - 1].data()[i]);
        entries_[k - 1].data()[i] = entry;
        entry = entry + gap;
      }
      entries_[row].data()[i] = entry;
      best.data()[i] = entry, difference.data()[i] = gap;
    });
  }

  static constexpr auto factors = [] {
    std::array<std::array<Real, Rows>, Rows> out{};
    for (std::size_t row = 0; row < Rows; ++row)
      for (std::size_t k = 1; k <= row; ++k) {
        const Coefficient ratio = Coefficient(substeps(row)) / Coefficient(substeps(row - k));
        out[row][k] = static_cast<Real>(1 / (ratio * ratio - 1));
      }
    return out;
  }();

  const P& system_;
  State start_slope_, slope_, even_, odd_;
  std::array<State, Rows> entries_;
};

/// The same as an explicit Runge-Kutta method: its tableau, and its stability polynomial.
template <std::size_t Rows>
Theory gragg_theory() {
  using Weights = std::vector<Coefficient>;
  std::vector<Weights> a{Weights{}};   // weights of the slopes in every stage
  std::vector<Weights> table, before;  // weights of the slopes in the entries of the extrapolation
  const auto sum = [](const Weights& x, Coefficient factor, const Weights& y) {
    Weights out(std::max(x.size(), y.size()), 0);
    for (std::size_t i = 0; i < x.size(); ++i) out[i] += x[i];
    for (std::size_t i = 0; i < y.size(); ++i) out[i] += factor * y[i];
    return out;
  };
  for (std::size_t j = 0; j < Rows; ++j) {
    const int count = 2 * int(j + 1);
    Weights even, odd{1 / Coefficient(count)};
    for (int m = 1; m < count; ++m) {
      Weights& to = m % 2 == 1 ? even : odd;
      a.push_back(m % 2 == 1 ? odd : even);
      Weights slope(a.size(), 0);
      slope.back() = 1;
      to = sum(to, 2 / Coefficient(count), slope);
    }
    before = table;
    table.assign(1, even);
    for (std::size_t k = 1; k <= j; ++k) {
      const Coefficient ratio = Coefficient(j + 1) / Coefficient(j + 1 - k), factor = 1 / (ratio * ratio - 1);
      table.push_back(sum(sum(table[k - 1], factor, table[k - 1]), -factor, before[k - 1]));
    }
  }
  Theory theory;
  const std::size_t stages = a.size();
  theory.tableau.stages = stages;
  theory.tableau.a.assign(stages * stages, 0);
  std::vector<Weights> stage_polynomials;
  const auto apply = [&](const Weights& weights) {
    Weights out{1};
    for (std::size_t i = 0; i < weights.size(); ++i) {
      Weights shifted = stage_polynomials[i];
      shifted.insert(shifted.begin(), 0);
      out = sum(out, weights[i], shifted);
    }
    return out;
  };
  for (std::size_t i = 0; i < stages; ++i) {
    for (std::size_t k = 0; k < a[i].size(); ++k) theory.tableau.a[i * stages + k] = a[i][k];
    stage_polynomials.push_back(apply(a[i]));
  }
  theory.tableau.b = table.back();
  theory.tableau.b.resize(stages, 0);
  if (Rows > 1) theory.tableau.b_embedded = table[Rows - 2], theory.tableau.b_embedded.resize(stages, 0);
  theory.numerator = apply(table.back());
  while (std::abs(theory.numerator.back()) < 1e-30L) theory.numerator.pop_back();
  theory.denominator = {1};
  return theory;
}

}  // namespace odemark
