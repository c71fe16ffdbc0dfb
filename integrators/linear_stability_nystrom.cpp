// Nystrom steps on x'' = -stiffness x: a 2x2 matrix whose entries are polynomials in dt^2 stiffness.
#include <cmath>

#include "integrators/linear_stability_parts.hpp"

namespace odemark::detail {

namespace {

/// Of the matrix on (x, dt v), which is similar to that on (x, v).
struct Traced {
  RealPolynomial trace, determinant;
};

Traced traced(const OscillatorMatrix& m, Coefficient stiffness) {
  const auto in_dt = [&](const std::vector<Coefficient>& entry) {
    RealPolynomial out;
    Coefficient power = 1;
    for (std::size_t k = 0; k < entry.size(); ++k, power *= stiffness) out.add_term(2 * k, entry[k] * power);
    return out;
  };
  const auto xx = in_dt(m.xx), xv = in_dt(m.xv), vx = in_dt(m.vx), vv = in_dt(m.vv);
  return {xx + vv, xx * vv - xv * vx};
}

}  // namespace

NonNegative oscillator_stable(const OscillatorMatrix& step, Coefficient stiffness) {
  const auto [trace, determinant] = traced(step, stiffness);
  const RealPolynomial one({1});
  NonNegative out{{{0, std::numeric_limits<Coefficient>::infinity()}}, {}};
  // Jury, as for moves
  for (RealPolynomial condition : {one - determinant, one + trace + determinant, one - trace + determinant}) {
    condition.clean();
    const auto [where, touches] = where_not_negative(condition);
    out.where = intersection(out.where, where);
    out.touches.insert(out.touches.end(), touches.begin(), touches.end());
  }
  return out;
}

Coefficient oscillator_log_radius(const OscillatorMatrix& step, Coefficient stiffness, Coefficient dt) {
  const auto [trace, determinant] = traced(step, stiffness);
  RealPolynomial deficit = RealPolynomial({1}) - determinant;
  deficit.clean();
  const Coefficient lost = deficit(dt);  // 1 - det, without the cancellation
  const Coefficient half = trace(dt) / 2, square = half * half - (1 - lost);
  if (square <= 0) return std::log1p(-lost) / 2;
  return std::log(std::abs(half) + std::sqrt(square));
}

}  // namespace odemark::detail
