// A system whose type is gone: a few function pointers on run-time-size states, as GSL and CVODE see it.
#pragma once

#include "integrators/system.hpp"
#include "integrators/tape.hpp"

namespace odemark {

/// Every method is compiled once per number type against this. It is a view: `self` must outlive it.
template <class T>
struct ErasedSystem {
  using State = std::vector<T>;

  const void* self = nullptr;
  std::size_t size = 0;
  unsigned abilities = 0;
  bool velocity_dependent = true;
  bool autonomous = false;  // f is known not to depend on t
  void (*rhs_call)(const void*, T t, const T* y, T* dydt) = nullptr;
  void (*acceleration_call)(const void*, T t, const T* y, T* a) = nullptr;
  void (*jacobian_call)(const void*, T t, const T* y, T* column_major) = nullptr;
  MatrixShape band{};  // of the Jacobian; size 0 where it is not banded
  void (*band_call)(const void*, T t, const T* y, T* band) = nullptr;  // J in the storage of that shape
  void (*time_derivative_call)(const void*, T t, const T* y, T* dfdt) = nullptr;
  void (*linear_part_call)(const void*, T* column_major) = nullptr;
  BodyPlace place{};  // of a rotating body
  void (*inertia_call)(const void*, T* principal_moments) = nullptr;
  void (*torque_call)(const void*, T t, const T* y, T* torque) = nullptr;
  Tape<T> (*record_call)(const void*) = nullptr;
  void (*on_series)(const void*) = nullptr;  // told of every Taylor expansion, where somebody counts

  void rhs(T t, const State& y, State& dydt) const { rhs_call(self, t, y.data(), dydt.data()); }
  void acceleration(T t, const State& y, T* a) const { acceleration_call(self, t, y.data(), a); }
  bool force_depends_on_velocity() const { return velocity_dependent; }
  MatrixShape jacobian_shape() const { return band.size > 0 ? band : MatrixShape::dense(size); }
  /// Entries that are always 0 are written where the matrix is whole and not banded.
  void jacobian(T t, const State& y, MatrixView<T> j) const {
    if (j.stride == size)
      jacobian_call(self, t, y.data(), j.data);
    else
      band_call(self, t, y.data(), j.data - band.upper);
  }
  void jacobian(T t, const State& y, InterleavedView<T> j) const {
    band_call(self, t, y.data(), j.data - band.upper);
  }
  void time_derivative(T t, const State& y, State& dfdt) const {
    time_derivative_call(self, t, y.data(), dfdt.data());
  }
  void linear_part(MatrixView<T> l) const { linear_part_call(self, l.data); }
  BodyPlace body_place() const { return place; }
  void inertia(T* principal_moments) const { inertia_call(self, principal_moments); }
  void torque(T t, const State& y, T* out) const { torque_call(self, t, y.data(), out); }
  Tape<T> tape() const { return record_call(self); }
  void count_series() const {
    if (on_series) on_series(self);
  }
};

/// Evaluations made by one run, counted on a run of its own so that counting never costs time. The torque on
/// a body is its acceleration.
struct WorkCounts {
  long rhs = 0, acceleration = 0, jacobian = 0, series = 0, lu = 0, newton = 0;
};

/// Forwards to another system and counts. Not copyable: its view points at it.
template <class T>
class CountingSystem {
 public:
  CountingSystem(const ErasedSystem<T>& inner, WorkCounts& counts) : inner_(inner), counts_(counts) {}
  CountingSystem(const CountingSystem&) = delete;
  CountingSystem& operator=(const CountingSystem&) = delete;

  ErasedSystem<T> view() const {
    ErasedSystem<T> out = inner_;
    out.self = this;
    out.rhs_call = [](const void* p, T t, const T* y, T* dydt) {
      const auto& me = of(p);
      ++me.counts_.rhs, me.inner_.rhs_call(me.inner_.self, t, y, dydt);
    };
    out.acceleration_call = [](const void* p, T t, const T* y, T* a) {
      const auto& me = of(p);
      ++me.counts_.acceleration, me.inner_.acceleration_call(me.inner_.self, t, y, a);
    };
    out.jacobian_call = [](const void* p, T t, const T* y, T* j) {
      const auto& me = of(p);
      ++me.counts_.jacobian, me.inner_.jacobian_call(me.inner_.self, t, y, j);
    };
    out.band_call = [](const void* p, T t, const T* y, T* band) {
      const auto& me = of(p);
      ++me.counts_.jacobian, me.inner_.band_call(me.inner_.self, t, y, band);
    };
    // f on dual numbers: one evaluation
    out.time_derivative_call = [](const void* p, T t, const T* y, T* dfdt) {
      const auto& me = of(p);
      ++me.counts_.rhs, me.inner_.time_derivative_call(me.inner_.self, t, y, dfdt);
    };
    out.linear_part_call = [](const void* p, T* l) { of(p).inner_.linear_part_call(of(p).inner_.self, l); };
    out.inertia_call = [](const void* p, T* m) { of(p).inner_.inertia_call(of(p).inner_.self, m); };
    out.torque_call = [](const void* p, T t, const T* y, T* torque) {
      const auto& me = of(p);
      ++me.counts_.acceleration, me.inner_.torque_call(me.inner_.self, t, y, torque);
    };
    out.record_call = [](const void* p) { return of(p).inner_.record_call(of(p).inner_.self); };
    out.on_series = [](const void* p) { ++of(p).counts_.series; };
    return out;
  }

 private:
  static const CountingSystem& of(const void* p) { return *static_cast<const CountingSystem*>(p); }
  const ErasedSystem<T> inner_;
  WorkCounts& counts_;
};

}  // namespace odemark
