// Points that attract one another by Newton's law: what the families of many bodies share.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace odemark {

/// The state is the positions, body after body, then the velocities likewise. gm[i] is the gravitational
/// parameter of body i; energies and momenta are per gravitational constant.
template <std::size_t bodies, std::size_t dimensions>
struct Gravity {
  static constexpr std::size_t half = bodies * dimensions, size = 2 * half;

  template <class T>
  static void acceleration(const std::array<T, bodies>& gm, const T* y, T* a) {
    using std::sqrt;
    for (std::size_t i = 0; i < half; ++i) a[i] = T(0);
    for (std::size_t i = 1; i < bodies; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        std::array<T, dimensions> gap;
        const T r2 = squared_gap(y, i, j, gap), weight = 1 / (r2 * sqrt(r2));
        for (std::size_t k = 0; k < dimensions; ++k) {
          T &here = a[dimensions * i + k], &there = a[dimensions * j + k];
          here = here - gm[j] * weight * gap[k], there = there + gm[i] * weight * gap[k];
        }
      }
  }
  template <class T, class J>
  static void jacobian(const std::array<T, bodies>& gm, const T* y, J&& jac) {
    using std::sqrt;
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column)
        jac(row, column) = row + half == column ? T(1) : T(0);
    for (std::size_t i = 0; i < bodies; ++i)
      for (std::size_t j = 0; j < bodies; ++j) {
        if (i == j) continue;
        std::array<T, dimensions> gap;
        const T r2 = squared_gap(y, i, j, gap), weight = gm[j] / (r2 * sqrt(r2));
        for (std::size_t k = 0; k < dimensions; ++k)
          for (std::size_t l = 0; l < dimensions; ++l) {
            const T tide = (k == l ? weight : T(0)) - 3 * weight / r2 * gap[k] * gap[l];
            const std::size_t row = half + dimensions * i + k;
            jac(row, dimensions * j + l) = tide;
            jac(row, dimensions * i + l) = jac(row, dimensions * i + l) - tide;
          }
      }
  }
  template <class T>
  static T energy(const std::array<T, bodies>& gm, const T* y) {
    using std::sqrt;
    T sum(0);
    for (std::size_t i = 0; i < bodies; ++i) {
      for (std::size_t k = 0; k < dimensions; ++k) {
        const T& v = y[half + dimensions * i + k];
        sum = sum + gm[i] * v * v / 2;
      }
      for (std::size_t j = 0; j < i; ++j) {
        std::array<T, dimensions> gap;
        sum = sum - gm[i] * gm[j] / sqrt(squared_gap(y, i, j, gap));
      }
    }
    return sum;
  }
  /// Component k of the total momentum.
  template <class T>
  static T momentum(const std::array<T, bodies>& gm, const T* y, std::size_t k) {
    T sum(0);
    for (std::size_t i = 0; i < bodies; ++i) sum = sum + gm[i] * y[half + dimensions * i + k];
    return sum;
  }
  /// The total angular momentum about the origin in the plane of the axes k and l.
  template <class T>
  static T spin(const std::array<T, bodies>& gm, const T* y, std::size_t k, std::size_t l) {
    T sum(0);
    for (std::size_t i = 0; i < bodies; ++i) {
      const T *x = y + dimensions * i, *v = y + half + dimensions * i;
      sum = sum + gm[i] * (x[k] * v[l] - x[l] * v[k]);
    }
    return sum;
  }

 private:
  template <class T>
  static T squared_gap(const T* y, std::size_t i, std::size_t j, std::array<T, dimensions>& gap) {
    T r2(0);
    for (std::size_t k = 0; k < dimensions; ++k) {
      gap[k] = y[dimensions * i + k] - y[dimensions * j + k];
      r2 = r2 + gap[k] * gap[k];
    }
    return r2;
  }
};

}  // namespace odemark
