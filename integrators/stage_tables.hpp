// What a fully implicit step needs of its tableau, in the number type it computes in, made once per method.
#pragma once

#include "integrators/stage_modes.hpp"

namespace odemark {

/// Modes in real form: row m of `into` belongs to the m-th real mode; a complex pair has two rows, real and
/// imaginary part. z = out * w, w = into * z.
template <class Real, std::size_t S>
struct StageTables {
  using Row = std::array<Real, S>;
  std::array<Row, S> a{}, into{}, out{};
  Row c{}, b{};
  Row increment{};  // y_new = y + sum increment_i z_i, where A is regular
  Row estimate{};   // h times the polynomial's slope at the start, with a minus: see IV.8, eq. 8.19
  Row shift_re{}, shift_im{};  // 1 / eigenvalue of A, by mode; 0 for a zero eigenvalue
  Row extrapolate{};           // denominators of the Lagrange polynomials on the nodes and, where free, 0

  template <class Method>
  static const StageTables& of(const Method& method) {
    static const StageTables tables(method);
    return tables;
  }

  template <class Method>
  explicit StageTables(const Method& method) {
    std::array<Coefficient, S * S> flat{};
    StageVectorOf nodes{};
    for (std::size_t i = 0; i < S; ++i) {
      nodes[i] = method.c(i);
      c[i] = Real(nodes[i]), b[i] = Real(method.b[i]);
      for (std::size_t j = 0; j < S; ++j) flat[i * S + j] = method.a[i][j], a[i][j] = Real(method.a[i][j]);
    }
    const StageModes modes = stage_modes(S, flat.data());
    std::size_t row = 0;
    for (std::size_t m = 0; m < modes.reals + modes.pairs; ++m) {
      const auto& value = modes.value[m];
      const bool zero = magnitude_of(value) == 0;
      const auto shift = zero ? value : reciprocal_of(value);
      shift_re[m] = Real(shift.re), shift_im[m] = Real(shift.im);
      const bool is_pair = m >= modes.reals;
      for (std::size_t j = 0; j < S; ++j) {
        into[row][j] = Real(modes.left[m][j].re);
        out[j][row] = Real(modes.right[m][j].re * (is_pair ? 2 : 1));
        if (!is_pair) continue;
        into[row + 1][j] = Real(modes.left[m][j].im);
        out[j][row + 1] = Real(modes.right[m][j].im * -2);
      }
      row += is_pair ? 2 : 1;
    }
    // rows times the inverse of A through its modes: b' A^-1, and l(0)' A^-1 for the estimate
    StageVectorOf start{};
    for (std::size_t j = 0; j < S; ++j) {
      start[j] = 1;
      for (std::size_t m = 0; m < S; ++m)
        if (m != j) start[j] *= -nodes[m] / (nodes[j] - nodes[m]);
    }
    StageVectorOf increments{}, estimates{};
    for (std::size_t m = 0; m < modes.reals + modes.pairs; ++m) {
      if (magnitude_of(modes.value[m]) == 0) continue;
      const auto inverse = reciprocal_of(modes.value[m]);
      StageModes::Complex b_right{}, start_right{};
      for (std::size_t i = 0; i < S; ++i) {
        b_right = b_right + StageModes::Complex{method.b[i], 0} * modes.right[m][i];
        start_right = start_right + StageModes::Complex{start[i], 0} * modes.right[m][i];
      }
      for (std::size_t j = 0; j < S; ++j) {
        const int copies = m < modes.reals ? 1 : 2;
        increments[j] += (b_right * inverse * modes.left[m][j]).re * copies;
        estimates[j] -= (start_right * inverse * modes.left[m][j]).re * copies;
      }
    }
    for (std::size_t j = 0; j < S; ++j) {
      increment[j] = Real(increments[j]), estimate[j] = Real(estimates[j]);
      Coefficient product = nodes[0] == 0 ? Coefficient(1) : nodes[j];
      for (std::size_t m = 0; m < S; ++m)
        if (m != j) product *= nodes[j] - nodes[m];
      extrapolate[j] = Real(1 / product);
    }
  }

 private:
  using StageVectorOf = std::array<Coefficient, S>;
};

}  // namespace odemark
