// Intervals, angles and limits of a stability function or of a multistep method.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "integrators/facts_parts.hpp"
#include "integrators/linear_stability_parts.hpp"

namespace odemark::detail {

namespace {

LinearProblem one_eigenvalue(WideComplex lambda) {
  LinearProblem p;
  p.eigenvalues = {lambda}, p.fastest_rate = std::abs(lambda);
  return p;
}

/// The ray of all h > 0 at `degrees` from the negative real axis.
LinearProblem ray(Coefficient degrees) {
  const Coefficient a = degrees * std::numbers::pi_v<Coefficient> / 180;
  return one_eigenvalue({-std::cos(a), std::sin(a)});
}

/// Largest y such that the step grows by at most 1 + epsilon at every point of the imaginary axis up to it.
Coefficient epsilon_interval(const Theory& theory, Coefficient epsilon) {
  if (is_one_step_function(theory)) {
    const auto squared = [](const std::vector<Coefficient>& p, Coefficient factor) {
      RealPolynomial out;
      for (std::size_t j = 0; j < p.size(); ++j)
        for (std::size_t k = 0; k < p.size(); ++k)
          if ((j + k) % 2 == 0)
            out.add_term(j + k, factor * p[j] * p[k] * ((j > k ? j - k : k - j) % 4 == 0 ? 1 : -1));
      return out;
    };
    RealPolynomial room =
        squared(theory.denominator, (1 + epsilon) * (1 + epsilon)) - squared(theory.numerator, 1);
    room.clean();
    const auto found = where_not_negative(room);
    return found.where.empty() || found.where.front().first > 0 ? 0 : found.where.front().second;
  }
  // several roots: no polynomial in y; scanned in steps of 1/200, which is narrow beside any known limit
  const auto fits = [&](Coefficient y) { return amplification(theory, {0, y}) <= 1 + epsilon; };
  Coefficient low = 0;
  while (low < 100 && fits(low + 0.005L)) low += 0.005L;
  if (low >= 100) return infinity;
  Coefficient high = low + 0.005L;
  for (int i = 0; i < 60; ++i) (fits((low + high) / 2) ? low : high) = (low + high) / 2;
  return low;
}

bool poles_on_the_right(const Theory& theory) {
  if (!is_one_step_function(theory)) return true;
  const auto poles = polynomial_roots({theory.denominator.begin(), theory.denominator.end()});
  return std::all_of(poles.begin(), poles.end(), [](const WideComplex& p) { return p.real() > 0; });
}

bool never_limited(const Theory& theory, const LinearProblem& p) {
  return stability_limit(theory, p).verdict == Stability::unlimited;
}

/// The largest angle about the negative real axis within which no ray has a limit.
Coefficient widest_angle(const Theory& theory) {
  if (!never_limited(theory, ray(0))) return 0;
  Coefficient low = 0, high = 0;
  while (high < 90) {
    high = std::min(high + 2, Coefficient(90));
    if (!never_limited(theory, high == 90 ? one_eigenvalue({0, 1}) : ray(high))) break;
    low = high;
  }
  if (low == 90) return 90;
  // the last piece of the way: near the axis a wedge can be thinner than a step
  for (int i = 0; i < 48; ++i) {
    const Coefficient middle = (low + high) / 2;
    (never_limited(theory, ray(middle)) ? low : high) = middle;
  }
  return low;
}

/// BDF-like methods: the boundary is the root locus, so the angle is where it leans out furthest.
Coefficient angle_of_locus(const Theory& theory) {
  const auto locus = [&](Coefficient at) {
    const WideComplex w = std::polar(Coefficient(1), at);
    const auto value = [w](const std::vector<Coefficient>& p) {
      WideComplex sum = 0;
      for (std::size_t k = p.size(); k-- > 0;) sum = sum * w + p[k];
      return sum;
    };
    return value(theory.rho) / value(theory.sigma);
  };
  const auto angle = [&](Coefficient at) {
    const WideComplex z = locus(at);
    return z.real() < 0 ? std::atan2(std::abs(z.imag()), -z.real()) : std::numbers::pi_v<Coefficient> / 2;
  };
  constexpr int samples = 2000;
  Coefficient best = std::numbers::pi_v<Coefficient> / 2, where = 0;
  for (int i = 1; i < samples; ++i) {
    const Coefficient at = std::numbers::pi_v<Coefficient> * Coefficient(i) / samples;
    // next to 0 the locus hugs the imaginary axis closer than it can be computed
    if (std::abs(locus(at)) > 1e-2L && angle(at) < best) best = angle(at), where = at;
  }
  if (where == 0) return 90;
  constexpr Coefficient golden = 0.61803398874989484820L;
  const Coefficient step = std::numbers::pi_v<Coefficient> / samples;
  Coefficient low = where - step, high = where + step;
  for (int i = 0; i < 80; ++i) {
    const Coefficient a = high - golden * (high - low), b = low + golden * (high - low);
    (angle(a) < angle(b) ? high : low) = angle(a) < angle(b) ? b : a;
  }
  return std::min(best, angle((low + high) / 2)) * 180 / std::numbers::pi_v<Coefficient>;
}

/// A characteristic polynomial in w whose coefficients are polynomials in z: for large z its roots are those
/// of the highest power of z, and as many go to infinity as that has lost powers of w.
Fact<Coefficient> at_infinity(const std::vector<std::vector<Coefficient>>& characteristic) {
  const auto degree = [](const std::vector<Coefficient>& row) {
    std::size_t size = row.size();
    while (size > 0 && row[size - 1] == 0) --size;
    return size;  // 0: nothing there
  };
  std::size_t highest = 0, last = 0;
  for (std::size_t k = 0; k < characteristic.size(); ++k) {
    highest = std::max(highest, degree(characteristic[k]));
    if (degree(characteristic[k]) > 0) last = k;
  }
  const auto& row = characteristic[last];
  if (degree(row) < highest) return infinity;
  Coefficient largest = 0;
  for (const auto& w : polynomial_roots({row.begin(), row.begin() + std::ptrdiff_t(highest)}))
    largest = std::max(largest, std::abs(w));
  return {largest, "the largest root of the highest power of z"};
}

Fact<Coefficient> at_infinity(const Theory& theory) {
  if (is_one_step_function(theory)) {
    auto p = theory.numerator;
    const auto& q = theory.denominator;
    while (p.size() > 1 && p.size() <= q.size() && std::abs(p.back()) <= 1e-9L * std::abs(q[p.size() - 1]))
      p.pop_back();
    if (p.size() < q.size()) return Coefficient(0);
    if (p.size() > q.size()) return infinity;
    return p.back() / q.back();
  }
  if (theory.sigma.empty()) return at_infinity(theory.characteristic);
  auto sigma = theory.sigma;
  while (!sigma.empty() && sigma.back() == 0) sigma.pop_back();
  if (sigma.size() < theory.rho.size()) return infinity;
  Coefficient largest = 0;
  for (const auto& w : polynomial_roots({sigma.begin(), sigma.end()}))
    largest = std::max(largest, std::abs(w));
  return {largest < 1e-4L ? 0 : largest, "the largest root of sigma"};
}

}  // namespace

bool takes_several_steps(const Theory& t) { return !t.rho.empty() || !t.characteristic.empty(); }

StabilityFacts no_stability_facts(const std::string& why) {
  StabilityFacts out;
  out.real_interval = out.imaginary_interval = out.imaginary_interval_eps = out.r_infinity =
      out.a_alpha_degrees = Fact<Coefficient>::none(why);
  out.real_islands = out.imaginary_bands = Fact<Intervals>::none(why);
  out.log_amplification = out.phase_error = Fact<PowerLaw>::none(why);
  out.a_stable = out.l_stable = Fact<bool>::none(why);
  return out;
}

StabilityFacts stability_facts(const Theory& theory) {
  if (!theory.moves.empty())
    return no_stability_facts("a second-order step has no R(z): see oscillator_limit");
  if (theory.exact_on_linear_part) {
    StabilityFacts out = no_stability_facts("exact on the linear part");
    out.real_interval = out.imaginary_interval = out.imaginary_interval_eps = infinity;
    out.real_islands = out.imaginary_bands = Intervals{};
    out.r_infinity = Coefficient(0), out.a_stable = out.l_stable = true,
    out.a_alpha_degrees = Coefficient(90);
    return out;
  }
  if (!is_one_step_function(theory) && !takes_several_steps(theory))
    return no_stability_facts(theory.blank_reason.empty() ? "nothing is known of its effect on y' = lambda y"
                                                          : std::string(theory.blank_reason));
  StabilityFacts out = no_stability_facts("not known");
  const auto interval = [&](const LinearProblem& p, Fact<Coefficient>& length, Fact<Intervals>& bands) {
    const auto found = stability_limit(theory, p);
    if (found.verdict == Stability::unknown) {
      length = Fact<Coefficient>::none(found.reason), bands = Fact<Intervals>::none(found.reason);
      return;
    }
    length = found.verdict == Stability::unlimited ? infinity : found.limit;
    if (!found.touches.empty())
      length.reason = "touches the boundary " + std::to_string(found.touches.size()) + " times from within";
    bands = found.later_bands;
  };
  interval(one_eigenvalue(-1), out.real_interval, out.real_islands);
  interval(one_eigenvalue({0, 1}), out.imaginary_interval, out.imaginary_bands);
  if (!out.real_interval) return no_stability_facts(out.real_interval.reason);
  out.imaginary_interval_eps = epsilon_interval(theory, 1e-3L);
  const auto root = principal_root(theory);
  out.log_amplification = root.log_amplification, out.phase_error = root.phase_error;
  out.r_infinity = at_infinity(theory);
  const bool explicit_step = out.r_infinity && *out.r_infinity == infinity;
  const bool a_stable =
      *out.imaginary_interval == infinity && *out.real_interval == infinity && poles_on_the_right(theory);
  out.a_stable = a_stable;
  out.l_stable = a_stable && out.r_infinity && std::abs(*out.r_infinity) < 1e-9L;
  if (a_stable)
    out.a_alpha_degrees = Coefficient(90);
  else if (explicit_step || *out.real_interval != infinity)
    out.a_alpha_degrees = Fact<Coefficient>::none("its region is bounded on the negative real axis");
  else
    out.a_alpha_degrees =
        is_one_step_function(theory) || theory.rho.empty() ? widest_angle(theory) : angle_of_locus(theory);
  return out;
}

}  // namespace odemark::detail
