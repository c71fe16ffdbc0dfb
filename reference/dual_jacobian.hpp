// Derivatives of a family's right-hand side by dual numbers.
#pragma once

#include <vector>

#include "integrators/dual.hpp"
#include "reference/family_traits.hpp"

namespace odemark {

/// The Jacobian by dual numbers: what a hand-written one is tested against, and what stands in for a missing
/// one.
template <class T, class F>
void dual_jacobian(const F& family, T t, const T* y, MatrixView<T> j) {
  using Number = Dual<T, F::size>;
  std::array<Number, F::size> state, slope;
  for (std::size_t i = 0; i < F::size; ++i) state[i] = Number::variable(y[i], i);
  family.rhs(Number(t), state.data(), slope.data());
  for (std::size_t row = 0; row < F::size; ++row)
    for (std::size_t column = 0; column < F::size; ++column) j(row, column) = slope[row].partial[column];
}

/// Column by column, where the size is known at run time only: n evaluations.
template <class T, HasRunTimeSize F>
void dual_jacobian(const F& family, T t, const T* y, MatrixView<T> j) {
  using Number = Dual<T, 1>;
  std::vector<Number> state(y, y + j.size), slope(j.size);
  for (std::size_t column = 0; column < j.size; ++column) {
    state[column] = Number::variable(y[column], 0);
    family.rhs(Number(t), state.data(), slope.data());
    for (std::size_t row = 0; row < j.size; ++row) j(row, column) = slope[row].partial[0];
    state[column] = Number(y[column]);
  }
}

/// df/dt by dual numbers.
template <class T, class F>
void dual_time_derivative(const F& family, T t, const T* y, T* dfdt) {
  using Number = Dual<T, 1>;
  std::array<Number, F::size> state, slope;
  for (std::size_t i = 0; i < F::size; ++i) state[i] = Number(y[i]);
  family.rhs(Number::variable(t, 0), state.data(), slope.data());
  for (std::size_t i = 0; i < F::size; ++i) dfdt[i] = slope[i].partial[0];
}

template <class T, HasRunTimeSize F>
void dual_time_derivative(const F& family, T t, const T* y, T* dfdt) {
  using Number = Dual<T, 1>;
  const std::size_t n = family.size();
  std::vector<Number> state(y, y + n), slope(n);
  family.rhs(Number::variable(t, 0), state.data(), slope.data());
  for (std::size_t i = 0; i < n; ++i) dfdt[i] = slope[i].partial[0];
}

}  // namespace odemark
