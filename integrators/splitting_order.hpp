// The order of a splitting, proved from its drifts and kicks: for any exp(A + B), and for x'' = a(t, x).
#pragma once

#include "integrators/nystrom_order.hpp"
#include "integrators/splitting.hpp"

namespace odemark {

/// For any two flows, that is any H = T(v) + V(x): the product of the exponentials as a series of words in A
/// (drift) and B (kick), cut after `highest` letters, against exp(A + B), in which every word of n letters
/// has the coefficient 1/n!; `highest` is at most 9 (the conditions of HLW, Geometric Numerical Integration,
/// III.5, all at once; the words that are no Lyndon words follow from the others and do no harm).
template <std::size_t Length>
constexpr int separable_order(const Splitting<Length>& m, int highest) {
  // a word of n letters is the number whose bits it is, last letter lowest, below a leading 1
  constexpr std::size_t most = std::size_t(2) << 9;
  std::array<Coefficient, most> series{}, size{};
  series[1] = size[1] = 1;
  const std::size_t words = std::size_t(2) << highest;
  const auto multiply = [&](std::size_t letter, Coefficient weight) {
    if (weight == 0) return;
    // longest words first: what they take from shorter ones is still that of before
    for (std::size_t word = words - 1; word > 1; --word) {
      Coefficient factor = 1, n = 0;
      for (std::size_t rest = word; rest > 1 && (rest & 1) == letter;) {
        rest >>= 1, n += 1, factor *= weight / n;
        series[word] += factor * series[rest];
        size[word] += (factor < 0 ? -factor : factor) * size[rest];
      }
    }
  };
  for (std::size_t i = 0; i < Length; ++i) multiply(0, m.drift[i]), multiply(1, m.kick[i]);
  Coefficient factorial = 1;
  for (int n = 1; n <= highest; ++n) {
    factorial *= Coefficient(n);
    for (std::size_t word = std::size_t(1) << n; word < std::size_t(2) << n; ++word) {
      const Coefficient gap = series[word] - 1 / factorial, scale = 4e-18L * (size[word] + 1 / factorial);
      if (!(gap <= scale && gap >= -scale)) return n - 1;
    }
  }
  return highest;
}

/// The order on x'' = a(t, x), whose kinetic energy is quadratic: then [B, [B, [B, A]]] = 0 and fewer
/// conditions are left, those of the Nystrom method with a stage per kick.
template <std::size_t Length>
constexpr int splitting_order(const Splitting<Length>& m, int highest) {
  std::array<Coefficient, Length> c{}, b_position{};
  std::array<std::array<Coefficient, Length>, Length> a{};
  Coefficient drifted = 0;
  for (std::size_t i = 0; i < Length; ++i) {
    drifted += m.drift[i];
    c[i] = drifted;
    for (std::size_t j = 0; j < i; ++j) a[i][j] = m.kick[j] * (c[i] - c[j]);
  }
  for (std::size_t i = 0; i < Length; ++i) b_position[i] = m.kick[i] * (1 - c[i]);
  return m.consistent() ? nystrom_order(a, c, b_position, m.kick, highest) : 0;
}

/// Has the splitting exactly the order it claims on x'' = a(t, x)? A wrong digit does not compile.
template <std::size_t Length>
constexpr bool orders_hold(const Splitting<Length>& m) {
  return splitting_order(m, m.order + 1) == m.order;
}

}  // namespace odemark
