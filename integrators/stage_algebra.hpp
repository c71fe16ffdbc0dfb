// Linear algebra across the stages of a fully implicit step: modes, residuals, starting values.
#pragma once

#include "integrators/stage_tables.hpp"
#include "integrators/state.hpp"

namespace odemark {

template <class State, std::size_t S>
void clear_stages(std::array<State, S>& stages) {
  for (auto& s : stages) for_each_component(s, [&](std::size_t n) { s.data()[n] = 0; });
}

template <class Real, std::size_t S>
using StageWeights = std::array<std::array<Real, S>, S>;

/// out_i = sum_j matrix_ij in_j, component by component.
template <class Real, class State, std::size_t S>
void combine_stages(const StageWeights<Real, S>& matrix, const std::array<State, S>& in,
                    std::array<State, S>& out) {
  for_each_component(in[0], [&](std::size_t n) {
    std::array<Real, S> x;
    for (std::size_t j = 0; j < S; ++j) x[j] = in[j].data()[n];
    for (std::size_t i = 0; i < S; ++i) {
      Real sum = matrix[i][0] * x[0];
      for (std::size_t j = 1; j < S; ++j) sum += matrix[i][j] * x[j];
      out[i].data()[n] = sum;
    }
  });
}

/// Weights of the polynomial through the stages of a step, and its start where that is no node, at the nodes
/// of the next step, which is `ratio` times as long.
template <bool starts_at_node, class Real, std::size_t S>
StageWeights<Real, S> continuation(const StageTables<Real, S>& tables, Real ratio) {
  StageWeights<Real, S> weight;
  for (std::size_t i = 0; i < S; ++i) {
    const Real x = 1 + tables.c[i] * ratio;
    for (std::size_t j = 0; j < S; ++j) {
      Real product = starts_at_node ? tables.extrapolate[j] : tables.extrapolate[j] * x;
      for (std::size_t m = 0; m < S; ++m)
        if (m != j) product *= x - tables.c[m];
      weight[i][j] = product;
    }
  }
  return weight;
}

/// f(row, other row, re, im) for every mode with its shift over h; a real mode has one row and no im.
template <std::size_t real_modes, class Real, std::size_t S, class F>
void for_each_shift(const StageTables<Real, S>& tables, Real h, const F& f) {
  for (std::size_t m = 0; m < real_modes; ++m) f(m, m, tables.shift_re[m] / h, Real(0));
  for (std::size_t p = 0; p < (S - real_modes) / 2; ++p) {
    const std::size_t row = real_modes + 2 * p, mode = real_modes + p;
    f(row, row + 1, tables.shift_re[mode] / h, tables.shift_im[mode] / h);
  }
}

/// r = modes of h A f - z, times shift / h: exact in the coefficients that the method is defined by.
template <std::size_t real_modes, class Real, class State, std::size_t S>
void residual_by_stages(const StageTables<Real, S>& tables, Real h, const std::array<State, S>& f,
                        const std::array<State, S>& z, std::array<State, S>& r) {
  for_each_component(r[0], [&](std::size_t n) {
    std::array<Real, S> off;
    for (std::size_t i = 0; i < S; ++i) {
      Real sum = tables.a[i][0] * f[0].data()[n];
      for (std::size_t j = 1; j < S; ++j) sum += tables.a[i][j] * f[j].data()[n];
      off[i] = h * sum - z[i].data()[n];
    }
    for (std::size_t m = 0; m < S; ++m) {
      Real sum = tables.into[m][0] * off[0];
      for (std::size_t j = 1; j < S; ++j) sum += tables.into[m][j] * off[j];
      r[m].data()[n] = sum;
    }
  });
  for_each_shift<real_modes>(tables, h, [&](std::size_t row, std::size_t other, Real re, Real im) {
    if (row == other && re == 0) return;  // an explicit mode: its correction is the residual itself
    for_each_component(r[0], [&](std::size_t n) {
      const Real x = r[row].data()[n];
      if (row == other) {
        r[row].data()[n] = re * x;
      } else {
        const Real y = r[other].data()[n];
        r[row].data()[n] = re * x - im * y, r[other].data()[n] = re * y + im * x;
      }
    });
  });
}

/// The same without going back to the stages: modes of f, less shift / h times the modes w of z.
template <std::size_t real_modes, class Real, class State, std::size_t S>
void residual_by_modes(const StageTables<Real, S>& tables, Real h, const std::array<State, S>& f,
                       const std::array<State, S>& w, std::array<State, S>& r) {
  combine_stages(tables.into, f, r);
  for_each_shift<real_modes>(tables, h, [&](std::size_t row, std::size_t other, Real re, Real im) {
    for_each_component(r[0], [&](std::size_t n) {
      const Real x = w[row].data()[n];
      if (row == other) {
        r[row].data()[n] -= re * x;
      } else {
        const Real y = w[other].data()[n];
        r[row].data()[n] -= re * x - im * y, r[other].data()[n] -= re * y + im * x;
      }
    });
  });
}

}  // namespace odemark
