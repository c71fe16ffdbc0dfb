// Second-order steps on x'' = -stiffness x - damping v: a 2x2 matrix whose entries are polynomials in dt.
#include <algorithm>
#include <cmath>

#include "integrators/linear_stability_parts.hpp"

namespace odemark::detail {

namespace {

/// A linear form in (x_n, v_n), over a common denominator.
struct Form {
  RealPolynomial of_x, of_v;
};
Form operator+(const Form& a, const Form& b) { return {a.of_x + b.of_x, a.of_v + b.of_v}; }
Form operator*(const RealPolynomial& p, const Form& a) { return {p * a.of_x, p * a.of_v}; }

}  // namespace

StepMatrix step_matrix(const std::vector<SecondOrderMove>& moves, Coefficient stiffness,
                       Coefficient damping) {
  using What = SecondOrderMove::What;
  const RealPolynomial one({1}), none({0});
  RealPolynomial denominator = one;
  const Form start_x{one, none}, start_v{none, one};
  Form x = start_x, v = start_v;
  const auto acceleration = [&](const Form& at, const Form& velocity) {
    return RealPolynomial({-stiffness}) * at + RealPolynomial({-damping}) * velocity;
  };
  const Form start_a = acceleration(start_x, start_v);
  for (const auto& move : moves) {
    const RealPolynomial step({0, move.weight});
    // what was known at the start has to be brought over the denominator of now
    const Form old_v = denominator * start_v, old_a = denominator * start_a;
    switch (move.what) {
      case What::drift: x = x + step * v; break;
      case What::kick: v = v + step * acceleration(x, v); break;
      case What::kick_start: v = v + step * old_a; break;
      case What::kick_old: v = v + step * acceleration(x, old_v); break;
      case What::kick_predicted:
        v = v + step * acceleration(x, old_v + RealPolynomial({0, 1}) * old_a);
        break;
      case What::kick_implicit: {
        const RealPolynomial divisor({1, move.weight * damping});
        v = v + step * (RealPolynomial({-stiffness}) * x);
        x = divisor * x;
        denominator = divisor * denominator;
        break;
      }
    }
  }
  return {x.of_x + v.of_v, x.of_x * v.of_v - x.of_v * v.of_x, denominator};
}

NonNegative moves_stable(const std::vector<SecondOrderMove>& moves, Coefficient stiffness,
                         Coefficient damping) {
  const auto [trace, determinant, q] = step_matrix(moves, stiffness, damping);
  // Jury: |det| <= 1 and |trace| <= 1 + det. Where det is 1 by construction the first vanishes identically,
  // and what is left is |trace| <= 2.
  NonNegative out{{{0, std::numeric_limits<Coefficient>::infinity()}}, {}};
  for (RealPolynomial condition :
       {q * q - determinant, q * q + q * trace + determinant, q * q - q * trace + determinant}) {
    condition.clean();
    const auto [where, touches] = where_not_negative(condition);
    out.where = intersection(out.where, where);
    out.touches.insert(out.touches.end(), touches.begin(), touches.end());
  }
  return out;
}

Coefficient moves_log_radius(const std::vector<SecondOrderMove>& moves, Coefficient stiffness,
                             Coefficient damping, Coefficient dt) {
  const Coefficient rate = std::max(std::sqrt(std::abs(stiffness)), std::abs(damping)), h = dt * rate;
  const auto matrix =
      step_matrix(moves, rate == 0 ? 0 : stiffness / rate / rate, rate == 0 ? 0 : damping / rate);
  const Coefficient q = matrix.denominator(h);
  RealPolynomial deficit = matrix.denominator * matrix.denominator - matrix.determinant;
  deficit.clean();
  const Coefficient lost = deficit(h) / q / q;  // 1 - det, without the cancellation
  const Coefficient half = matrix.trace(h) / q / 2, determinant = 1 - lost;
  const Coefficient square = half * half - determinant;
  if (square <= 0) return std::log1p(-lost) / 2;
  return std::log(std::abs(half) + std::sqrt(square));
}

}  // namespace odemark::detail
