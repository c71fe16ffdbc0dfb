// What a careful programmer writes for one method on one scene: the yardstick of the engine's own tax.
#pragma once

#include <array>

namespace odemark::hand {

/// The scenes, with parameters known only at run time, and their slopes written out.
struct Drag {
  static constexpr std::size_t size = 2;
  double thrust, drag, m;
  void slope(const double* y, double* d) const {
    d[0] = y[1];
    d[1] = thrust / m - drag / m * y[1];
  }
};
struct Spring {
  static constexpr std::size_t size = 2;
  double k, m;
  void slope(const double* y, double* d) const {
    d[0] = y[1];
    d[1] = -(k / m) * y[0];
  }
};
struct Lorenz {
  static constexpr std::size_t size = 3;
  double sigma, rho, beta;
  void slope(const double* y, double* d) const {
    d[0] = sigma * (y[1] - y[0]);
    d[1] = y[0] * (rho - y[2]) - y[1];
    d[2] = y[0] * y[1] - beta * y[2];
  }
};

template <class Scene>
using State = std::array<double, Scene::size>;

/// Written out for two or three components: no arrays between the stages but plain locals.
template <class Scene>
void euler(const Scene scene, State<Scene>& state, double h, long count) {
  State<Scene> y = state;
  for (long n = 0; n < count; ++n) {
    double k[Scene::size];
    scene.slope(y.data(), k);
    y[0] += h * k[0];
    y[1] += h * k[1];
    if constexpr (Scene::size == 3) y[2] += h * k[2];
  }
  state = y;
}

template <class Scene>
void heun(const Scene scene, State<Scene>& state, double h, long count) {
  State<Scene> y = state;
  const double half = h / 2;
  for (long n = 0; n < count; ++n) {
    double k1[Scene::size], k2[Scene::size], u[Scene::size];
    scene.slope(y.data(), k1);
    u[0] = y[0] + h * k1[0];
    u[1] = y[1] + h * k1[1];
    if constexpr (Scene::size == 3) u[2] = y[2] + h * k1[2];
    scene.slope(u, k2);
    y[0] = y[0] + half * k1[0] + half * k2[0];
    y[1] = y[1] + half * k1[1] + half * k2[1];
    if constexpr (Scene::size == 3) y[2] = y[2] + half * k1[2] + half * k2[2];
  }
  state = y;
}

template <class Scene>
void rk4(const Scene scene, State<Scene>& state, double h, long count) {
  State<Scene> y = state;
  const double half = h / 2, third = h / 3, sixth = h / 6;
  for (long n = 0; n < count; ++n) {
    double k1[Scene::size], k2[Scene::size], k3[Scene::size], k4[Scene::size];
    double u[Scene::size], v[Scene::size], w[Scene::size];
    scene.slope(y.data(), k1);
    u[0] = y[0] + half * k1[0];
    u[1] = y[1] + half * k1[1];
    if constexpr (Scene::size == 3) u[2] = y[2] + half * k1[2];
    scene.slope(u, k2);
    v[0] = y[0] + half * k2[0];
    v[1] = y[1] + half * k2[1];
    if constexpr (Scene::size == 3) v[2] = y[2] + half * k2[2];
    scene.slope(v, k3);
    w[0] = y[0] + h * k3[0];
    w[1] = y[1] + h * k3[1];
    if constexpr (Scene::size == 3) w[2] = y[2] + h * k3[2];
    scene.slope(w, k4);
    y[0] = y[0] + sixth * k1[0] + third * k2[0] + third * k3[0] + sixth * k4[0];
    y[1] = y[1] + sixth * k1[1] + third * k2[1] + third * k3[1] + sixth * k4[1];
    if constexpr (Scene::size == 3)
      y[2] = y[2] + sixth * k1[2] + third * k2[2] + third * k3[2] + sixth * k4[2];
  }
  state = y;
}

/// Fixed steps of the fifth-order member: first-same-as-last is used, the error estimate is not formed.
template <class Scene>
void dormand_prince5(const Scene scene, State<Scene>& state, double h, long count) {
  State<Scene> y = state;
  const double a21 = h / 5, a31 = h * (3.0 / 40), a32 = h * (9.0 / 40), a41 = h * (44.0 / 45),
               a42 = h * (-56.0 / 15), a43 = h * (32.0 / 9), a51 = h * (19372.0 / 6561),
               a52 = h * (-25360.0 / 2187), a53 = h * (64448.0 / 6561), a54 = h * (-212.0 / 729),
               a61 = h * (9017.0 / 3168), a62 = h * (-355.0 / 33), a63 = h * (46732.0 / 5247),
               a64 = h * (49.0 / 176), a65 = h * (-5103.0 / 18656), b1 = h * (35.0 / 384),
               b3 = h * (500.0 / 1113), b4 = h * (125.0 / 192), b5 = h * (-2187.0 / 6784),
               b6 = h * (11.0 / 84);
  double k1[Scene::size];
  scene.slope(y.data(), k1);
  const auto each = [](auto f) {
    f(0), f(1);
    if constexpr (Scene::size == 3) f(2);
  };
  for (long n = 0; n < count; ++n) {
    double k2[Scene::size], k3[Scene::size], k4[Scene::size], k5[Scene::size], k6[Scene::size];
    double u2[Scene::size], u3[Scene::size], u4[Scene::size], u5[Scene::size], u6[Scene::size];
    each([&](int i) { u2[i] = y[std::size_t(i)] + a21 * k1[i]; });
    scene.slope(u2, k2);
    each([&](int i) { u3[i] = y[std::size_t(i)] + a31 * k1[i] + a32 * k2[i]; });
    scene.slope(u3, k3);
    each([&](int i) { u4[i] = y[std::size_t(i)] + a41 * k1[i] + a42 * k2[i] + a43 * k3[i]; });
    scene.slope(u4, k4);
    each([&](int i) { u5[i] = y[std::size_t(i)] + a51 * k1[i] + a52 * k2[i] + a53 * k3[i] + a54 * k4[i]; });
    scene.slope(u5, k5);
    each([&](int i) {
      u6[i] = y[std::size_t(i)] + a61 * k1[i] + a62 * k2[i] + a63 * k3[i] + a64 * k4[i] + a65 * k5[i];
    });
    scene.slope(u6, k6);
    each([&](int i) {
      y[std::size_t(i)] = y[std::size_t(i)] + b1 * k1[i] + b3 * k3[i] + b4 * k4[i] + b5 * k5[i] + b6 * k6[i];
    });
    scene.slope(y.data(), k1);
  }
  state = y;
}

}  // namespace odemark::hand
