// y' = lambda y for a complex lambda, as two real equations; and quadrature, as an equation of second order.
#pragma once

#include <complex>

#include "integrators/erased_system.hpp"

namespace odemark {

/// Must outlive its view.
template <class T>
struct LinearBlock {
  T re, im;

  template <class N>
  void rhs(const N&, const N* y, N* dydt) const {
    dydt[0] = y[0] * N(re) - y[1] * N(im);
    dydt[1] = y[0] * N(im) + y[1] * N(re);
  }
  void matrix(T* m) const { m[0] = re, m[1] = im, m[2] = -im, m[3] = re; }

  ErasedSystem<T> view() const {
    ErasedSystem<T> s;
    s.self = this, s.size = 2;
    s.abilities = Ability::jacobian | Ability::linear_part | Ability::recordable | Ability::double_precision |
                  Ability::moderate_size;
    s.rhs_call = [](const void* p, T t, const T* y, T* dydt) { of(p).rhs(t, y, dydt); };
    s.jacobian_call = [](const void* p, T, const T*, T* m) { of(p).matrix(m); };
    s.linear_part_call = [](const void* p, T* m) { of(p).matrix(m); };
    s.record_call = [](const void* p) { return record<T>(of(p), 2); };
    s.autonomous = true;
    s.time_derivative_call = [](const void*, T, const T*, T* dfdt) { dfdt[0] = dfdt[1] = 0; };
    return s;
  }

 private:
  static const LinearBlock& of(const void* p) { return *static_cast<const LinearBlock*>(p); }
};

/// x' = v, v' = (power + 1) t^power: v(1) = 1 from v(0) = 0. Only nodes decide how a step sees it.
template <class T>
struct Quadrature {
  int power;

  template <class N>
  void acceleration(const N& t, const N*, N* a) const {
    a[0] = N(T(power + 1));
    for (int k = 0; k < power; ++k) a[0] = a[0] * t;
  }
  template <class N>
  void rhs(const N& t, const N* y, N* dydt) const {
    dydt[0] = y[1];
    acceleration(t, y, dydt + 1);
  }

  ErasedSystem<T> view() const {
    ErasedSystem<T> s;
    s.self = this, s.size = 2, s.velocity_dependent = false;
    s.abilities = Ability::jacobian | Ability::second_order | Ability::separable | Ability::double_precision |
                  Ability::moderate_size;
    s.rhs_call = [](const void* p, T t, const T* y, T* dydt) { of(p).rhs(t, y, dydt); };
    s.acceleration_call = [](const void* p, T t, const T* y, T* a) { of(p).acceleration(t, y, a); };
    s.jacobian_call = [](const void*, T, const T*, T* m) { m[0] = m[1] = m[3] = 0, m[2] = 1; };
    s.time_derivative_call = [](const void* p, T t, const T*, T* dfdt) {
      const int n = of(p).power;
      dfdt[0] = 0, dfdt[1] = T((n + 1) * n);
      for (int k = 1; k < n; ++k) dfdt[1] *= t;
    };
    return s;
  }

 private:
  static const Quadrature& of(const void* p) { return *static_cast<const Quadrature*>(p); }
};

}  // namespace odemark
