// The sine modes of n equal cells between two fixed ends, for any n at run time.
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "problems/elliptic.hpp"

namespace odemark {

/// sin(i mode pi/(n + 1)), i = 1 .. n: as exact as the sine of a first-quadrant angle, because whole turns
/// are taken off in whole numbers.
template <class T>
T mode_sine(std::size_t i, std::size_t mode, std::size_t n) {
  using std::sin;
  const std::size_t half_turn = n + 1, place = i * mode % (2 * half_turn);
  const std::size_t folded = std::min(place % half_turn, half_turn - place % half_turn);
  const T size = sin(elliptic::pi<T>() * T(int(folded)) / T(int(half_turn)));
  return place > half_turn ? T(-size) : size;
}

/// amplitude[k - 1] = 2/(n + 1) sum_i sin(i k pi/(n + 1)) y[i - 1], and back without the factor. O(n^2).
template <class T>
std::vector<T> mode_amplitudes(std::size_t n, const T* y) {
  std::vector<T> amplitude(n);
  for (std::size_t k = 1; k <= n; ++k) {
    T sum(0);
    for (std::size_t i = 1; i <= n; ++i) sum = sum + mode_sine<T>(i, k, n) * y[i - 1];
    amplitude[k - 1] = sum * 2 / T(int(n + 1));
  }
  return amplitude;
}
template <class T>
void sum_of_modes(std::size_t n, const std::vector<T>& amplitude, T* y) {
  for (std::size_t i = 1; i <= n; ++i) {
    T sum(0);
    for (std::size_t k = 1; k <= n; ++k) sum = sum + mode_sine<T>(i, k, n) * amplitude[k - 1];
    y[i - 1] = sum;
  }
}

/// 2 sin(k pi/(2 (n + 1))): mode k turns at this multiple of sqrt(rate), and fades at its square times rate.
template <class T>
T mode_number(std::size_t k, std::size_t n) {
  using std::sin;
  return 2 * sin(elliptic::pi<T>() * T(int(k)) / T(int(2 * (n + 1))));
}

/// y_(i-1) - 2 y_i + y_(i+1) with 0 beyond both ends, into out.
template <class T>
void second_difference(std::size_t n, const T* y, T* out) {
  if (n == 1) {
    out[0] = -(2 * y[0]);
    return;
  }
  out[0] = y[1] - 2 * y[0];
  for (std::size_t i = 1; i + 1 < n; ++i) out[i] = (y[i - 1] + y[i + 1]) - 2 * y[i];
  out[n - 1] = y[n - 2] - 2 * y[n - 1];
}
/// The matrix of that times `rate`, in the rows from `first_row` on.
template <class T, class L>
void second_difference_matrix(std::size_t n, const T& rate, std::size_t first_row, L&& l) {
  for (std::size_t i = 0; i < n; ++i) {
    l(first_row + i, i) = -(2 * rate);
    if (i > 0) l(first_row + i, i - 1) = rate;
    if (i + 1 < n) l(first_row + i, i + 1) = rate;
  }
}

}  // namespace odemark
