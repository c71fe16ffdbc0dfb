// Second-order steps on x'' = -stiffness x - damping v: a 2x2 matrix whose entries are polynomials in dt.
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "integrators/linear_stability_parts.hpp"

namespace odemark::detail {

namespace {

/// Thirty moves with weights beyond 1 cancel to coefficients 1e-14 of what they are summed from: in extended
/// precision no digit would be left.
using Wide =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

/// Ascending powers; `magnitude` as in RealPolynomial.
struct WidePolynomial {
  std::vector<Wide> value, magnitude;

  WidePolynomial(std::initializer_list<Wide> coefficients) : value(coefficients) {
    for (const Wide& c : value) magnitude.push_back(abs(c));
  }
  void grow(std::size_t count) {
    if (value.size() < count) value.resize(count, 0), magnitude.resize(count, 0);
  }
  /// What the weights' own rounding leaves of a zero is a zero; the rest is known to every digit.
  RealPolynomial rounded() const {
    RealPolynomial out;
    for (std::size_t k = 0; k < value.size(); ++k)
      out.add_term(k, abs(value[k]) <= 1e-50 * magnitude[k] ? 0 : static_cast<Coefficient>(value[k]));
    return out;
  }
};
WidePolynomial operator+(const WidePolynomial& a, const WidePolynomial& b) {
  WidePolynomial out = a;
  out.grow(b.value.size());
  for (std::size_t k = 0; k < b.value.size(); ++k)
    out.value[k] += b.value[k], out.magnitude[k] += b.magnitude[k];
  return out;
}
WidePolynomial operator*(const WidePolynomial& a, const WidePolynomial& b) {
  WidePolynomial out{};
  out.grow(a.value.size() + b.value.size() - 1);
  for (std::size_t i = 0; i < a.value.size(); ++i)
    for (std::size_t j = 0; j < b.value.size(); ++j) {
      if (a.magnitude[i] == 0 || b.magnitude[j] == 0) continue;
      out.value[i + j] += a.value[i] * b.value[j];
      out.magnitude[i + j] += a.magnitude[i] * b.magnitude[j];
    }
  return out;
}
WidePolynomial operator-(const WidePolynomial& a, const WidePolynomial& b) {
  return a + WidePolynomial{-1} * b;
}

struct WideForm {
  WidePolynomial of_x, of_v;
  Form rounded() const { return {of_x.rounded(), of_v.rounded()}; }
};
WideForm operator+(const WideForm& a, const WideForm& b) { return {a.of_x + b.of_x, a.of_v + b.of_v}; }
WideForm operator*(const WidePolynomial& p, const WideForm& a) { return {p * a.of_x, p * a.of_v}; }

StepMatrix step_matrix(const std::vector<SecondOrderMove>& moves, Coefficient stiffness,
                       Coefficient damping) {
  const WidePolynomial one{1}, none{0};
  WidePolynomial denominator = one;
  const WideForm start_x{one, none}, start_v{none, one};
  WideForm x = start_x, v = start_v;
  const auto acceleration = [&](const WideForm& at, const WideForm& velocity) {
    return WidePolynomial{-stiffness} * at + WidePolynomial{-damping} * velocity;
  };
  const WideForm start_a = acceleration(start_x, start_v);
  for (const auto& move : moves) {
    const WidePolynomial step{0, move.weight};
    // what was known at the start has to be brought over the denominator of now
    const WideForm old_v = denominator * start_v, old_a = denominator * start_a;
    switch (move.what) {
      case SecondOrderMove::What::drift: x = x + step * v; break;
      case SecondOrderMove::What::kick: v = v + step * acceleration(x, v); break;
      case SecondOrderMove::What::kick_start: v = v + step * old_a; break;
      case SecondOrderMove::What::kick_old: v = v + step * acceleration(x, old_v); break;
      case SecondOrderMove::What::kick_predicted:
        v = v + step * acceleration(x, old_v + WidePolynomial{0, 1} * old_a);
        break;
      case SecondOrderMove::What::kick_implicit: {
        const WidePolynomial divisor{1, move.weight * damping};
        v = v + step * (WidePolynomial{-stiffness} * x);
        x = divisor * x;
        denominator = divisor * denominator;
        break;
      }
    }
  }
  return {x.rounded(), v.rounded(), denominator.rounded(), (x.of_x + v.of_v).rounded(),
          (x.of_x * v.of_v - x.of_v * v.of_x).rounded()};
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
  const Form x{in_dt(m.xx, 0), in_dt(m.xv, 1)}, v{in_dt(m.vx, -1), in_dt(m.vv, 0)};
  return {x, v, RealPolynomial({1}), x.of_x + v.of_v, x.of_x * v.of_v - x.of_v * v.of_x};
}

/// Drifts and kicks run in numbers: half the trace, and the determinant, to which only what a kick takes from
/// the velocity it sees contributes.
struct Run {
  Coefficient half_trace, log_determinant = 0;
  int sign = 1;
};
Run run_shears(const std::vector<SecondOrderMove>& moves, Coefficient stiffness, Coefficient damping,
               Coefficient h) {
  Coefficient x[2] = {1, 0}, v[2] = {0, 1};
  Run run;
  for (const auto& move : moves) {
    const Coefficient w = move.weight * h;
    if (move.what == SecondOrderMove::What::drift) {
      for (int i = 0; i < 2; ++i) x[i] += w * v[i];
    } else {
      for (int i = 0; i < 2; ++i) v[i] -= w * (stiffness * x[i] + damping * v[i]);
      const Coefficient left = -w * damping;
      if (1 + left < 0) run.sign = -run.sign;
      run.log_determinant += left > -1 ? std::log1p(left) : std::log(-1 - left);
    }
  }
  run.half_trace = (x[0] + v[1]) / 2;
  return run;
}

/// ln of the larger root of w^2 - 2 half_trace w + determinant.
Coefficient log_radius(const Run& run) {
  if (!std::isfinite(run.log_determinant)) return std::log(2 * std::abs(run.half_trace));
  // in units of the root of the determinant; beyond 1 there are two real roots, up to rounding
  const Coefficient ratio = std::abs(run.half_trace) * std::exp(-run.log_determinant / 2);
  if (run.sign < 0) return run.log_determinant / 2 + std::asinh(ratio);
  if (ratio <= 1 + 16 * std::numeric_limits<Coefficient>::epsilon()) return run.log_determinant / 2;
  return run.log_determinant / 2 + std::acosh(ratio);
}

}  // namespace

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
  const RealPolynomial &trace = matrix.trace, &determinant = matrix.determinant, &q = matrix.denominator;
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
  const Coefficient k = rate == 0 ? 0 : stiffness / rate / rate, d = rate == 0 ? 0 : damping / rate;
  const auto is_shear = [](const SecondOrderMove& m) {
    return m.what == SecondOrderMove::What::drift || m.what == SecondOrderMove::What::kick;
  };
  if (!theory.moves.empty() && std::all_of(theory.moves.begin(), theory.moves.end(), is_shear))
    return log_radius(run_shears(theory.moves, k, d, h));
  const auto matrix = step_matrix(theory, k, d);
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
