// The torque-free rigid body (Euler's top), with its attitude: the tennis racket that flips.
#pragma once
#include <algorithm>
#include <string>

#include "problems/elliptic.hpp"
#include "problems/family.hpp"

namespace odemark {

/// State (w1, w2, w3, q0, q1, q2, q3): angular velocity along the principal axes of the body, and the
/// quaternion (scalar first) which turns body vectors into space. It starts as 1 and is nowhere normalised.
template <class Real = double>
struct FreeRigidBody {
  static constexpr std::string_view id = "free_rigid_body";
  static constexpr std::string_view title = "Free rigid body";
  static constexpr std::string_view equations =
      "w1' = (I2 - I3)/I1 w2 w3;  w2' = (I3 - I1)/I2 w3 w1;  w3' = (I1 - I2)/I3 w1 w2;  q' = q (0, w)/2";
  static constexpr std::string_view source =
      "L. D. Landau, E. M. Lifshitz, Mechanics, 3rd ed. (Pergamon, 1976), 36-37; "
      "R. van Zon, J. Schofield, J. Comput. Phys. 225 (2007) 145-164, doi:10.1016/j.jcp.2006.11.019; D. G. "
      "Murri, E. B. Jackson, R. O. Shelton, NASA/TM-2015-218675 (2015), case 2";
  static constexpr std::size_t size = 7;
  static constexpr std::array<Component, size> components{
      {{"w1", "rad/s"}, {"w2", "rad/s"}, {"w3", "rad/s"}, {"q0", ""}, {"q1", ""}, {"q2", ""}, {"q3", ""}}};
  static constexpr std::array<std::string_view, 6> invariant_names{
      "energy",           "angular_momentum_squared", "quaternion_squared",
      "space_momentum_x", "space_momentum_y",         "space_momentum_z"};

  Real I1 = 13, I2 = 10, I3 = 5, w1 = Real(1) / 64, w2 = 2, w3 = Real(1) / 64, t_end = 20;

  static constexpr auto parameters() {
    using P = Parameter<FreeRigidBody, Real>;
    return std::array{P{"I1", "kg m^2", "first principal moment of inertia", &FreeRigidBody::I1, positive},
                      P{"I2", "kg m^2", "second principal moment of inertia", &FreeRigidBody::I2, positive},
                      P{"I3", "kg m^2", "third principal moment of inertia", &FreeRigidBody::I3, positive},
                      P{"w1", "rad/s", "initial angular velocity about axis 1", &FreeRigidBody::w1},
                      P{"w2", "rad/s", "initial angular velocity about axis 2", &FreeRigidBody::w2},
                      P{"w3", "rad/s", "initial angular velocity about axis 3", &FreeRigidBody::w3},
                      P{"t_end", "s", "end of the interval", &FreeRigidBody::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"free_rigid_body", "",
             "a box of 12 kg, 1 x 2 x 3 m, spun about its intermediate axis: it flips"},
      Preset{"free_rigid_body_tumbling", "w1=1,w2=1,w3=1", "no axis preferred"},
      Preset{"free_rigid_body_long_axis", "w1=0.125,w2=0.125,w3=4", "a fast stable spin that wobbles"},
      Preset{"free_rigid_body_symmetric", "I1=10,w1=0.5,w2=0,w3=4", "a symmetric top: regular precession"},
      Preset{"free_rigid_body_dzhanibekov", "I1=1,I2=2,I3=3,w1=1/1024,w2=1,w3=1/1024,t_end=100",
             "left to itself about the intermediate axis: it flips every 28 s, for ever"},
      Preset{"free_rigid_body_nesc_brick",
             "I1=0.00189422,I2=0.006211019,I3=0.007194665,w1=0.17453292519943295,w2=0.3490658503988659,"
             "w3=0.5235987755982988,t_end=30",
             "moments in the ratio of NASA's tumbling brick, at 10, 20 and 30 degrees per second"}};

  std::string validate() const {
    return I1 > I2 + I3 || I2 > I3 + I1 || I3 > I1 + I2
               ? "no body has a principal moment of inertia greater than the sum of the other two"
               : "";
  }
  std::array<double, size> scale() const {
    const double w = std::hypot(double(w1), double(w2), double(w3)), rate = w > 0 ? w : 1;
    return {rate, rate, rate, 1, 1, 1, 1};
  }
  double suggested_dt() const { return 0.05 / scale()[0]; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(w1), y[1] = T(w2), y[2] = T(w3);
    y[3] = T(1), y[4] = T(0), y[5] = T(0), y[6] = T(0);
  }
  static constexpr std::size_t rate_at = 0, attitude_at = 3;  // of w and q in the state
  template <class T>
  void inertia(T* out) const {
    out[0] = T(I1), out[1] = T(I2), out[2] = T(I3);
  }
  template <class T>
  void torque(const T&, const T*, T* out) const {
    out[0] = out[1] = out[2] = T(0);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    const T &a = y[0], &b = y[1], &c = y[2];
    dydt[0] = ((T(I2) - T(I3)) / T(I1)) * b * c;
    dydt[1] = ((T(I3) - T(I1)) / T(I2)) * c * a;
    dydt[2] = ((T(I1) - T(I2)) / T(I3)) * a * b;
    dydt[3] = -(a * y[4] + b * y[5] + c * y[6]) / 2;
    dydt[4] = (a * y[3] + c * y[5] - b * y[6]) / 2;
    dydt[5] = (b * y[3] + a * y[6] - c * y[4]) / 2;
    dydt[6] = (c * y[3] + b * y[4] - a * y[5]) / 2;
  }
  template <class T, class J>
  void jacobian(const T&, const T* y, J&& j) const {
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column) j(row, column) = T(0);
    const T alpha[3] = {(T(I2) - T(I3)) / T(I1), (T(I3) - T(I1)) / T(I2), (T(I1) - T(I2)) / T(I3)};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
      j(i, next) = alpha[i] * y[last], j(i, last) = alpha[i] * y[next];
      j(3, i) = -y[4 + i] / 2, j(3, 4 + i) = -y[i] / 2;
      j(4 + i, i) = y[3] / 2, j(4 + i, 3) = y[i] / 2;
      j(4 + i, next) = -y[4 + last] / 2, j(4 + i, last) = y[4 + next] / 2;
      j(4 + i, 4 + next) = y[last] / 2, j(4 + i, 4 + last) = -y[next] / 2;
    }
  }

  /// The rates of the exact flow alone: w is the angular velocity at t = 0.
  template <class T>
  void exact_rates(const T& t, const T* w, T* out) const {
    const Axes<T> axes(*this, w);
    axes.rates(t, w, out);
  }

  /// The exact flow: y0 is the state at t = 0. The angular momentum L rests in space, so the attitude is
  /// known but for the angle psi by which axis c has gone round L: an elliptic integral of the third kind.
  template <class T>
  void exact(const T& t, const T* y0, T* y) const {
    using std::atan2, std::cos, std::sin, std::sqrt;
    const T w[3] = {y0[0], y0[1], y0[2]};
    const Quaternion<T> q{y0[3], y0[4], y0[5], y0[6]};
    const Axes<T> axes(*this, w);
    axes.rates(t, w, y);
    const Quaternion<T> turned =
        axes.steady ? spin(T(t * sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2])), w)
                    : axes.frame(w) * axes.about_c(axes.precession(t, w, y)) * conjugate(axes.frame(y));
    const Quaternion<T> out = q * turned;
    std::copy(out.begin(), out.end(), y + 3);
  }
  /// The momentum in space is turned by q as it is: a quaternion that has grown makes it grow.
  template <class T>
  void invariants(const T* y, T* out) const {
    const T l[3] = {T(I1) * y[0], T(I2) * y[1], T(I3) * y[2]};
    out[0] = (l[0] * y[0] + l[1] * y[1] + l[2] * y[2]) / 2;
    out[1] = l[0] * l[0] + l[1] * l[1] + l[2] * l[2];
    const Quaternion<T> q{y[3], y[4], y[5], y[6]};
    const Quaternion<T> space = q * Quaternion<T>{T(0), l[0], l[1], l[2]} * conjugate(q);
    out[2] = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    out[3] = space[1], out[4] = space[2], out[5] = space[3];
  }

 private:
  template <class T>
  struct Quaternion : std::array<T, 4> {
    friend Quaternion operator*(const Quaternion& p, const Quaternion& q) {
      return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
              p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
              p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3],
              p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1]};
    }
    friend Quaternion conjugate(const Quaternion& q) { return {q[0], -q[1], -q[2], -q[3]}; }
  };
  /// The rotation by an angle about a direction of any length.
  template <class T>
  static Quaternion<T> spin(const T& angle, const T* axis) {
    using std::cos, std::sin, std::sqrt;
    const T norm = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    const T s = norm == 0 ? norm : T(sin(angle / 2) / norm);
    return {cos(angle / 2), s * axis[0], s * axis[1], s * axis[2]};
  }

  /// The axes by their roles: about d (of the greatest or the least moment, by the side of the separatrix the
  /// motion is on) the rate never changes its sign, s has the intermediate moment, c is the third. Then the
  /// rates are wc cn u, ws sn u and wd dn u with u = rate t + phase.
  template <class T>
  struct Axes {
    std::size_t c, s, d;
    T I[3], alpha[3];  // w_i' = alpha_i w_j w_k
    bool steady;       // no rate changes at all
    T rate, kc;        // of the elliptic functions
    T wc, ws, wd;      // amplitudes, signed as cn >= 0 and dn > 0 at the start demand

    Axes(const FreeRigidBody& body, const T* w) : I{T(body.I1), T(body.I2), T(body.I3)} {
      using std::abs, std::sqrt;
      for (std::size_t i = 0; i < 3; ++i) alpha[i] = (I[(i + 1) % 3] - I[(i + 2) % 3]) / I[i];
      std::size_t order[3] = {0, 1, 2};
      std::sort(order, order + 3, [this](std::size_t i, std::size_t j) { return I[i] < I[j]; });
      c = order[0], s = order[1], d = order[2];
      if (!(I[d] * (I[d] - I[s]) * w[d] * w[d] > I[c] * (I[s] - I[c]) * w[c] * w[c])) std::swap(c, d);
      steady = alpha[0] * w[1] * w[2] == 0 && alpha[1] * w[2] * w[0] == 0 && alpha[2] * w[0] * w[1] == 0;
      if (steady) return;
      const T ratio = sqrt(alpha[d] / alpha[c]);
      wd = (w[d] < 0 ? -1 : 1) * sqrt(w[d] * w[d] - alpha[d] / alpha[s] * w[s] * w[s]);
      wc = (w[c] < 0 ? -1 : 1) * sqrt(w[c] * w[c] - alpha[c] / alpha[s] * w[s] * w[s]);
      rate = sqrt(-alpha[c] * alpha[s]) * abs(wd);
      ws = alpha[s] * wc * wd / rate;
      kc = sqrt(std::max(T(0), T(abs(w[d]) - ratio * abs(w[c]))) * (abs(w[d]) + ratio * abs(w[c]))) / abs(wd);
    }

    /// By the addition theorems, so that the phase at the start need not be known.
    void rates(const T& t, const T* w, T* out) const {
      if (steady) {
        std::copy(w, w + 3, out);
        return;
      }
      const auto [sn, cn, dn] = elliptic::jacobi(T(rate * t), kc);
      const T tilt = w[d] / wd, below = cn * cn + sn * sn * tilt * tilt;
      const T fc = alpha[c] * w[s] * w[d], fs = alpha[s] * w[d] * w[c], fd = alpha[d] * w[c] * w[s];
      out[c] = (w[c] * cn + fc / rate * sn * dn) / below;
      out[s] = (w[s] * cn * dn + fs / rate * sn) / below;
      out[d] = (w[d] * dn + fd / rate * sn * cn) / below;
    }

    /// sn, cn and dn of the rates w.
    elliptic::Jacobi<T> phase(const T* w) const { return {w[s] / ws, w[c] / wc, w[d] / wd}; }

    /// psi' = L/Ic (1 - (L^2 - 2 T Ic)/(L^2 - Ic^2 w_c^2)), integrated from the rates w to the rates `now`.
    /// Axis c stays away from L, and so in doubles the attitude has 13 digits; only a nearly symmetric body
    /// that turns across its axis of symmetry costs the digits by which w_d is smaller than w_c.
    T precession(const T& t, const T* w, const T* now) const {
      using std::abs, std::sqrt;
      T momentum2 = 0, twice_energy_lack = 0;  // L^2 and L^2 - 2 T Ic
      for (std::size_t i = 0; i < 3; ++i) {
        momentum2 += I[i] * I[i] * w[i] * w[i];
        twice_energy_lack += I[i] * (I[i] - I[c]) * w[i] * w[i];
      }
      const T momentum_d = I[d] * wd, share = I[c] * wc / momentum_d, n = share * share;
      const elliptic::Jacobi<T> start = phase(w);
      elliptic::Jacobi<T> end = phase(now);
      T third = 0;
      if (kc > 0) {
        const T half = 2 * elliptic::quarter_period(kc);
        const T halves = elliptic::nearest(T((elliptic::first_kind(start) + rate * t) / half));
        const T pairs = 2 * elliptic::nearest(T(halves / 2));
        if (halves != pairs) end.sn = -end.sn;
        third = 2 * halves * elliptic::third_kind(n, elliptic::Jacobi<T>{T(1), T(0), kc});
      }
      third += elliptic::third_kind(n, end) - elliptic::third_kind(n, start);
      return sqrt(momentum2) / I[c] * (t - twice_energy_lack / (momentum_d * momentum_d) * third / rate);
    }

    /// The rotation of the body which takes axis c to the angular momentum, continuous while w_d keeps its
    /// sign.
    Quaternion<T> frame(const T* w) const {
      using std::atan2, std::sqrt;
      const T side = w[d] < 0 ? -1 : 1,
              hand = s == (d + 1) % 3 ? side : T(-side);  // (c, side d, hand s) right-handed
      const T along = I[c] * w[c], up = side * I[d] * w[d], out = hand * I[s] * w[s];
      T third[3] = {T(0), T(0), T(0)};
      third[s] = hand;
      return about_c(atan2(out, up)) * spin(T(atan2(T(sqrt(up * up + out * out)), along)), third);
    }
    Quaternion<T> about_c(const T& angle) const {
      T axis[3] = {T(0), T(0), T(0)};
      axis[c] = 1;
      return spin(angle, axis);
    }
  };
};

}  // namespace odemark
