// h times sums of phi functions of h L as matrices, computed once per step size and matrix.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

namespace odemark {

/// sum of weight phi_function(scale z) with phi_0 = e^z, phi_k(z) = (phi_(k-1)(z) - 1/(k-1)!)/z: the weight
/// of one slope in an exponential method. Written with phi(), + - and *.
struct PhiSum {
  struct Term {
    long double weight = 0;
    int function = 0;
    long double scale = 1;
  };
  static constexpr std::size_t capacity = 8;
  std::array<Term, capacity> terms{};
  std::size_t count = 0;

  constexpr bool is_zero() const { return count == 0; }
  constexpr PhiSum& add(const Term& term) {
    for (std::size_t i = 0; i < count; ++i)
      if (terms[i].function == term.function && terms[i].scale == term.scale) {
        terms[i].weight += term.weight;
        if (terms[i].weight == 0) terms[i] = terms[--count];
        return *this;
      }
    if (term.weight != 0) terms.at(count++) = term;  // too many terms do not compile
    return *this;
  }
  friend constexpr PhiSum operator+(PhiSum a, const PhiSum& b) {
    for (std::size_t i = 0; i < b.count; ++i) a.add(b.terms[i]);
    return a;
  }
  friend constexpr PhiSum operator*(long double factor, PhiSum a) {
    for (std::size_t i = 0; i < a.count; ++i) a.terms[i].weight *= factor;
    return a;
  }
  friend constexpr PhiSum operator-(const PhiSum& a, const PhiSum& b) { return a + -1.0L * b; }
  /// Its value at z = 0, where phi_k is 1/k!.
  constexpr long double at_zero() const {
    long double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      long double factorial = 1;
      for (int k = 2; k <= terms[i].function; ++k) factorial *= k;
      sum += terms[i].weight / factorial;
    }
    return sum;
  }
};

/// phi_function(scale z) as a sum of one term.
constexpr PhiSum phi(int function, long double scale = 1) { return PhiSum{}.add({1, function, scale}); }

/// Accurate to round-off for all arguments: the highest phi by its Taylor series on a scaled matrix, the
/// lower ones by phi_(k-1)(z) = z phi_k(z) + 1/(k-1)!, then doubling with phi_k(2z) = 2^-k (phi_0(z) phi_k(z)
/// + sum_(j=1..k) phi_j(z)/(k-j)!), so that nothing is ever divided by z (B. Skaflestad, W. M. Wright, Appl.
/// Numer. Math. 59 (2009) 783-799). In long double whatever Real is: a stiff L is doubled back many times.
template <class Real>
class PhiWeights {
 public:
  /// Room for `count` sums, which must outlive this.
  PhiWeights(std::size_t size, const PhiSum* sums, std::size_t count);
  ~PhiWeights();

  /// Column-major storage for L.
  Real* matrix();
  /// No allocation.
  void prepare(Real h);
  /// out += h sum_which(h L) in; nothing where the sum is zero.
  void add_product(std::size_t which, const Real* in, Real* out) const;
  /// out -= L in.
  void subtract_linear(const Real* in, Real* out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

extern template class PhiWeights<float>;
extern template class PhiWeights<double>;
extern template class PhiWeights<long double>;

}  // namespace odemark
