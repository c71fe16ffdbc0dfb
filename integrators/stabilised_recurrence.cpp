// Chebyshev, Legendre and ROCK recurrences from their definitions.
#include "integrators/stabilised_recurrence.hpp"

#include <algorithm>
#include <cmath>

#include "integrators/rock_polynomials.hpp"

namespace odemark {

namespace {

/// T_j and its first two derivatives at one point.
struct Chebyshev {
  Coefficient value, first, second;
};
struct ChebyshevSequence {
  Coefficient at;
  Chebyshev before{1, 0, 0}, now;
  explicit ChebyshevSequence(Coefficient w) : at(w), now{w, 1, 0} {}
  void advance() {
    const Chebyshev next{2 * at * now.value - before.value, 2 * now.value + 2 * at * now.first - before.first,
                         4 * now.first + 2 * at * now.second - before.second};
    before = now, now = next;
  }
};
Chebyshev chebyshev(std::size_t degree, Coefficient w) {
  ChebyshevSequence sequence(w);
  for (std::size_t j = 1; j < degree; ++j) sequence.advance();
  return sequence.now;
}

/// B. P. Sommeijer, L. F. Shampine, J. G. Verwer, J. Comput. Appl. Math. 88 (1998) 315-326; damping of the
/// first-order method as in J. G. Verwer, Appl. Numer. Math. 22 (1996) 359-379.
Coefficient shift(StabilisedFamily family, std::size_t s) {
  const Coefficient damping = family == StabilisedFamily::rkc1 ? 0.05L : 2.0L / 13;
  return 1 + damping / (Coefficient(s) * Coefficient(s));
}
Coefficient stretch(StabilisedFamily family, std::size_t s) {
  const auto t = chebyshev(s, shift(family, s));
  return family == StabilisedFamily::rkc1 ? t.value / t.first : t.first / t.second;
}

void fill_chebyshev(StabilisedFamily family, std::size_t s, std::vector<RecurrenceStage>& out) {
  const bool second = family == StabilisedFamily::rkc2;
  const Coefficient w0 = shift(family, s), w1 = stretch(family, s);
  ChebyshevSequence sequence(w0);
  const Coefficient start = second ? 1 / (4 * w0 * w0) : 1 / w0;  // b_1
  Coefficient b2 = second ? start : 1, b1 = start;                // b_(j-2), b_(j-1)
  Coefficient a1 = second ? 1 - b1 * w0 : 0;                      // a_(j-1)
  out[1] = {0, 0, b1 * w1, 0, 0};
  for (std::size_t j = 2; j <= s; ++j) {
    sequence.advance();
    const Chebyshev& t = sequence.now;
    const Coefficient b = second ? t.second / (t.first * t.first) : 1 / t.value;
    const Coefficient slope = 2 * b * w1 / b1;
    out[j] = {2 * b * w0 / b1, -b / b2, slope, -a1 * slope, 0};
    a1 = second ? 1 - b * t.value : 0;
    b2 = b1, b1 = b;
  }
}

/// C. D. Meyer, D. S. Balsara, T. D. Aslam, J. Comput. Phys. 257 (2014) 594-626.
void fill_legendre(std::size_t s, std::vector<RecurrenceStage>& out) {
  const auto b = [](std::size_t j) {
    const Coefficient n = Coefficient(j);
    return j < 2 ? 1.0L / 3 : (n * n + n - 2) / (2 * n * (n + 1));
  };
  const Coefficient w1 = 4 / (Coefficient(s) * Coefficient(s) + Coefficient(s) - 2);
  out[1] = {0, 0, b(1) * w1, 0, 0};
  for (std::size_t j = 2; j <= s; ++j) {
    const Coefficient n = Coefficient(j), mu = (2 * n - 1) / n * b(j) / b(j - 1);
    out[j] = {mu, -(n - 1) / n * b(j) / b(j - 2), mu * w1, -(1 - b(j - 1)) * mu * w1, 0};
  }
}

bool is_rock(StabilisedFamily family) {
  return family == StabilisedFamily::rock2 || family == StabilisedFamily::rock4;
}

}  // namespace

Coefficient internal_amplification(StabilisedFamily family, std::size_t s) {
  if (!is_rock(family)) return Coefficient(s) * Coefficient(s);
  const auto& polynomial = rock_polynomial(family, s);
  Coefficient w = 0;
  for (std::size_t k = polynomial.last.size(); k-- > 0;)
    w = polynomial.last[k] - w * polynomial.real_interval;
  return std::abs(w);
}

std::size_t stage_cap(StabilisedFamily family, Coefficient roundoff) {
  const Coefficient bound = 10 * std::sqrt(roundoff);
  if (!is_rock(family)) {
    std::size_t s = family == StabilisedFamily::rkl2 ? 201 : 200;
    while (s > 3 && internal_amplification(family, s) * roundoff > bound) s -= 2;
    return s;
  }
  std::size_t largest = 0;
  for (const auto& polynomial : rock_polynomials(family))
    if (largest == 0 || internal_amplification(family, polynomial.stages) * roundoff <= bound)
      largest = polynomial.stages;
  return largest;
}

Coefficient real_interval(StabilisedFamily family, std::size_t s) {
  if (is_rock(family)) return rock_polynomial(family, s).real_interval;
  const Coefficient n = Coefficient(s);
  return family == StabilisedFamily::rkl2 ? (n * n + n - 2) / 2 : (shift(family, s) + 1) / stretch(family, s);
}

std::size_t stages_for(StabilisedFamily family, Coefficient reach, std::size_t cap) {
  if (is_rock(family)) {
    for (const auto& candidate : rock_polynomials(family))
      if (reach <= candidate.real_interval && candidate.stages <= cap) return candidate.stages;
    return cap;
  }
  // odd numbers of stages damp the fastest modes in RKL2
  const bool legendre = family == StabilisedFamily::rkl2;
  const std::size_t pace = legendre ? 2 : 1;
  const Coefficient wide = legendre ? 2 : family == StabilisedFamily::rkc1 ? 0.55L : 1.6L;  // s^2 / interval
  std::size_t s = legendre ? 3 : family == StabilisedFamily::rkc1 ? 1 : 2;
  if (!(reach < Coefficient(cap * cap))) return cap;
  // start a little below what is needed: the interval is known in closed form but not its inverse
  while (s + pace <= cap && Coefficient((s + 2) * (s + 2)) < 0.9L * wide * reach) s += pace;
  while (s < cap && !(reach <= real_interval(family, s))) s += pace;
  return std::min(s, cap);
}

StabilisedRecurrence room_for(StabilisedFamily family) {
  StabilisedRecurrence room;
  room.stages.resize(stage_cap(family) + 1);
  return room;
}

void fill_recurrence(StabilisedFamily family, std::size_t s, StabilisedRecurrence& out) {
  out.count = s, out.last = {1};
  if (is_rock(family)) {
    const auto& polynomial = rock_polynomial(family, s);
    out.count = polynomial.recurrence.size() - 1;
    std::copy(polynomial.recurrence.begin(), polynomial.recurrence.end(), out.stages.begin());
    out.last = polynomial.last, out.finish = polynomial.finish;
  } else if (family == StabilisedFamily::rkl2) {
    fill_legendre(s, out.stages);
  } else {
    fill_chebyshev(family, s, out.stages);
  }
  // a stage stands where y' = 1 takes it
  for (std::size_t j = 1; j <= out.count; ++j) {
    auto& stage = out.stages[j];
    const Coefficient before = j > 1 ? out.stages[j - 2].node : 0;
    stage.node = stage.mu * out.stages[j - 1].node + stage.nu * before + stage.slope + stage.first_slope;
  }
}

std::complex<Coefficient> stability_value(StabilisedFamily family, std::size_t s,
                                          std::complex<Coefficient> z) {
  auto recurrence = room_for(family);
  fill_recurrence(family, s, recurrence);
  std::complex<Coefficient> before = 0, now = 0;  // Y_j - Y_0, in units of Y_0
  for (std::size_t j = 1; j <= recurrence.count; ++j) {
    const auto& stage = recurrence.stages[j];
    const auto next =
        stage.mu * now + stage.nu * before + z * (stage.slope * (1.0L + now) + stage.first_slope);
    before = now, now = next;
  }
  std::complex<Coefficient> last = 0;
  for (std::size_t k = recurrence.last.size(); k-- > 0;) last = last * z + recurrence.last[k];
  return (1.0L + now) * last;
}

std::vector<Coefficient> stability_polynomial(StabilisedFamily family, std::size_t s) {
  auto recurrence = room_for(family);
  fill_recurrence(family, s, recurrence);
  using Polynomial = std::vector<Coefficient>;
  const std::size_t length = recurrence.count + 1;
  Polynomial before(length, 0), now(length, 0), next(length, 0);
  for (std::size_t j = 1; j <= recurrence.count; ++j) {
    const auto& stage = recurrence.stages[j];
    for (std::size_t k = 0; k < length; ++k) {
      next[k] = stage.mu * now[k] + stage.nu * before[k];
      if (k > 0) next[k] += stage.slope * (now[k - 1] + Coefficient(k == 1));
      if (k == 1) next[k] += stage.first_slope;
    }
    before = now, now = next;
  }
  now[0] += 1;
  std::size_t degree = recurrence.last.size() - 1;
  while (recurrence.last[degree] == 0) --degree;
  Polynomial product(length + degree, 0);
  for (std::size_t k = 0; k < length; ++k)
    for (std::size_t j = 0; j <= degree; ++j) product[k + j] += recurrence.last[j] * now[k];
  return product;
}

}  // namespace odemark
