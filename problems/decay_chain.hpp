// A radioactive chain of equal rates: a Jordan block, the most non-normal of matrices.
#pragma once
#include "problems/numbered.hpp"

namespace odemark {

/// State: how much there is of each of ten substances; the last is stable.
template <class Real = double>
struct DecayChain {
  static constexpr std::string_view id = "decay_chain";
  static constexpr std::string_view title = "Radioactive decay chain (DETEST C1)";
  static constexpr std::string_view equations =
      "y1' = -k y1;  yi' = k (y(i-1) - yi), i = 2..9;  y10' = k y9;  y1(0) = 1, the others 0";
  static constexpr std::string_view source =
      "C1 of DETEST, T. E. Hull et al., SIAM J. Numer. Anal. 9 (1972) 603-637, doi:10.1137/0709052";
  static constexpr std::size_t size = 10;
  static constexpr std::array<Component, size> components = numbered<"y", size>("");
  static constexpr std::array<std::string_view, 1> invariant_names{"total"};

  Real k = 1, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<DecayChain, Real>;
    return std::array{P{"k", "1/s", "decay rate of each", &DecayChain::k, positive},
                      P{"t_end", "s", "end of the interval", &DecayChain::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"decay_chain", "", "as published: nearly all has arrived at the end"},
      Preset{"decay_chain_fast", "k=16", "long settled: steps are bounded by stability alone"}};

  std::array<double, size> scale() const {
    std::array<double, size> one;
    one.fill(1);
    return one;
  }
  double suggested_dt() const { return 0.0625 / double(k); }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) y[i] = T(i == 0 ? 1 : 0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = -(T(k) * y[0]);
    for (std::size_t i = 1; i + 1 < size; ++i) dydt[i] = T(k) * (y[i - 1] - y[i]);
    dydt[size - 1] = T(k) * y[size - 2];
  }
  template <class T, class J>
  void jacobian(const T&, const T*, J&& j) const {
    linear_part<T>(j);
  }
  template <class T, class L>
  void linear_part(L&& l) const {
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column)
        l(row, column) = column + 1 == row ? T(k) : column == row && row + 1 < size ? T(-T(k)) : T(0);
  }
  /// The same system with every drive removed: 0 is its fixed point.
  DecayChain homogeneous() const { return *this; }

  /// The exact flow: y0 is the state at t = 0. What was atom j is atom i after i - j decays (Poisson).
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::exp;
    std::array<T, size> share;  // of the substances n decays on
    share[0] = exp(-(T(k) * t));
    for (std::size_t n = 1; n < size; ++n) share[n] = share[n - 1] * (T(k) * t) / int(n);
    T now[size];
    for (std::size_t i = 0; i < size; ++i) {
      now[i] = T(0);
      for (std::size_t j = 0; j <= i && i + 1 < size; ++j) now[i] = now[i] + share[i - j] * y0[j];
    }
    now[size - 1] = y0[size - 1];
    for (std::size_t j = 0; j + 1 < size; ++j) {
      T still = T(0);
      for (std::size_t n = 0; n + j + 1 < size; ++n) still = still + share[n];
      now[size - 1] = now[size - 1] + (1 - still) * y0[j];
    }
    for (std::size_t i = 0; i < size; ++i) y[i] = now[i];
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    out[0] = T(0);
    for (std::size_t i = 0; i < size; ++i) out[0] = out[0] + y[i];
  }
};

}  // namespace odemark
