// Does step control settle where stability limits the step? The recursion of (ln |y|, ln h) linearised there.
#include <algorithm>
#include <cmath>

#include "integrators/facts_parts.hpp"
#include "integrators/linear_stability_parts.hpp"
#include "integrators/step_control.hpp"

namespace odemark::detail {

namespace {

std::vector<Coefficient> slope(const std::vector<Coefficient>& p) {
  std::vector<Coefficient> out;
  for (std::size_t k = 1; k < p.size(); ++k) out.push_back(Coefficient(k) * p[k]);
  return out;
}

}  // namespace

/// G. Hall, D. J. Higham, IMA J. Numer. Anal. 8 (1988) 329-346: at |R(z)| = 1 a step by factor e^d in h
/// changes ln |y| by u d with u = Re(z R'/R), and the estimate R^ - R of the pair by v d.
/// `control_order` is the power of h that the estimate shrinks with.
std::map<std::string, Coefficient> controller_radii(const Theory& main, const Theory& embedded, Coefficient x,
                                                    int control_order) {
  const WideComplex z = x;
  const auto &p = main.numerator, &q = main.denominator;
  const WideComplex u = z * (value_at(slope(p), z) / value_at(p, z) - value_at(slope(q), z) / value_at(q, z));
  // R^ - R = (P^ Q - P Q^) / (Q Q^); for explicit pairs both denominators are 1
  const auto difference = [&](WideComplex w) {
    return value_at(embedded.numerator, w) / value_at(embedded.denominator, w) -
           value_at(p, w) / value_at(q, w);
  };
  const auto derivative = [&](const Theory& t) {
    const WideComplex d = value_at(t.denominator, z);
    return (value_at(slope(t.numerator), z) * d -
            value_at(t.numerator, z) * value_at(slope(t.denominator), z)) /
           d / d;
  };
  const WideComplex v = z * (derivative(embedded) - derivative(main)) / difference(z);
  std::map<std::string, Coefficient> out;
  const auto radius = [&](Coefficient a, Coefficient b, Coefficient c) {
    // state: ln |y|, ln h, the last ln of the estimate, the last ln h
    const Coefficient m[4][4] = {
        {1, u.real(), 0, 0}, {-a, 1 - a * v.real() - c, b, c}, {1, v.real(), 0, 0}, {0, 1, 0, 0}};
    std::vector<Coefficient> columns;
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < 4; ++i) columns.push_back(m[i][j]);
    Coefficient largest = 0;
    for (const auto& l : eigenvalues(4, columns)) largest = std::max(largest, std::abs(l));
    return largest;
  };
  const auto k = Coefficient(control_order);
  for (const StepFilter* f : step_filters)
    out[std::string(f->id)] = radius(f->error / k, -f->previous_error / k, f->previous_ratio);
  // what the code of Hairer, Norsett & Wanner does (Solving ODEs I, appendix)
  out["dopri"] = radius(1 / k - 0.03L, 0.04L, 0);
  return out;
}

}  // namespace odemark::detail
