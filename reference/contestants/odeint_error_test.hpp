// The suite's error test in the place of odeint's, so that a tolerance means the same for both.
#pragma once

#include <cmath>

#include "integrators/step_control.hpp"

namespace odemark::contestant {

class OdeintErrorTest {
 public:
  explicit OdeintErrorTest(const ErrorControl& control) : control_(&control) {}

  template <class Algebra, class State>
  double error(Algebra&, const State& y, const State&, const State& error, double) const {
    double sum = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double ratio = error[i] / error_weight(*control_, i, std::abs(y[i]));
      sum += ratio * ratio;
    }
    const double norm = std::sqrt(sum / double(y.size()));
    return norm < 1e300 ? norm : 1e300;  // odeint accepts NaN
  }

 private:
  const ErrorControl* control_;
};

}  // namespace odemark::contestant
