// A right-hand side written down as a list of operations, and its Taylor coefficients computed from that
// list.
#pragma once

#include <cassert>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace odemark {

/// What one entry of a tape does with the entries before it. `sin` and `cos` come in pairs: each needs the
/// other.
enum class TapeOp {
  constant,
  time,
  state,
  add,
  subtract,
  multiply,
  divide,
  negate,
  square_root,
  exponential,
  logarithm,
  sine,
  cosine,
  absolute
};

template <class T>
struct TapeEntry {
  TapeOp op;
  std::size_t left = 0, right = 0;  // entries; for `state` left is the component
  T value{};                        // for `constant`
};

/// Straight-line code for dy/dt = f(t, y) with constants of type T: no branches, so valid for every t and y.
template <class T>
struct Tape {
  std::vector<TapeEntry<T>> entries;
  std::vector<std::size_t> outputs;  // entry of each component of dydt

  std::size_t push(TapeOp op, std::size_t left = 0, std::size_t right = 0, T value = T(0)) {
    entries.push_back({op, left, right, value});
    return entries.size() - 1;
  }
};

/// The number type that records: running `rhs` on it fills the tape it points to. Numbers without a tape are
/// constants; they join the tape of the first partner that has one.
template <class T>
class Recorded {
 public:
  Recorded() = default;
  Recorded(const T& value) : value_(value) {}
  template <class U>
  requires(std::is_arithmetic_v<U> && !std::is_same_v<U, T>) explicit(!std::is_integral_v<U>)
      Recorded(U value)
      : value_(static_cast<T>(value)) {}
  Recorded(Tape<T>& tape, std::size_t entry) : tape_(&tape), entry_(entry) {}

  std::size_t entry_on(Tape<T>& tape) const {
    return tape_ ? entry_ : tape.push(TapeOp::constant, 0, 0, value_);
  }
  bool is_constant() const { return tape_ == nullptr; }
  const T& value() const { return value_; }

  Recorded operator-() const { return unary(TapeOp::negate, *this, -value_); }
  Recorded& operator+=(const Recorded& o) { return *this = *this + o; }
  Recorded& operator-=(const Recorded& o) { return *this = *this - o; }
  Recorded& operator*=(const Recorded& o) { return *this = *this * o; }
  Recorded& operator/=(const Recorded& o) { return *this = *this / o; }
  friend Recorded operator+(const Recorded& a, const Recorded& b) {
    return binary(TapeOp::add, a, b, a.value_ + b.value_);
  }
  friend Recorded operator-(const Recorded& a, const Recorded& b) {
    return binary(TapeOp::subtract, a, b, a.value_ - b.value_);
  }
  friend Recorded operator*(const Recorded& a, const Recorded& b) {
    return binary(TapeOp::multiply, a, b, a.value_ * b.value_);
  }
  friend Recorded operator/(const Recorded& a, const Recorded& b) {
    return binary(TapeOp::divide, a, b, b.is_constant() ? T(a.value_ / b.value_) : T(0));
  }
  friend Recorded sqrt(const Recorded& x) {
    using std::sqrt;
    return unary(TapeOp::square_root, x, x.is_constant() ? T(sqrt(x.value_)) : T(0));
  }
  friend Recorded exp(const Recorded& x) {
    using std::exp;
    return unary(TapeOp::exponential, x, x.is_constant() ? T(exp(x.value_)) : T(0));
  }
  friend Recorded log(const Recorded& x) {
    using std::log;
    return unary(TapeOp::logarithm, x, x.is_constant() ? T(log(x.value_)) : T(0));
  }
  friend Recorded abs(const Recorded& x) {
    using std::abs;
    return unary(TapeOp::absolute, x, T(abs(x.value_)));
  }
  friend Recorded sin(const Recorded& x) {
    using std::sin;
    return trigonometric(x, x.is_constant() ? T(sin(x.value_)) : T(0), false);
  }
  friend Recorded cos(const Recorded& x) {
    using std::cos;
    return trigonometric(x, x.is_constant() ? T(cos(x.value_)) : T(0), true);
  }

 private:
  static Recorded binary(TapeOp op, const Recorded& a, const Recorded& b, const T& folded) {
    Tape<T>* tape = a.tape_ ? a.tape_ : b.tape_;
    if (!tape) return folded;
    const std::size_t left = a.entry_on(*tape), right = b.entry_on(*tape);
    return {*tape, tape->push(op, left, right)};
  }
  static Recorded unary(TapeOp op, const Recorded& x, const T& folded) {
    if (!x.tape_) return folded;
    return {*x.tape_, x.tape_->push(op, x.entry_)};
  }
  static Recorded trigonometric(const Recorded& x, const T& folded, bool cosine) {
    if (!x.tape_) return folded;
    const std::size_t s = x.tape_->push(TapeOp::sine, x.entry_, x.tape_->entries.size() + 1);
    x.tape_->push(TapeOp::cosine, x.entry_, s);
    return {*x.tape_, s + (cosine ? 1 : 0)};
  }

  T value_{};
  Tape<T>* tape_ = nullptr;
  std::size_t entry_ = 0;
};

/// Records f of a family: `rhs(t, y, dydt)` is called once with recording numbers.
template <class T, class Family>
Tape<T> record(const Family& family, std::size_t size) {
  Tape<T> tape;
  const Recorded<T> time(tape, tape.push(TapeOp::time));
  std::vector<Recorded<T>> y, dydt(size);
  for (std::size_t i = 0; i < size; ++i) y.emplace_back(tape, tape.push(TapeOp::state, i));
  family.rhs(time, y.data(), dydt.data());
  for (const auto& component : dydt) tape.outputs.push_back(component.entry_on(tape));
  return tape;
}

/// Does any output, or anything on the way to one, depend on t? Entry 0 of a recording is the time.
template <class T>
bool reads_time(const Tape<T>& tape) {
  std::vector<char> reads(tape.entries.size(), 0);
  for (std::size_t e = 0; e < reads.size(); ++e) {
    const TapeEntry<T>& entry = tape.entries[e];
    switch (entry.op) {
      case TapeOp::time: reads[e] = 1; break;
      case TapeOp::constant:
      case TapeOp::state: break;
      case TapeOp::add:
      case TapeOp::subtract:
      case TapeOp::multiply:
      case TapeOp::divide: reads[e] = reads[entry.left] | reads[entry.right]; break;
      default: reads[e] = reads[entry.left];
    }
  }
  for (const std::size_t output : tape.outputs)
    if (reads[output]) return true;
  return false;
}

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
    using std::cos, std::exp, std::log, std::sin, std::sqrt;
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
      case TapeOp::logarithm: {
        if (k == 0) {
          out[0] = log(a[0]);
          break;
        }
        T sum = T(int(k)) * a[k];
        for (std::size_t j = 1; j < k; ++j) sum -= T(int(j)) * out[j] * a[k - j];
        out[k] = sum / (T(int(k)) * a[0]);
        break;
      }
      case TapeOp::sine: out[k] = k == 0 ? T(sin(a[0])) : weighted(a, row(entry.right), k) / T(int(k)); break;
      case TapeOp::cosine:
        out[k] = k == 0 ? T(cos(a[0])) : -weighted(a, row(entry.right), k) / T(int(k));
        break;
      case TapeOp::absolute: out[k] = a[0] < 0 ? T(-a[k]) : a[k]; break;
    }
  }
  /// sum_{j=1..k} j a_j b_{k-j}: the recurrence of exp, sin and cos.
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
