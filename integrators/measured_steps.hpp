// What measurements ask of a stepper beyond running it: values between steps, and one step as a matrix.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "integrators/any_method.hpp"

namespace odemark {

/// An observer that fills a trace. Samples between steps are side steps of the same method from the last
/// accepted state: they have the method's own accuracy and leave the run untouched.
template <class S, class T>
class GridSampler {
 public:
  GridSampler(S& side, std::size_t size, double t0, double t1, const std::vector<T>& model, Trace<T>& trace)
      : side_(side),
        size_(size),
        trace_(trace),
        between_(model),
        error_(model),
        close_(8 * std::numeric_limits<T>::epsilon() * std::max(std::abs(T(t0)), std::abs(T(t1)))) {
    trace.samples.assign(trace.grid.size() * size, std::numeric_limits<T>::quiet_NaN());
  }

  bool operator()(T t_old, const std::vector<T>& y_old, T t_new, const std::vector<T>& y_new) {
    for (; next_ < trace_.grid.size() && T(trace_.grid[next_]) <= t_new + close_; ++next_) {
      const T t = T(trace_.grid[next_]);
      const std::vector<T>* from = &y_new;
      if (t < t_new - close_) {
        if constexpr (HasHistory<S>) {
          continue;  // a step of another size would need another history
        } else {
          side_.start();
          if (side_.attempt(t_old, y_old, t - t_old, between_, error_) != StepStatus::ok) continue;
          from = &between_;
        }
      }
      std::copy(from->begin(), from->end(), trace_.samples.begin() + std::ptrdiff_t(next_ * size_));
    }
    return !trace_.on_step || trace_.on_step(t_new, y_new.data());
  }

 private:
  S& side_;
  std::size_t size_;
  Trace<T>& trace_;
  std::vector<T> between_, error_;
  T close_;
  std::size_t next_ = 0;
};

/// Where the unit vectors go in one step of h on a linear homogeneous system of `n` components.
template <class T, class S>
TransitionMatrix<T> transition_of(S& stepper, std::size_t n, T h) {
  std::vector<T> y(n, T(0)), next(n, T(0)), error(n, T(0));
  TransitionMatrix<T> matrix;
  std::size_t past = 0;
  if constexpr (HasHistory<S>) past = stepper.history_length();
  matrix.size = n * (1 + past);
  for (std::size_t j = 0; j < matrix.size; ++j) {
    std::fill(y.begin(), y.end(), T(0));
    std::fill(error.begin(), error.end(), T(0));
    if (j < n) y[j] = T(1);
    stepper.start();
    if constexpr (HasHistory<S>) {
      stepper.assume_history();
      for (std::size_t k = 0; k < past; ++k)
        for (std::size_t i = 0; i < n; ++i) stepper.history(k)[i] = T(j == n * (1 + k) + i);
    }
    if (stepper.attempt(T(0), y, h, next, error) != StepStatus::ok) matrix.solved = false;
    stepper.accept();
    matrix.columns.insert(matrix.columns.end(), next.begin(), next.end());
    if (j < n) matrix.errors.insert(matrix.errors.end(), error.begin(), error.end());
    if constexpr (HasHistory<S>)
      for (std::size_t k = 0; k < past; ++k)
        matrix.columns.insert(matrix.columns.end(), stepper.history(k).begin(), stepper.history(k).end());
  }
  return matrix;
}

}  // namespace odemark
