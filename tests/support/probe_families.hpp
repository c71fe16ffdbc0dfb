// Small problems that only tests need: driven ones with a known solution, and ones that break on purpose.
#pragma once

#include "reference/make_family.hpp"

namespace odemark::probe {

/// What every probe shares: the end of the interval is its only parameter.
#define ODEMARK_PROBE(Name, name, text)                                                       \
  static constexpr std::string_view id = name, title = name, equations = text, source = "us"; \
  Real t_end = 2;                                                                             \
  static constexpr auto parameters() {                                                        \
    using P = Parameter<Name, Real>;                                                          \
    return std::array{P{"t_end", "s", "end of the interval", &Name::t_end, positive}};        \
  }                                                                                           \
  static constexpr std::array presets{Preset{name, "", text}};                                \
  double suggested_dt() const { return 0.0625; }

#define ODEMARK_SECOND_ORDER                                                           \
  static constexpr std::size_t size = 2;                                               \
  static constexpr std::array<Component, size> components{{{"x", "m"}, {"v", "m/s"}}}; \
  std::array<double, size> scale() const { return {1, 1}; }                            \
  template <class T>                                                                   \
  void rhs(const T& t, const T* y, T* dydt) const {                                    \
    dydt[0] = y[1];                                                                    \
    acceleration(t, y, &dydt[1]);                                                      \
  }                                                                                    \
  template <class T, class L>                                                          \
  void linear_part(L&& l) const {                                                      \
    /* half of it, so that the rest is never zero along the solution */                \
    l(0, 0) = T(0), l(0, 1) = T(1), l(1, 0) = T(-0.5), l(1, 1) = T(0);                 \
  }

/// Nonlinear and driven; the solution is x = sin t, whatever t_end.
template <class Real = double>
struct Driven {
  ODEMARK_PROBE(Driven, "driven", "x'' = -x - x^3 + sin(t)^3")
  ODEMARK_SECOND_ORDER
  static constexpr bool force_depends_on_velocity = false;

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(1);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* a) const {
    using std::sin;
    const T s = sin(t), x = y[0];
    a[0] = -x - x * x * x + s * s * s;
  }
};

/// The same with a force that depends on velocity; again x = sin t.
template <class Real = double>
struct DrivenDamped {
  ODEMARK_PROBE(DrivenDamped, "driven_damped", "x'' = -x - v^3 + cos(t)^3")
  ODEMARK_SECOND_ORDER
  static constexpr bool force_depends_on_velocity = true;

  template <class T>
  void initial(T* y) const {
    y[0] = T(0), y[1] = T(1);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* a) const {
    using std::cos;
    const T c = cos(t), v = y[1];
    a[0] = -y[0] - v * v * v + c * c * c;
  }
};

/// x = 1/(1 - t): the solution ends at t = 1, half way.
template <class Real = double>
struct Singularity {
  ODEMARK_PROBE(Singularity, "singularity", "x'' = 2 x^3")
  ODEMARK_SECOND_ORDER
  static constexpr bool force_depends_on_velocity = false;

  template <class T>
  void initial(T* y) const {
    y[0] = T(1), y[1] = T(1);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    a[0] = 2 * y[0] * y[0] * y[0];
  }
};

/// The same end in one equation.
template <class Real = double>
struct Blowup {
  ODEMARK_PROBE(Blowup, "blowup", "x' = x^2")
  static constexpr std::size_t size = 1;
  static constexpr std::array<Component, size> components{{{"x", ""}}};
  std::array<double, size> scale() const { return {1}; }

  template <class T>
  void initial(T* y) const {
    y[0] = T(1);
  }
  template <class T>
  void rhs(const T&, const T* y, T* dydt) const {
    dydt[0] = y[0] * y[0];
  }
};

/// Harmless until t = 33/32, not a number from there on.
template <class Real = double>
struct Undefined {
  ODEMARK_PROBE(Undefined, "undefined", "x'' = -x + 0 sqrt(33/32 - t)")
  ODEMARK_SECOND_ORDER
  static constexpr bool force_depends_on_velocity = false;

  template <class T>
  void initial(T* y) const {
    y[0] = T(1), y[1] = T(0);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* a) const {
    using std::sqrt;
    a[0] = -y[0] + T(0) * sqrt(T(33) / T(32) - t);
  }
};

/// Throws once t passes 1; a recording, which has no t to look at, throws at once.
template <class Real = double>
struct Thrower {
  ODEMARK_PROBE(Thrower, "thrower", "x'' = -x until t = 1")
  ODEMARK_SECOND_ORDER
  static constexpr bool force_depends_on_velocity = false;

  template <class T>
  void initial(T* y) const {
    y[0] = T(1), y[1] = T(0);
  }
  template <class T>
  void acceleration(const T& t, const T* y, T* a) const {
    if constexpr (requires { bool(t > T(1)); }) {
      if (t > T(1)) throw std::runtime_error("the table of forces ends at 1 s");
    } else {
      throw std::runtime_error("the table of forces cannot be recorded");
    }
    a[0] = -y[0];
  }
};

/// State (w, q) of a body with three moments; `torque` along its own axes.
#define ODEMARK_BODY                                                                                        \
  static constexpr std::size_t size = 7, rate_at = 0, attitude_at = 3;                                      \
  static constexpr std::array<Component, size> components{                                                  \
      {{"w1", "rad/s"}, {"w2", "rad/s"}, {"w3", "rad/s"}, {"q0", ""}, {"q1", ""}, {"q2", ""}, {"q3", ""}}}; \
  std::array<double, size> scale() const { return {1, 1, 1, 1, 1, 1, 1}; }                                  \
  template <class T>                                                                                        \
  void initial(T* y) const {                                                                                \
    y[0] = T(1), y[1] = T(0.5), y[2] = T(-0.75);                                                            \
    y[3] = T(1), y[4] = y[5] = y[6] = T(0);                                                                 \
  }                                                                                                         \
  template <class T>                                                                                        \
  void inertia(T* out) const {                                                                              \
    out[0] = T(2), out[1] = T(1.5), out[2] = T(1);                                                          \
  }                                                                                                         \
  template <class T>                                                                                        \
  void rhs(const T& t, const T* y, T* dydt) const {                                                         \
    T push[3];                                                                                              \
    torque(t, y, push);                                                                                     \
    dydt[0] = (push[0] + T(0.5) * y[1] * y[2]) / T(2);                                                      \
    dydt[1] = (push[1] - T(1) * y[2] * y[0]) / T(1.5);                                                      \
    dydt[2] = push[2] + T(0.5) * y[0] * y[1];                                                               \
    dydt[3] = -(y[0] * y[4] + y[1] * y[5] + y[2] * y[6]) / T(2);                                            \
    dydt[4] = (y[0] * y[3] + y[2] * y[5] - y[1] * y[6]) / T(2);                                             \
    dydt[5] = (y[1] * y[3] + y[0] * y[6] - y[2] * y[4]) / T(2);                                             \
    dydt[6] = (y[2] * y[3] + y[1] * y[4] - y[0] * y[5]) / T(2);                                             \
  }

/// A top under gravity that is also driven: the torque depends on attitude and time.
template <class Real = double>
struct DrivenTop {
  ODEMARK_PROBE(DrivenTop, "driven_top", "I w' + w x I w = (vertical in the body) x e3 + (sin t, 0, 0)")
  ODEMARK_BODY

  template <class T>
  void torque(const T& t, const T* y, T* out) const {
    using std::sin;
    const T up1 = T(2) * (y[4] * y[6] - y[3] * y[5]), up2 = T(2) * (y[5] * y[6] + y[3] * y[4]);
    out[0] = up2 + sin(t), out[1] = -up1, out[2] = T(0);
  }
};

/// A top that a viscous torque slows while a motor drives it: the torque depends on the rate.
template <class Real = double>
struct DampedTop {
  ODEMARK_PROBE(DampedTop, "damped_top", "I w' + w x I w = -w/2 + (0, 0, cos t)")
  ODEMARK_BODY

  template <class T>
  void torque(const T& t, const T* y, T* out) const {
    using std::cos;
    out[0] = -y[0] / T(2), out[1] = -y[1] / T(2), out[2] = -y[2] / T(2) + cos(t);
  }
};

#undef ODEMARK_PROBE
#undef ODEMARK_SECOND_ORDER
#undef ODEMARK_BODY

template <template <class> class Family>
AnyProblem problem(std::string_view settings = "") {
  return find_problem({make_family<Family>()}, Family<double>::id, settings);
}

}  // namespace odemark::probe
