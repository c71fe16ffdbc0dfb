// A right-hand side written down as a list of operations.
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace odemark {

/// What one entry of a tape does with the entries before it. Some need a second series beside that of their
/// argument, which `right` names: sines and cosines, also hyperbolic ones, come in pairs; a hyperbolic
/// tangent needs its own square, an arc tangent 1 + x^2.
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
  hyperbolic_sine,
  hyperbolic_cosine,
  hyperbolic_tangent,
  arc_tangent,
  power,
  absolute
};

template <class T>
struct TapeEntry {
  TapeOp op;
  std::size_t left = 0, right = 0;  // entries; for `state` left is the component
  T value{};                        // for `constant`; the exponent of a `power`
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
    return x.is_constant() ? Recorded(T(sin(x.value_))) : pair(x, TapeOp::sine, TapeOp::cosine, 0);
  }
  friend Recorded cos(const Recorded& x) {
    using std::cos;
    return x.is_constant() ? Recorded(T(cos(x.value_))) : pair(x, TapeOp::sine, TapeOp::cosine, 1);
  }
  friend Recorded sinh(const Recorded& x) {
    using std::sinh;
    return x.is_constant() ? Recorded(T(sinh(x.value_)))
                           : pair(x, TapeOp::hyperbolic_sine, TapeOp::hyperbolic_cosine, 0);
  }
  friend Recorded cosh(const Recorded& x) {
    using std::cosh;
    return x.is_constant() ? Recorded(T(cosh(x.value_)))
                           : pair(x, TapeOp::hyperbolic_sine, TapeOp::hyperbolic_cosine, 1);
  }
  friend Recorded tanh(const Recorded& x) {
    using std::tanh;
    if (x.is_constant()) return Recorded(T(tanh(x.value_)));
    const std::size_t own = x.tape_->push(TapeOp::hyperbolic_tangent, x.entry_, x.tape_->entries.size() + 1);
    x.tape_->push(TapeOp::multiply, own, own);
    return {*x.tape_, own};
  }
  friend Recorded atan(const Recorded& x) {
    using std::atan;
    if (x.is_constant()) return Recorded(T(atan(x.value_)));
    const Recorded slope_below = T(1) + x * x;
    return {*x.tape_, x.tape_->push(TapeOp::arc_tangent, x.entry_, slope_below.entry_)};
  }
  /// x^p for a constant p and x > 0; a negative x only where it is a constant.
  friend Recorded pow(const Recorded& x, const Recorded& p) {
    using std::pow;
    if (!p.is_constant()) return exp(p * log(x));
    if (x.is_constant()) return Recorded(T(pow(x.value_, p.value_)));
    return {*x.tape_, x.tape_->push(TapeOp::power, x.entry_, 0, p.value_)};
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
  /// Two functions that are each other's derivative but for signs; the one that is wanted.
  static Recorded pair(const Recorded& x, TapeOp first, TapeOp second, std::size_t wanted) {
    const std::size_t at = x.tape_->push(first, x.entry_, x.tape_->entries.size() + 1);
    x.tape_->push(second, x.entry_, at);
    return {*x.tape_, at + wanted};
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

}  // namespace odemark
