// How fast one compiled step, applied for ever, makes a linear problem grow.
#pragma once

#include "integrators/any_method.hpp"

namespace odemark {

/// lim ln ||M^N|| / N: no threshold, no overflow, and a Jordan block counts for nothing. -infinity for a
/// nilpotent matrix, NaN where an entry is not finite. Column-major. In closed form for two by two, else by
/// squaring.
long double matrix_growth(std::size_t size, const std::vector<long double>& matrix);

/// The same by repeated squaring, scaled at every squaring, to N = 2^80.
long double growth_by_squaring(std::size_t size, std::vector<long double> matrix);

/// The same where it is near 0; where it is plainly not, in double, which tells that in a fifth of the time
/// but is the root of its rounding off where eigenvalues meet.
long double plain_growth(std::size_t size, const std::vector<long double>& matrix);

struct StepGrowth {
  bool solved = true;      // false: an implicit stage could not be solved
  long double growth = 0;  // per step; NaN where an entry of the matrix is not finite
};

/// One step of a method on a linear homogeneous system, in double or float. The system must outlive it.
class StepProbe {
 public:
  StepProbe(const AnyMethod& method, const ErasedSystem<double>& system);
  StepProbe(const AnyMethod& method, const ErasedSystem<float>& system);

  double unit_roundoff() const { return unit_; }
  /// Growth per step up to which a step counts as stable, at z = dt * fastest rate. Rounding z alone moves
  /// the growth by z roundings.
  double tolerance(double z) const;
  /// Growth per step below which rounding and instability cannot be told apart.
  double floor() const { return 8 * unit_; }

  StepGrowth operator()(double dt) const;
  /// As good for telling stable from unstable: by plain_growth.
  StepGrowth judge(double dt) const;
  /// How far rounding of the step's entries may move its growth.
  long double noise(double dt) const;

 private:
  struct Step {
    bool solved;
    std::size_t size;
    std::vector<long double> matrix;
  };
  template <class T>
  void prepare(const AnyMethod& method, const ErasedSystem<T>& system);
  long double noise_of(const Step& step, double dt) const;

  std::function<Step(double dt)> step_;
  std::vector<long double> jacobian_;
  std::size_t size_ = 0;
  int terms_ = 2;
  double unit_ = 0;
};

}  // namespace odemark
