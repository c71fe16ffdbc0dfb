// Fills a trace from a run: values between steps by side steps of the same method.
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
        if (keeps_history(side_)) continue;  // a step of another size would need another history
        side_.start();
        if (side_.attempt(t_old, y_old, t - t_old, between_, error_) != StepStatus::ok) continue;
        from = &between_;
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

}  // namespace odemark
