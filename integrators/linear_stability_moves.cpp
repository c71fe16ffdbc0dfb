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

/// A linear form in (x_n, v_n), over a common denominator.
struct Form {
  WidePolynomial of_x, of_v;
};
Form operator+(const Form& a, const Form& b) { return {a.of_x + b.of_x, a.of_v + b.of_v}; }
Form operator*(const WidePolynomial& p, const Form& a) { return {p * a.of_x, p * a.of_v}; }

struct StepMatrix {
  RealPolynomial trace, determinant,
      denominator;  // the matrix is that of trace and determinant / denominator
};

StepMatrix step_matrix(const std::vector<SecondOrderMove>& moves, Coefficient stiffness,
                       Coefficient damping) {
  using What = SecondOrderMove::What;
  const WidePolynomial one{1}, none{0};
  WidePolynomial denominator = one;
  const Form start_x{one, none}, start_v{none, one};
  Form x = start_x, v = start_v;
  const auto acceleration = [&](const Form& at, const Form& velocity) {
    return WidePolynomial{-stiffness} * at + WidePolynomial{-damping} * velocity;
  };
  const Form start_a = acceleration(start_x, start_v);
  for (const auto& move : moves) {
    const WidePolynomial step{0, move.weight};
    // what was known at the start has to be brought over the denominator of now
    const Form old_v = denominator * start_v, old_a = denominator * start_a;
    switch (move.what) {
      case What::drift: x = x + step * v; break;
      case What::kick: v = v + step * acceleration(x, v); break;
      case What::kick_start: v = v + step * old_a; break;
      case What::kick_old: v = v + step * acceleration(x, old_v); break;
      case What::kick_predicted: v = v + step * acceleration(x, old_v + WidePolynomial{0, 1} * old_a); break;
      case What::kick_implicit: {
        const WidePolynomial divisor{1, move.weight * damping};
        v = v + step * (WidePolynomial{-stiffness} * x);
        x = divisor * x;
        denominator = divisor * denominator;
        break;
      }
    }
  }
  return {(x.of_x + v.of_v).rounded(), (x.of_x * v.of_v - x.of_v * v.of_x).rounded(), denominator.rounded()};
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
  const Coefficient k = rate == 0 ? 0 : stiffness / rate / rate, d = rate == 0 ? 0 : damping / rate;
  if (std::all_of(moves.begin(), moves.end(), [](const SecondOrderMove& m) {
        return m.what == SecondOrderMove::What::drift || m.what == SecondOrderMove::What::kick;
      }))
    return log_radius(run_shears(moves, k, d, h));
  const auto matrix = step_matrix(moves, k, d);
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
