// A number that counts: how many operations made it, and how long the chain of them is.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

namespace odemark {

/// Operations by kind, of everything computed since the last reset, on this thread.
struct OperationCounts {
  long add = 0, multiply = 0, divide = 0, root = 0, function = 0;
};

/// `ready` is the earliest cycle at which the value can be known, with latencies of 2 (add), 3 (multiply), 14
/// (divide), 13 (square root) and 40 cycles (a library function): the longest chain of dependent operations
/// so far.
class CountingNumber {
 public:
  CountingNumber() = default;
  CountingNumber(double value) : value_(value) {}
  explicit CountingNumber(int value) : value_(value) {}

  static OperationCounts& counts() {
    static thread_local OperationCounts counts;
    return counts;
  }
  double value() const { return value_; }
  int ready() const { return ready_; }

  CountingNumber operator-() const { return {-value_, ready_}; }
  friend CountingNumber operator+(const CountingNumber& a, const CountingNumber& b) {
    ++counts().add;
    return {a.value_ + b.value_, std::max(a.ready_, b.ready_) + 2};
  }
  friend CountingNumber operator-(const CountingNumber& a, const CountingNumber& b) {
    ++counts().add;
    return {a.value_ - b.value_, std::max(a.ready_, b.ready_) + 2};
  }
  friend CountingNumber operator*(const CountingNumber& a, const CountingNumber& b) {
    ++counts().multiply;
    return {a.value_ * b.value_, std::max(a.ready_, b.ready_) + 3};
  }
  friend CountingNumber operator/(const CountingNumber& a, const CountingNumber& b) {
    ++counts().divide;
    return {a.value_ / b.value_, std::max(a.ready_, b.ready_) + 14};
  }
  template <std::same_as<int> I>
  friend CountingNumber operator*(I a, const CountingNumber& b) {
    return CountingNumber(a) * b;
  }
  template <std::same_as<int> I>
  friend CountingNumber operator-(I a, const CountingNumber& b) {
    return CountingNumber(a) - b;
  }
  template <std::same_as<int> I>
  friend CountingNumber operator/(const CountingNumber& a, I b) {
    return a / CountingNumber(b);
  }
  friend CountingNumber sqrt(const CountingNumber& x) {
    ++counts().root;
    return {std::sqrt(x.value_), x.ready_ + 13};
  }
  friend CountingNumber sin(const CountingNumber& x) { return x.function(std::sin(x.value_)); }
  friend CountingNumber cos(const CountingNumber& x) { return x.function(std::cos(x.value_)); }
  friend CountingNumber exp(const CountingNumber& x) { return x.function(std::exp(x.value_)); }
  friend CountingNumber abs(const CountingNumber& x) { return {std::abs(x.value_), x.ready_}; }

 private:
  CountingNumber(double value, int ready) : value_(value), ready_(ready) {}
  CountingNumber function(double value) const {
    ++counts().function;
    return {value, ready_ + 40};
  }
  double value_ = 0;
  int ready_ = 0;
};

}  // namespace odemark
