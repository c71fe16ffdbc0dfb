// The linearly implicit Euler rule with First, First + 1, ... substeps, extrapolated in h row by row.
#pragma once

#include "integrators/jacobian.hpp"
#include "integrators/shifted_lu.hpp"
#include "integrators/theory.hpp"

namespace odemark {

/// P. Deuflhard, SIAM Rev. 27 (1985) 505-535; Hairer & Wanner, Solving ODEs II, IV.9: (I - h J) (y_{m+1} -
/// y_m) = h f(t_{m+1}, y_m), with J of the start of the whole step. The expansion of the error in powers of h
/// holds for any J, so that an approximate one costs no order. Row j (from 0) ends in a value of order j + 1.
template <System P, std::size_t Rows, int First>
class LinearlyImplicitTable {
 public:
  using State = typename P::State;
  using Real = RealOf<State>;
  static constexpr std::size_t rows = Rows;
  static constexpr int substeps(std::size_t row) { return First + int(row); }
  /// Evaluations up to this row, with the Jacobian counted as five and a factorization as two.
  static constexpr double work(std::size_t row) {
    double sum = 5;
    for (std::size_t j = 0; j <= row; ++j) sum += substeps(j) + (substeps(j) <= 2 ? 3 : 2);
    return sum;
  }
  static constexpr int error_power(std::size_t row) { return int(row) + 1; }
  static constexpr int expansion_power = 1;

  LinearlyImplicitTable(const P& system, const State& model)
      : system_(system),
        now_(model),
        move_(model),
        spare_(model),
        jacobian_(jacobian_shape(system, model)),
        lu_(jacobian_.shape()) {
    entries_.fill(model);
  }

  void begin(Real t, const State& y) { evaluate_jacobian(system_, t, y, jacobian_, now_, move_, spare_); }
  void always_go_on() { goes_on_ = true; }
  bool is_trusted() const { return trusted_; }
  NewtonCounts counts() const { return counts_; }

  /// Adds the next row; `best` and `difference` are its last entry and how far that is from the one before.
  /// False where it is not finite, and where the step is not to be trusted, unless all rows are wanted all
  /// the same: then is_trusted() tells. What decides is whether Newton's iteration for the first of two
  /// implicit Euler substeps would contract; if not, the Jacobian is not that of the way the solution takes
  /// (SEULEX's test).
  bool add_row(std::size_t row, Real t, const State& y, Real h, State& best, State& difference) {
    const int count = substeps(row);
    const Real small = h / static_cast<Real>(count);
    if (row == 0) trusted_ = true;
    lu_.factorize_step(jacobian_, small);
    ++counts_.lu;
    now_ = y;
    for (int m = 1; m <= count; ++m) {
      system_.rhs(m == count ? t + h : t + static_cast<Real>(m) * small, now_, move_);
      for_each_component(y, [&](std::size_t i) { move_.data()[i] = small * move_.data()[i]; });
      lu_.solve_in_place(move_.data());
      ++counts_.newton;
      Real length = 0;
      for_each_component(y, [&](std::size_t i) {
        now_.data()[i] = now_.data()[i] + move_.data()[i];
        length += std::abs(move_.data()[i]);
      });
      if (!std::isfinite(length)) return false;
      if (m == 1 && count <= 2 && !contracts(t + small, small, length)) trusted_ = false;
      if (!trusted_ && !goes_on_) return false;
    }
    extrapolate(row, best, difference);
    return true;
  }

 private:
  /// A second Newton iterate after the first, which moved by move_, of this length: does it move by less?
  bool contracts(Real t, Real h, Real length) {
    system_.rhs(t, now_, spare_);
    for_each_component(now_,
                       [&](std::size_t i) { spare_.data()[i] = h * spare_.data()[i] - move_.data()[i]; });
    lu_.solve_in_place(spare_.data());
    Real second = 0, size = 0;
    for_each_component(now_, [&](std::size_t i) {
      second += std::abs(spare_.data()[i]);
      size += std::abs(now_.data()[i]);
    });
    return second <= length || second <= std::sqrt(std::numeric_limits<Real>::epsilon()) * size;
  }

  /// Aitken-Neville: entries_ holds the row before and becomes this one.
  void extrapolate(std::size_t row, State& best, State& difference) {
    const auto& factor = factors[row];
    for_each_component(now_, [&](std::size_t i) {
      auto entry = now_.data()[i];
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
      for (std::size_t k = 1; k <= row; ++k)
        out[row][k] = static_cast<Real>(Coefficient(substeps(row - k)) / Coefficient(k));
    return out;
  }();

  const P& system_;
  State now_, move_, spare_;
  std::array<State, Rows> entries_;
  JacobianMatrix<Real> jacobian_;
  ShiftedLu<Real> lu_;
  NewtonCounts counts_;
  bool goes_on_ = false, trusted_ = true;
};

/// sum_j w_j (1 - z / n_j)^(-n_j) over a common denominator, w_j the weights of the extrapolation to h = 0.
template <std::size_t Rows, int First>
Theory linearly_implicit_theory() {
  const auto product = [](const std::vector<Coefficient>& p, const std::vector<Coefficient>& q) {
    std::vector<Coefficient> out(p.size() + q.size() - 1, 0);
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = 0; j < q.size(); ++j) out[i + j] += p[i] * q[j];
    return out;
  };
  const auto over_all_but = [&](std::size_t left_out) {
    std::vector<Coefficient> out{1};
    for (std::size_t j = 0; j < Rows; ++j)
      for (int m = 0; j != left_out && m < First + int(j); ++m)
        out = product(out, {1, -1 / Coefficient(First + int(j))});
    return out;
  };
  Theory theory;
  theory.denominator = over_all_but(Rows);
  theory.rounding_amplification = 0;
  for (std::size_t j = 0; j < Rows; ++j) {
    Coefficient weight = 1;
    for (std::size_t i = 0; i < Rows; ++i)
      if (i != j) weight *= Coefficient(First + int(j)) / (Coefficient(int(j)) - Coefficient(int(i)));
    theory.rounding_amplification += std::abs(weight);
    const auto part = over_all_but(j);
    theory.numerator.resize(std::max(theory.numerator.size(), part.size()), 0);
    for (std::size_t k = 0; k < part.size(); ++k) theory.numerator[k] += weight * part[k];
  }
  return theory;
}

}  // namespace odemark
