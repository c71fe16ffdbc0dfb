// Taylor coefficients of the solution of y' = f(t, y), computed from the tape of f.
#pragma once

#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "integrators/tape.hpp"

namespace odemark {

/// Taylor coefficients of the solution of y' = f(t, y) through (t, y), order by order: coefficient k of every
/// entry needs only coefficients up to k (A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed. (SIAM,
/// 2008), ch. 13). Cost grows with the square of the order. Everything is allocated in the constructor.
template <class T>
class TaylorSeries {
 public:
  TaylorSeries(const Tape<T>& tape, std::size_t size, int highest_order)
      : tape_(tape),
        order_(highest_order),
        stride_(std::size_t(highest_order) + 1),
        rows_(tape.entries.size() * stride_, T(0)),
        state_(size * stride_, T(0)) {}

  /// Fills coefficients 0 .. order; coefficient k of component i is y^(k)/k!.
  void expand(const T& t, const T* y, int order) {
    assert(order <= order_);
    const std::size_t size = state_.size() / stride_;
    for (std::size_t i = 0; i < size; ++i) state_[i * stride_] = y[i];
    time_ = t;
    for (int k = 0; k < order; ++k) {
      for (std::size_t e = 0; e < tape_.entries.size(); ++e) fill(e, std::size_t(k));
      for (std::size_t i = 0; i < size; ++i)
        state_[i * stride_ + std::size_t(k) + 1] = row(tape_.outputs[i])[k] / T(k + 1);
    }
  }
  const T& coefficient(std::size_t component, int k) const {
    return state_[component * stride_ + std::size_t(k)];
  }
  /// Of an entry of the tape; known up to one order less than the state.
  const T& entry_coefficient(std::size_t entry, int k) const {
    return rows_[entry * stride_ + std::size_t(k)];
  }

 private:
  T* row(std::size_t entry) { return &rows_[entry * stride_]; }

  /// Coefficient k of entry e from coefficients 0..k of its operands and 0..k-1 of its own.
  void fill(std::size_t e, std::size_t k) {
    using std::atan, std::cos, std::cosh, std::exp, std::log, std::pow, std::sin, std::sinh, std::sqrt,
        std::tanh;
    const TapeEntry<T>& entry = tape_.entries[e];
    T* out = row(e);
    const T* a = row(entry.left);
    const T* b = row(entry.right);
    switch (entry.op) {
      case TapeOp::constant: out[k] = k == 0 ? entry.value : T(0); break;
      case TapeOp::time: out[k] = k == 0 ? time_ : T(k == 1 ? 1 : 0); break;
      case TapeOp::state: out[k] = state_[entry.left * stride_ + k]; break;
      case TapeOp::add: out[k] = a[k] + b[k]; break;
      case TapeOp::subtract: out[k] = a[k] - b[k]; break;
      case TapeOp::negate: out[k] = -a[k]; break;
      case TapeOp::multiply: {
        T sum = a[0] * b[k];
        for (std::size_t j = 1; j <= k; ++j) sum += a[j] * b[k - j];
        out[k] = sum;
        break;
      }
      case TapeOp::divide: {
        T sum = a[k];
        for (std::size_t j = 1; j <= k; ++j) sum -= b[j] * out[k - j];
        out[k] = sum / b[0];
        break;
      }
      case TapeOp::square_root: {
        if (k == 0) {
          out[0] = sqrt(a[0]);
          break;
        }
        T sum = a[k];
        for (std::size_t j = 1; j < k; ++j) sum -= out[j] * out[k - j];
        out[k] = sum / (2 * out[0]);
        break;
      }
      case TapeOp::exponential: out[k] = k == 0 ? T(exp(a[0])) : weighted(a, out, k) / T(int(k)); break;
      case TapeOp::logarithm: out[k] = k == 0 ? T(log(a[0])) : quadrature(a, a, out, k); break;
      case TapeOp::arc_tangent: out[k] = k == 0 ? T(atan(a[0])) : quadrature(a, b, out, k); break;
      case TapeOp::sine: out[k] = k == 0 ? T(sin(a[0])) : weighted(a, b, k) / T(int(k)); break;
      case TapeOp::cosine: out[k] = k == 0 ? T(cos(a[0])) : -weighted(a, b, k) / T(int(k)); break;
      case TapeOp::hyperbolic_sine: out[k] = k == 0 ? T(sinh(a[0])) : weighted(a, b, k) / T(int(k)); break;
      case TapeOp::hyperbolic_cosine: out[k] = k == 0 ? T(cosh(a[0])) : weighted(a, b, k) / T(int(k)); break;
      case TapeOp::hyperbolic_tangent:  // y' = x' - x' y^2
        out[k] = k == 0 ? T(tanh(a[0])) : a[k] - weighted(a, b, k) / T(int(k));
        break;
      case TapeOp::power: {  // y' x = p x' y
        if (k == 0) {
          out[0] = pow(a[0], entry.value);
          break;
        }
        T sum = T(0);
        for (std::size_t j = 1; j <= k; ++j)
          sum += (entry.value * T(int(j)) - T(int(k - j))) * a[j] * out[k - j];
        out[k] = sum / (T(int(k)) * a[0]);
        break;
      }
      case TapeOp::absolute: out[k] = a[0] < 0 ? T(-a[k]) : a[k]; break;
    }
  }
  /// y' = a'/b, coefficient k > 0 of y.
  static T quadrature(const T* a, const T* b, const T* y, std::size_t k) {
    T sum = T(int(k)) * a[k];
    for (std::size_t j = 1; j < k; ++j) sum -= T(int(j)) * y[j] * b[k - j];
    return sum / (T(int(k)) * b[0]);
  }
  /// sum_{j=1..k} j a_j b_{k-j}: coefficient k - 1 of a' b.
  static T weighted(const T* a, const T* b, std::size_t k) {
    T sum = a[1] * b[k - 1];
    for (std::size_t j = 2; j <= k; ++j) sum += T(int(j)) * a[j] * b[k - j];
    return sum;
  }

  const Tape<T>& tape_;
  int order_;
  std::size_t stride_;
  std::vector<T> rows_, state_;
  T time_{};
};

}  // namespace odemark
