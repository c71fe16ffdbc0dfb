// An attitude that follows prescribed rates: the coning motion by which strapdown algorithms are judged.
#pragma once
#include "problems/family.hpp"

namespace odemark {

/// State q, scalar first. Every axis comes back after a turn, the quaternion only where the rates are
/// integrated right: what is lost shows as a drift about the axis of the cone.
template <class Real = double>
struct ConingMotion {
  static constexpr std::string_view id = "coning_motion";
  static constexpr std::string_view title = "Coning motion of an attitude";
  static constexpr std::string_view equations =
      "q' = q (0, w)/2,  w = W (-sin a sin W t, sin a cos W t, -2 sin^2 (a/2))";
  static constexpr std::string_view source =
      "J. E. Bortz, IEEE Trans. Aerosp. Electron. Syst. 7 (1971) 61-66, doi:10.1109/TAES.1971.310252; P. G. "
      "Savage, "
      "J. Guid. Control Dyn. 21 (1998) 19-28, doi:10.2514/2.4228";
  static constexpr std::size_t size = 4;
  static constexpr std::array<Component, size> components{{{"q0", ""}, {"q1", ""}, {"q2", ""}, {"q3", ""}}};
  static constexpr std::array<std::string_view, 1> invariant_names{"norm_squared"};

  Real h = Real(3) / 128, W = 64, t_end = 2;

  static constexpr auto parameters() {
    using P = Parameter<ConingMotion, Real>;
    return std::array{P{"h", "", "tangent of a quarter of the half-angle of the cone", &ConingMotion::h},
                      P{"W", "rad/s", "rate of the coning", &ConingMotion::W, positive},
                      P{"t_end", "s", "end of the interval", &ConingMotion::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"coning_motion", "", "5.4 degrees at 10 Hz"},
      Preset{"coning_motion_wide", "h=1/4,W=4,t_end=10", "56 degrees, slowly"}};

  std::array<double, size> scale() const { return {1, 1, 1, 1}; }
  double suggested_dt() const { return 0.125 / double(W); }

  template <class T>
  void initial(T* y) const {
    reference(T(0), y);
  }
  template <class T>
  void rhs(const T& t, const T* q, T* dqdt) const {
    using std::cos, std::sin;
    T c, s;  // of half the half-angle
    halves(c, s);
    const T across = 2 * T(W) * s * c, turn = T(W) * t;
    const T x = -across * sin(turn), y = across * cos(turn), z = -2 * T(W) * s * s;
    dqdt[0] = -(x * q[1] + y * q[2] + z * q[3]) / 2;
    dqdt[1] = (x * q[0] + z * q[2] - y * q[3]) / 2;
    dqdt[2] = (y * q[0] + x * q[3] - z * q[1]) / 2;
    dqdt[3] = (z * q[0] + y * q[1] - x * q[2]) / 2;
  }

  /// The exact flow: y0 is the attitude at t = 0, which the turn of the reference since then is appended to.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    T start[size], now[size];
    reference(T(0), start), reference(t, now);
    for (std::size_t i = 1; i < size; ++i) start[i] = -start[i];
    T left[size];
    product(y0, start, left);
    product(left, now, y);
  }
  template <class T>
  void invariants(const T* q, T* out) const {
    out[0] = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  }

 private:
  /// cos a/2 and sin a/2 of the half-angle a.
  template <class T>
  void halves(T& c, T& s) const {
    const T below = 1 + T(h) * T(h);
    c = (1 - T(h) * T(h)) / below, s = 2 * T(h) / below;
  }
  template <class T>
  void reference(const T& t, T* q) const {
    using std::cos, std::sin;
    T c, s;
    halves(c, s);
    q[0] = c, q[1] = s * cos(T(W) * t), q[2] = s * sin(T(W) * t), q[3] = T(0);
  }
  template <class T>
  static void product(const T* p, const T* q, T* out) {
    out[0] = p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3];
    out[1] = p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2];
    out[2] = p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3];
    out[3] = p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1];
  }
};

}  // namespace odemark
