// Problem E5 of the stiff DETEST set: concentrations from 1e-3 down to 1e-20, and a difference that cancels.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State: concentrations of four species. y2 - y3 - y4 stays 0; in double precision it drifts by rounding
/// alone, so that runs beyond t = 1e5 measure luck.
template <class Real = double>
struct E5 {
  static constexpr std::string_view id = "e5";
  static constexpr std::string_view title = "Chemical reaction E5";
  static constexpr std::string_view equations =
      "y1' = -A y1 - B y1 y3;  y2' = A y1 - M C y2 y3;  y3' = y2' - y4';  y4' = B y1 y3 - C y4;  y(0) = (y1, "
      "0, 0, 0)";
  static constexpr std::string_view source =
      "W. H. Enright, T. E. Hull, B. Lindberg, BIT 15 (1975) 10-48, doi:10.1007/BF01932994; F. Mazzia, C. "
      "Magherini, "
      "Test Set for Initial Value Problem Solvers, release 2.4 (2008), problem e5";
  static constexpr std::size_t size = 4;
  static constexpr std::array<Component, size> components{{{"y1", ""}, {"y2", ""}, {"y3", ""}, {"y4", ""}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"balance"};

  Real A = Real(789) / 1000000000000, B = 11000000, C = 1130, M = 1000000, y1 = Real(176) / 100000,
       t_end = 100000;

  static constexpr auto parameters() {
    using P = Parameter<E5, Real>;
    return std::array{P{"A", "1/s", "rate of the slow decay of y1", &E5::A, positive},
                      P{"B", "1/s", "rate of 1 + 3 -> 4", &E5::B, positive},
                      P{"C", "1/s", "rate of 4 -> 3", &E5::C, positive},
                      P{"M", "", "M C is the rate of 2 + 3 -> nothing", &E5::M, positive},
                      P{"y1", "", "initial y1", &E5::y1, positive},
                      P{"t_end", "s", "end of the interval", &E5::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"e5", "A=7.89e-10,y1=1.76e-3", "to where double precision still has the digits"},
      Preset{"e5_t1000", "A=7.89e-10,y1=1.76e-3,t_end=1000", "the end of STIFF DETEST"}};

  std::array<double, size> scale() const { return {1.76e-3, 1e-9, 1e-11, 1e-9}; }
  double suggested_dt() const { return 1e-6; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(y1), y[1] = T(0), y[2] = T(0), y[3] = T(0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T slow = T(A) * y[0], joined = T(B) * (y[0] * y[2]), parted = T(C) * y[3];
    const T lost = T(M) * T(C) * (y[1] * y[2]);
    dydt[0] = -slow - joined;
    dydt[1] = slow - lost;
    dydt[2] = slow - lost - (joined - parted);
    dydt[3] = joined - parted;
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    const T joined1 = T(B) * y[2], joined3 = T(B) * y[0];
    const T lost2 = T(M) * T(C) * y[2], lost3 = T(M) * T(C) * y[1];
    j(0, 0) = -T(A) - joined1, j(0, 1) = T(0), j(0, 2) = -joined3, j(0, 3) = T(0);
    j(1, 0) = T(A), j(1, 1) = -lost2, j(1, 2) = -lost3, j(1, 3) = T(0);
    j(2, 0) = T(A) - joined1, j(2, 1) = -lost2, j(2, 2) = -lost3 - joined3, j(2, 3) = T(C);
    j(3, 0) = joined1, j(3, 1) = T(0), j(3, 2) = joined3, j(3, 3) = -T(C);
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    out[0] = y[1] - y[2] - y[3];
  }
};

}  // namespace odemark
