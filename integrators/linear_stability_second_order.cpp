// Second-order steps on x'' = -stiffness x - damping v: a 2x2 matrix whose entries are polynomials in dt.
#include <algorithm>
#include <cmath>

#include "integrators/linear_stability_parts.hpp"

namespace odemark::detail {

namespace {

Form operator+(const Form& a, const Form& b) { return {a.of_x + b.of_x, a.of_v + b.of_v}; }
Form operator*(const RealPolynomial& p, const Form& a) { return {p * a.of_x, p * a.of_v}; }

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
  return {x, v, denominator};
}

/// The entries on (x, dt v) are polynomials in dt^2 stiffness; back to (x, v) one dt moves.
StepMatrix step_matrix(const OscillatorMatrix& m, Coefficient stiffness) {
  const auto in_dt = [&](const std::vector<Coefficient>& polynomial, int shift) {
    RealPolynomial out;
    Coefficient power = 1;
    for (std::size_t k = 0; k < polynomial.size(); ++k) {
      if (polynomial[k] != 0) out.add_term(std::size_t(int(2 * k) + shift), polynomial[k] * power);
      power *= stiffness;
    }
    return out;
  };
  return {{in_dt(m.xx, 0), in_dt(m.xv, 1)}, {in_dt(m.vx, -1), in_dt(m.vv, 0)}, RealPolynomial({1})};
}

}  // namespace

RealPolynomial StepMatrix::trace() const { return x.of_x + v.of_v; }
RealPolynomial StepMatrix::determinant() const { return x.of_x * v.of_v - x.of_v * v.of_x; }

StepMatrix step_matrix(const Theory& theory, Coefficient stiffness, Coefficient damping) {
  return theory.moves.empty() ? step_matrix(theory.oscillator, stiffness)
                              : step_matrix(theory.moves, stiffness, damping);
}

bool is_second_order(const Theory& theory) {
  return !theory.moves.empty() || !theory.oscillator.xx.empty() || theory.second_order_step;
}

std::vector<Coefficient> polynomial_matrix(const Theory& theory, Coefficient stiffness, Coefficient damping,
                                           Coefficient dt) {
  const auto m = step_matrix(theory, stiffness, damping);
  const Coefficient q = m.denominator(dt);
  return {m.x.of_x(dt) / q, m.v.of_x(dt) / q, m.x.of_v(dt) / q, m.v.of_v(dt) / q};
}

NonNegative second_order_stable(const Theory& theory, Coefficient stiffness, Coefficient damping) {
  if (theory.second_order_step) return function_stable(theory.second_order_step, stiffness, damping);
  const auto matrix = step_matrix(theory, stiffness, damping);
  const RealPolynomial trace = matrix.trace(), determinant = matrix.determinant(), &q = matrix.denominator;
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

Coefficient second_order_log_radius(const Theory& theory, Coefficient stiffness, Coefficient damping,
                                    Coefficient dt) {
  if (theory.second_order_step) return matrix_log_radius(theory.second_order_step(stiffness, damping, dt));
  const Coefficient rate = std::max(std::sqrt(std::abs(stiffness)), std::abs(damping)), h = dt * rate;
  const auto matrix =
      step_matrix(theory, rate == 0 ? 0 : stiffness / rate / rate, rate == 0 ? 0 : damping / rate);
  const Coefficient q = matrix.denominator(h);
  RealPolynomial deficit = matrix.denominator * matrix.denominator - matrix.determinant();
  deficit.clean();
  const Coefficient lost = deficit(h) / q / q;  // 1 - det, without the cancellation
  const Coefficient half = matrix.trace()(h) / q / 2, determinant = 1 - lost;
  const Coefficient square = half * half - determinant;
  if (square <= 0) return std::log1p(-lost) / 2;
  return std::log(std::abs(half) + std::sqrt(square));
}

}  // namespace odemark::detail
