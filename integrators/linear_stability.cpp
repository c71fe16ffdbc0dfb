// Limits of a whole problem: the stable sets of its eigenvalues, intersected.
#include "integrators/linear_stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "integrators/linear_stability_parts.hpp"

namespace odemark {

namespace {

bool has_function(const Theory& t) { return !t.numerator.empty(); }
using detail::is_multistep;
bool knows_no_damping(const Theory& t) { return !t.oscillator.xx.empty(); }

StabilityLimit unknown(std::string reason) {
  StabilityLimit out;
  out.reason = std::move(reason);
  return out;
}

StabilityLimit judge(const Intervals& stable, std::vector<Coefficient> touches) {
  StabilityLimit out;
  std::sort(touches.begin(), touches.end());
  for (const Coefficient t : touches)
    for (const auto& [low, high] : stable)
      if (t > low && t < high && (out.touches.empty() || t > out.touches.back())) out.touches.push_back(t);
  auto rest = stable.begin();
  if (stable.empty() || stable.front().first > 0) {
    out.verdict = Stability::unstable;
  } else {
    out.verdict = stable.front().second == detail::infinity ? Stability::unlimited : Stability::limit;
    out.limit = stable.front().second;
    ++rest;
  }
  out.later_bands.assign(rest, stable.end());
  return out;
}

}  // namespace

bool LinearProblem::grows() const {
  return std::any_of(eigenvalues.begin(), eigenvalues.end(),
                     [this](const WideComplex& l) { return l.real() > 1e-12L * fastest_rate; });
}

LinearProblem linear_problem(std::size_t size, const std::vector<Coefficient>& jacobian, bool second_order) {
  LinearProblem out;
  out.eigenvalues = eigenvalues(size, jacobian);
  for (const auto& l : out.eigenvalues) out.fastest_rate = std::max(out.fastest_rate, std::abs(l));
  if (second_order && size == 2) {
    out.second_order = true;
    out.stiffness = -jacobian[1], out.damping = -jacobian[3];
  }
  return out;
}

StabilityLimit stability_limit(const Theory& theory, const LinearProblem& problem) {
  if (!theory.blank_reason.empty()) return unknown(std::string(theory.blank_reason));
  if (problem.grows()) return unknown("the problem itself grows");
  if (problem.fastest_rate == 0) return unknown("nothing in this problem happens at a rate of its own");
  Intervals stable{{0, detail::infinity}};
  std::vector<Coefficient> touches;
  const auto require = [&](NonNegative found, Coefficient rate) {
    for (auto& [low, high] : found.where) low /= rate, high /= rate;
    for (const Coefficient t : found.touches) touches.push_back(t / rate);
    stable = intersection(stable, found.where);
  };
  if (detail::is_second_order(theory)) {
    if (!problem.second_order) return unknown("theory of second-order steps needs one degree of freedom");
    if (knows_no_damping(theory) && problem.damping != 0)
      return unknown("the method is for forces that do not depend on velocity");
    const Coefficient rate = problem.fastest_rate;
    require(detail::second_order_stable(theory, problem.stiffness / rate / rate, problem.damping / rate),
            rate);
  } else if (has_function(theory) || is_multistep(theory)) {
    if (is_multistep(theory) && !detail::zero_stable(theory)) return judge({}, {});
    for (const auto& l : problem.eigenvalues) {
      if (l == WideComplex(0) || l.imag() < 0) continue;  // kept exactly; conjugates behave alike
      const WideComplex direction = l / std::abs(l);
      require(is_multistep(theory) ? detail::multistep_stable_along_ray(theory, direction)
                                   : detail::stable_along_ray(theory, direction),
              std::abs(l));
    }
  } else if (!theory.exact_on_linear_part) {
    return unknown("this method gives no theory");
  }
  return judge(stable, touches);
}

Coefficient growth_per_step(const Theory& theory, const LinearProblem& problem, Coefficient dt) {
  const bool second_order = detail::is_second_order(theory),
             damped = knows_no_damping(theory) && problem.damping != 0;
  if (second_order && problem.second_order && !damped)
    return detail::second_order_log_radius(theory, problem.stiffness, problem.damping, dt);
  if (second_order || !theory.blank_reason.empty()) return std::numeric_limits<Coefficient>::quiet_NaN();
  Coefficient largest = -detail::infinity;
  for (const auto& l : problem.eigenvalues) {
    const WideComplex z = l * dt;
    largest = std::max(largest, l == WideComplex(0) ? 0
                                : theory.exact_on_linear_part
                                    ? z.real()
                                    : (is_multistep(theory) ? detail::multistep_log_amplification(theory, z)
                                                            : detail::log_amplification(theory, z)));
  }
  return largest;
}

Coefficient amplification(const Theory& theory, WideComplex z) {
  if (theory.exact_on_linear_part) return std::exp(z.real());
  if (is_multistep(theory)) return detail::largest_multistep_root(theory, z);
  if (!has_function(theory)) return std::numeric_limits<Coefficient>::quiet_NaN();
  const auto at = [&](const std::vector<Coefficient>& p) {
    WideComplex sum = 0;
    for (std::size_t k = p.size(); k-- > 0;) sum = sum * z + p[k];
    return std::abs(sum);
  };
  return at(theory.numerator) / at(theory.denominator);
}

std::vector<WideComplex> root_locus(const Theory& theory, Coefficient angle) {
  const WideComplex w = std::polar(Coefficient(1), angle);
  std::vector<WideComplex> in_z;
  for (const auto& c : detail::characteristic_of(theory)) {
    WideComplex sum = 0;
    for (std::size_t k = c.size(); k-- > 0;) sum = sum * w + c[k];
    in_z.push_back(sum);
  }
  return polynomial_roots(in_z);
}

}  // namespace odemark
