// Discrete Stieltjes procedure for the polynomials of ROCK2.
#include "integrators/rock2_polynomials.hpp"

#include <cmath>
#include <numbers>

namespace odemark {

namespace {

/// The zeros of w in x are 1 - (below -+ i aside) / stages^2. They were found by maximising the real interval
/// under |R| <= 0.95 on [-1, 1]; the third digit hardly matters to the interval, none matters to the order.
struct Zeros {
  std::size_t stages;
  Coefficient below, aside;
};
constexpr Zeros zeros[] = {
    {3, 2.672754077882L, 3.746694727689L},  {4, 2.859138278580L, 3.527172286833L},
    {5, 2.916171013818L, 3.461063604179L},  {6, 2.951794759300L, 3.429805752717L},
    {7, 2.966293006423L, 3.413006345059L},  {8, 2.973139233785L, 3.402748106520L},
    {9, 2.979401204383L, 3.395798034073L},  {10, 2.984577654115L, 3.390882112266L},
    {11, 2.988751884752L, 3.387279068500L}, {12, 2.992110883537L, 3.384559730448L},
    {13, 2.994829938786L, 3.382456694854L}, {14, 2.997050407085L, 3.380796539602L},
    {15, 2.998881197254L, 3.379462854446L}, {16, 3.000405148042L, 3.378375150123L},
    {17, 3.001685274079L, 3.377476329362L}, {18, 3.002769785005L, 3.376724973346L},
    {19, 3.003695865892L, 3.376090440832L}, {20, 3.004492462533L, 3.375549666377L},
    {22, 3.005783466520L, 3.374682822908L},
};

/// p_(k+1) = (x - alpha_k) p_k - beta_k p_(k-1), orthogonal with respect to w^2 / sqrt(1 - x^2): sums over
/// Chebyshev nodes are exact for the degrees that occur (W. Gautschi, Orthogonal Polynomials, Oxford
/// 2004, 2.2).
struct Orthogonal {
  Coefficient center, aside;  // zeros of w are center +- i aside
  std::vector<Coefficient> alpha, beta;

  explicit Orthogonal(const Zeros& of) {
    const Coefficient square = Coefficient(of.stages * of.stages);
    center = 1 - of.below / square, aside = of.aside / square;
    const std::size_t degree = of.stages - 2, nodes = of.stages + 4;
    std::vector<Coefficient> x(nodes), weight(nodes), now(nodes, 1), before(nodes, 0);
    for (std::size_t i = 0; i < nodes; ++i) {
      x[i] = std::cos(std::numbers::pi_v<Coefficient> * (Coefficient(i) + 0.5L) / Coefficient(nodes));
      weight[i] = w(x[i]) * w(x[i]);
    }
    Coefficient last = 0;
    for (std::size_t k = 0; k < degree; ++k) {
      Coefficient norm = 0, moment = 0;
      for (std::size_t i = 0; i < nodes; ++i) {
        const Coefficient part = weight[i] * now[i] * now[i];
        norm += part, moment += part * x[i];
      }
      alpha.push_back(moment / norm);
      beta.push_back(k > 0 ? norm / last : 0);
      last = norm;
      for (std::size_t i = 0; i < nodes; ++i) {
        const Coefficient next = (x[i] - alpha[k]) * now[i] - beta[k] * before[i];
        before[i] = now[i], now[i] = next;
      }
    }
  }
  Coefficient w(Coefficient x) const { return (x - center) * (x - center) + aside * aside; }
};

/// r = w p with two derivatives.
struct Jet {
  Coefficient value, first, second;
};
Jet product(const Orthogonal& family, Coefficient x) {
  Jet before{0, 0, 0}, p{1, 0, 0};
  for (std::size_t k = 0; k < family.alpha.size(); ++k) {
    const Coefficient shifted = x - family.alpha[k], beta = family.beta[k];
    const Jet next{shifted * p.value - beta * before.value, p.value + shifted * p.first - beta * before.first,
                   2 * p.first + shifted * p.second - beta * before.second};
    before = p, p = next;
  }
  const Coefficient w = family.w(x), slope = 2 * (x - family.center);
  return {w * p.value, slope * p.value + w * p.first, 2 * p.value + 2 * slope * p.first + w * p.second};
}

/// The image of z = 0: R = 1 + z + z^2/2 + ... there means r r'' = r'^2, and the last such point is right
/// of 1.
Coefficient origin_of(const Orthogonal& family, std::size_t stages) {
  const auto bend = [&](Coefficient x) {
    const Jet r = product(family, x);
    return r.value * r.second - r.first * r.first;
  };
  Coefficient low = 1, high = 1 + 4 / Coefficient(stages * stages);
  for (int n = 0; n < 80; ++n) {
    const Coefficient middle = (low + high) / 2;
    (bend(middle) > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

Rock2Polynomial make(const Zeros& of) {
  const Orthogonal family(of);
  const Coefficient a = origin_of(family, of.stages);
  const Jet r = product(family, a);
  const Coefficient scale = r.first / r.value;  // z = scale (x - a)
  Rock2Polynomial out;
  out.stages = of.stages;
  out.real_interval = scale * (a + 1);
  out.sigma = (a - family.center) / (family.w(a) * scale);
  out.tau = 1 / (family.w(a) * scale * scale);
  out.recurrence.resize(of.stages - 1);
  Coefficient before = 0, now = 1;  // p_(j-2)(a), p_(j-1)(a)
  for (std::size_t j = 1; j < out.recurrence.size(); ++j) {
    const Coefficient shifted = a - family.alpha[j - 1];
    const Coefficient next = shifted * now - family.beta[j - 1] * before;
    out.recurrence[j] = {shifted * now / next, -family.beta[j - 1] * before / next, now / (next * scale), 0,
                         0};
    before = now, now = next;
  }
  return out;
}

}  // namespace

const std::vector<Rock2Polynomial>& rock2_polynomials() {
  static const std::vector<Rock2Polynomial> all = [] {
    std::vector<Rock2Polynomial> made;
    for (const auto& of : zeros) made.push_back(make(of));
    return made;
  }();
  return all;
}

const Rock2Polynomial& rock2_polynomial(std::size_t stages) {
  for (const auto& polynomial : rock2_polynomials())
    if (polynomial.stages == stages) return polynomial;
  return rock2_polynomials().back();
}

}  // namespace odemark
