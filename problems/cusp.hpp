// Nerve impulses by Zeeman's cusp catastrophe, coupled round a ring: jumps that come and go, very stiff.
#pragma once
#include "problems/elliptic.hpp"
#include "problems/numbered.hpp"

namespace odemark {

/// State: y at 8 places of a ring, then a, then b. y follows y^3 + a y + b = 0 within eps.
template <class Real = double>
struct Cusp {
  static constexpr std::string_view id = "cusp";
  static constexpr std::string_view title = "Cusp catastrophe on a ring of eight";
  static constexpr std::string_view equations =
      "yi' = -(yi^3 + ai yi + bi)/eps + D L yi;  ai' = bi + 0.07 vi + D L ai;  bi' = (1 - ai^2) bi - ai - "
      "0.4 yi + 0.035 "
      "vi + D L bi,  vi = ui/(ui + 0.1), ui = (yi - 0.7)(yi - 1.3), L xi = x(i-1) - 2 xi + x(i+1), D = "
      "n^2/144, n = 8;  "
      "yi(0) = 0, ai(0) = -2 cos(2 i pi/n), bi(0) = 2 sin(2 i pi/n)";
  static constexpr std::string_view source =
      "E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed. (Springer, 1996), IV.10, "
      "doi:10.1007/978-3-642-05221-7 (there with n = 32)";
  static constexpr std::size_t places = 8, size = 3 * places;
  static constexpr std::array<Component, size> components =
      joined(numbered<"y", places>(""), numbered<"a", places>(""), numbered<"b", places>(""));

  Real eps = Real(1) / 10000, t_end = Real(11) / 10;

  static constexpr auto parameters() {
    using P = Parameter<Cusp, Real>;
    return std::array{P{"eps", "", "time in which y comes to the cusp surface", &Cusp::eps, positive},
                      P{"t_end", "", "end of the interval", &Cusp::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"cusp", "eps=0.0009765625,t_end=1", "a tenth as stiff as in the book, and nearly as long"},
      Preset{"cusp_mild", "eps=0.015625,t_end=1", "the jumps are rounded: hardly stiff"},
      Preset{"cusp_stiff", "eps=1e-4,t_end=0.125",
             "as in the book but for the end and the number of places"}};

  std::array<double, size> scale() const {
    std::array<double, size> out{};
    out.fill(2);
    return out;
  }
  double suggested_dt() const { return 0.015625 * double(eps); }

  template <class T>
  void initial(T* y) const {
    using std::cos, std::sin;
    for (std::size_t i = 0; i < places; ++i) {
      const T angle = 2 * elliptic::pi<T>() * int(i + 1) / int(places);
      y[i] = T(0), y[i + places] = -2 * cos(angle), y[i + 2 * places] = 2 * sin(angle);
    }
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T spread = T(Real(int(places * places)) / Real(144));
    for (std::size_t part = 0; part < size; part += places)
      for (std::size_t i = 0; i < places; ++i)
        dydt[part + i] =
            spread * (y[part + (i + 1) % places] - 2 * y[part + i] + y[part + (i + places - 1) % places]);
    for (std::size_t i = 0; i < places; ++i) {
      const T &x = y[i], &a = y[i + places], &b = y[i + 2 * places];
      const T u = (x - of<T>(7, 10)) * (x - of<T>(13, 10)), v = u / (u + of<T>(1, 10));
      T &dx = dydt[i], &da = dydt[i + places], &db = dydt[i + 2 * places];
      dx = dx - (x * (x * x + a) + b) / T(eps);
      da = da + (b + of<T>(7, 100) * v);
      db = db + ((1 - a * a) * b - a - of<T>(4, 10) * x + of<T>(35, 1000) * v);
    }
  }

 private:
  /// Published with a few decimals; rounded where the parameters are.
  template <class T>
  static T of(int numerator, int denominator) {
    return T(Real(numerator) / Real(denominator));
  }
};

}  // namespace odemark
