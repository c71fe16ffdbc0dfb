// Tableaux of the literature as theories, for facts that are published.
#pragma once

#include <cmath>
#include <vector>

#include "integrators/theory.hpp"

namespace odemark::tableaux {

using Rows = std::vector<std::vector<Coefficient>>;

inline Theory tableau(const Rows& a, const std::vector<Coefficient>& b,
                      const std::vector<Coefficient>& b_embedded = {}) {
  Theory theory;
  const std::size_t s = b.size();
  theory.tableau.stages = s, theory.tableau.b = b, theory.tableau.b_embedded = b_embedded;
  theory.tableau.a.assign(s * s, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a[i].size(); ++j) theory.tableau.a[i * s + j] = a[i][j];
  return theory;
}

/// E. Fehlberg, NASA TR R-315 (1969): order 5, embedded 4.
inline Theory fehlberg54() {
  return tableau({{},
                  {1 / 4.0L},
                  {3 / 32.0L, 9 / 32.0L},
                  {1932 / 2197.0L, -7200 / 2197.0L, 7296 / 2197.0L},
                  {439 / 216.0L, -8, 3680 / 513.0L, -845 / 4104.0L},
                  {-8 / 27.0L, 2, -3544 / 2565.0L, 1859 / 4104.0L, -11 / 40.0L}},
                 {16 / 135.0L, 0, 6656 / 12825.0L, 28561 / 56430.0L, -9 / 50.0L, 2 / 55.0L},
                 {25 / 216.0L, 0, 1408 / 2565.0L, 2197 / 4104.0L, -1 / 5.0L, 0});
}

/// J. R. Cash, A. H. Karp, ACM TOMS 16 (1990) 201-222.
inline Theory cash_karp54() {
  return tableau({{},
                  {1 / 5.0L},
                  {3 / 40.0L, 9 / 40.0L},
                  {3 / 10.0L, -9 / 10.0L, 6 / 5.0L},
                  {-11 / 54.0L, 5 / 2.0L, -70 / 27.0L, 35 / 27.0L},
                  {1631 / 55296.0L, 175 / 512.0L, 575 / 13824.0L, 44275 / 110592.0L, 253 / 4096.0L}},
                 {37 / 378.0L, 0, 250 / 621.0L, 125 / 594.0L, 0, 512 / 1771.0L},
                 {2825 / 27648.0L, 0, 18575 / 48384.0L, 13525 / 55296.0L, 277 / 14336.0L, 1 / 4.0L});
}

/// M. Crouzeix, thesis, Paris 1975: two stages, order 3.
inline Theory crouzeix3() {
  const Coefficient g = (3 + std::sqrt(3.0L)) / 6;
  return tableau({{g}, {1 - 2 * g, g}}, {0.5L, 0.5L});
}

/// R. E. Bank et al., IEEE Trans. CAD 4 (1985) 436-451; the embedding is M. E. Hosea's and L. F. Shampine's,
/// Appl. Numer. Math. 20 (1996) 21-37.
inline Theory tr_bdf2() {
  const Coefficient w = std::sqrt(2.0L) / 4, d = 1 - std::sqrt(2.0L) / 2;
  return tableau({{}, {d, d}, {w, w, d}}, {w, w, d}, {(1 - w) / 3, (3 * w + 1) / 3, d / 3});
}

/// E. Hairer, G. Wanner, Solving ODEs II, table IV.6.5.
inline Theory hairer_wanner_sdirk43() {
  return tableau({{1 / 4.0L},
                  {1 / 2.0L, 1 / 4.0L},
                  {17 / 50.0L, -1 / 25.0L, 1 / 4.0L},
                  {371 / 1360.0L, -137 / 2720.0L, 15 / 544.0L, 1 / 4.0L},
                  {25 / 24.0L, -49 / 48.0L, 125 / 16.0L, -85 / 12.0L, 1 / 4.0L}},
                 {25 / 24.0L, -49 / 48.0L, 125 / 16.0L, -85 / 12.0L, 1 / 4.0L},
                 {59 / 48.0L, -17 / 96.0L, 225 / 32.0L, -85 / 12.0L, 0});
}

inline Theory gauss4() {
  const Coefficient r = std::sqrt(3.0L) / 6;
  return tableau({{0.25L, 0.25L - r}, {0.25L + r, 0.25L}}, {0.5L, 0.5L});
}

inline Theory radau_iia3() {
  return tableau({{5 / 12.0L, -1 / 12.0L}, {3 / 4.0L, 1 / 4.0L}}, {3 / 4.0L, 1 / 4.0L});
}

/// J. F. B. M. Kraaijevanger, BIT 31 (1991) 482-528.
inline Theory ssprk43() {
  return tableau({{}, {0.5L}, {0.5L, 0.5L}, {1 / 6.0L, 1 / 6.0L, 1 / 6.0L}},
                 {1 / 6.0L, 1 / 6.0L, 1 / 6.0L, 0.5L});
}

/// D. I. Ketcheson, SIAM J. Sci. Comput. 30 (2008) 2113-2136.
inline Theory ssprk104() {
  Rows a(10);
  for (std::size_t i = 1; i < 10; ++i)
    for (std::size_t j = 0; j < i; ++j) a[i].push_back(i < 5 || j >= 5 ? 1 / 6.0L : 1 / 15.0L);
  return tableau(a, std::vector<Coefficient>(10, 0.1L));
}

/// A. Prothero's and A. Robinson's kind of linearly implicit method, two stages of order 2 with
/// gamma = 1 - 1/sqrt(2): J. G. Verwer, E. J. Spee, J. G. Blom, W. Hundsdorfer, SIAM J. Sci. Comput. 20
/// (1999) 1456-1480.
inline Theory ros2() {
  const Coefficient g = 1 - std::sqrt(0.5L);
  Theory theory = tableau({{}, {1}}, {0.5L, 0.5L});
  theory.tableau.gamma = {g, 0, -2 * g, g};
  return theory;
}

inline Theory bdf(int steps) {
  static const std::vector<std::pair<std::vector<Coefficient>, Coefficient>> all{
      {{-1, 1}, 1},
      {{1, -4, 3}, 2},
      {{-2, 9, -18, 11}, 6},
      {{3, -16, 36, -48, 25}, 12},
      {{-12, 75, -200, 300, -300, 137}, 60},
      {{10, -72, 225, -400, 450, -360, 147}, 60}};
  Theory theory;
  theory.rho = all[std::size_t(steps - 1)].first;
  theory.sigma.assign(theory.rho.size(), 0);
  theory.sigma.back() = all[std::size_t(steps - 1)].second;
  return theory;
}

}  // namespace odemark::tableaux
