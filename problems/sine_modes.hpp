// The flow of a chain of equal cells between two cold ends, by its sine modes.
#pragma once
#include <array>
#include <cmath>

#include "problems/elliptic.hpp"

namespace odemark {

/// y_i' = rate (y_{i-1} - 2 y_i + y_{i+1}) with y_0 = y_{n+1} = 0.
template <std::size_t n, class T>
void diffusion_rhs(const T& rate, const T* y, T* dydt) {
  for (std::size_t i = 0; i < n; ++i) {
    T sum = -(2 * y[i]);
    if (i > 0) sum = sum + y[i - 1];
    if (i + 1 < n) sum = sum + y[i + 1];
    dydt[i] = rate * sum;
  }
}

template <std::size_t n, class T, class L>
void diffusion_matrix(const T& rate, L&& l) {
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column < n; ++column)
      l(row, column) = row == column ? -(2 * rate) : row + 1 == column || column + 1 == row ? rate : T(0);
}

/// The state at the time t: mode k is sin(i k pi/(n + 1)) and fades at the rate 4 rate sin^2(k pi/(2 (n +
/// 1))).
template <std::size_t n, class T>
void diffusion_exact(const T& rate, const T& t, const T* y0, T* y) {
  using std::exp, std::sin;
  std::array<T, 2 * n + 2> wave;  // sin(j pi/(n + 1)) over one period
  const T angle = elliptic::pi<T>() / T(int(n + 1));
  for (std::size_t j = 0; j <= n; ++j) {
    wave[j] = sin(T(int(j)) * angle);
    wave[j + n + 1] = -wave[j];
  }
  std::array<T, n> sum;
  for (std::size_t i = 0; i < n; ++i) sum[i] = T(0);
  for (std::size_t k = 1; k <= n; ++k) {
    T amplitude(0);
    for (std::size_t i = 0; i < n; ++i) amplitude = amplitude + wave[(i + 1) * k % wave.size()] * y0[i];
    const T half = sin(T(int(k)) * angle / 2);
    amplitude = amplitude * exp(-(4 * rate * half * half * t)) * 2 / T(int(n + 1));
    for (std::size_t i = 0; i < n; ++i) sum[i] = sum[i] + wave[(i + 1) * k % wave.size()] * amplitude;
  }
  for (std::size_t i = 0; i < n; ++i) y[i] = sum[i];
}

}  // namespace odemark
