// Discrete Stieltjes procedure for the polynomials of ROCK2 and ROCK4.
#include "integrators/rock_polynomials.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace odemark {

namespace {

/// A pair of zeros of w in x: 1 - (below -+ i aside) / stages^2. They were found by maximising the real
/// interval under |R| <= 0.95 on [-1, 1] (0.951 in places); the third digit hardly matters to the interval,
/// none matters to the order.
struct Pair {
  Coefficient below, aside;
};
struct Zeros {
  std::size_t stages;
  Pair first, second{};    // aside 0: ROCK2, one pair
  Coefficient origin = 0;  // ROCK4: the image of z = 0 is 1 + origin / stages^2
};
constexpr Zeros rock2_zeros[] = {
    {3, {2.672754077882L, 3.746694727689L}},   {4, {2.859138278580L, 3.527172286833L}},
    {5, {2.916171013818L, 3.461063604179L}},   {6, {2.951794759300L, 3.429805752717L}},
    {7, {2.966293006423L, 3.413006345059L}},   {8, {2.973139233785L, 3.402748106520L}},
    {9, {2.979401204383L, 3.395798034073L}},   {10, {2.984577654115L, 3.390882112266L}},
    {11, {2.988751884752L, 3.387279068500L}},  {12, {2.992110883537L, 3.384559730448L}},
    {13, {2.994829938786L, 3.382456694854L}},  {14, {2.997050407085L, 3.380796539602L}},
    {15, {2.998881197254L, 3.379462854446L}},  {16, {3.000405148042L, 3.378375150123L}},
    {17, {3.001685274079L, 3.377476329362L}},  {18, {3.002769785005L, 3.376724973346L}},
    {19, {3.003695865892L, 3.376090440832L}},  {20, {3.004492462533L, 3.375549666377L}},
    {22, {3.005783466520L, 3.374682822908L}},  {24, {3.006774576279L, 3.374025098874L}},
    {26, {3.007551328603L, 3.373514186358L}},  {28, {3.008171006061L, 3.373109388977L}},
    {30, {3.008673075005L, 3.372783204883L}},  {32, {3.009085397842L, 3.372516504283L}},
    {34, {3.009428082338L, 3.372295645214L}},  {36, {3.009715923887L, 3.372110686208L}},
    {38, {3.009959998332L, 3.371954243179L}},  {40, {3.010168728171L, 3.371820738399L}},
    {45, {3.010575129610L, 3.371561546475L}},  {50, {3.010866552815L, 3.371376284466L}},
    {55, {3.011082561975L, 3.371239284921L}},  {60, {3.011247075494L, 3.371135127374L}},
    {65, {3.011335645077L, 3.371055839045L}},  {70, {3.011405879197L, 3.370992943995L}},
    {75, {3.011462529047L, 3.370942214234L}},  {80, {3.011508893807L, 3.370900702410L}},
    {85, {3.011547310679L, 3.370866303468L}},  {90, {3.011579502669L, 3.370837480137L}},
    {95, {3.011606742788L, 3.370813089436L}},  {100, {3.011629998754L, 3.370792266779L}},
    {110, {3.011667353422L, 3.370758818987L}}, {120, {3.011695763023L, 3.370733381925L}},
    {130, {3.011717870465L, 3.370713587591L}}, {140, {3.011735410647L, 3.370697882445L}},
    {150, {3.011749560363L, 3.370685213009L}}, {160, {3.011761140463L, 3.370674844449L}},
    {170, {3.011770737380L, 3.370666251543L}}, {180, {3.011778779478L, 3.370659050818L}},
    {190, {3.011785585315L, 3.370652956999L}}, {200, {3.011791395923L, 3.370647754300L}},
};
constexpr Zeros rock4_zeros[] = {
    {5, {-14.660854936408L, 17.626507982472L}, {-43.680882440907L, 46.321208823741L}, 47.280196687234L},
    {6, {-13.230302625529L, 12.911284138189L}, {-34.676014005976L, 33.842552580278L}, 37.105015972938L},
    {7, {-13.355043986161L, 11.056637381108L}, {-31.794203885583L, 29.130112288619L}, 33.879260376662L},
    {8, {-12.174287393694L, 9.963635485412L}, {-28.817244479005L, 26.392901081467L}, 30.740303615656L},
    {9, {-12.700747159276L, 9.378620256319L}, {-28.374200553733L, 24.955882149488L}, 30.231516199604L},
    {10, {5.022958128562L, 8.338362941321L}, {-8.913919776365L, 22.268821734257L}, 10.602583159486L},
    {11, {-17.263003270551L, 8.910573150870L}, {-32.153276530551L, 23.830390992556L}, 33.976707025201L},
    {12, {-12.292779606008L, 8.458864148875L}, {-26.422958270889L, 22.704688074583L}, 28.199102092812L},
    {13, {-12.224825779915L, 8.299193566155L}, {-26.084381590333L, 22.316398958537L}, 27.850348350273L},
    {14, {-12.209234192536L, 8.175606229969L}, {-25.858675961252L, 22.016397439312L}, 27.617688526463L},
    {15, {-12.094496313572L, 8.077024618376L}, {-25.575964363866L, 21.777181231740L}, 27.329856546247L},
    {16, {-12.029802240497L, 7.997916932994L}, {-25.376186803470L, 21.585492973996L}, 27.126404288491L},
    {17, {-12.026407621213L, 7.933804804132L}, {-25.263106947976L, 21.430320670515L}, 27.010649820557L},
    {18, {-12.061805935256L, 7.880703539324L}, {-25.207522543383L, 21.301856007161L}, 26.953020114678L},
    {19, {-12.048228461114L, 7.835922444009L}, {-25.117137192173L, 21.193547862817L}, 26.861009394433L},
    {20, {-12.015518450501L, 7.797950394347L}, {-25.019232298831L, 21.101757124063L}, 26.761819756202L},
    {22, {-11.950048899706L, 7.737572668632L}, {-24.849964292484L, 20.955911335397L}, 26.590703819533L},
    {24, {-11.911499288630L, 7.692135116299L}, {-24.733189098635L, 20.846216793194L}, 26.472687124940L},
    {26, {-11.888884036610L, 7.657021479491L}, {-24.650057127750L, 20.761471624122L}, 26.388677654882L},
    {28, {-11.876080603883L, 7.629290411932L}, {-24.589421273109L, 20.694552920208L}, 26.327395394267L},
    {30, {-11.869252905744L, 7.606989514687L}, {-24.544102899907L, 20.640739921480L}, 26.281584751850L},
    {32, {-11.866171351735L, 7.588776912641L}, {-24.509571080423L, 20.596791049016L}, 26.246667607876L},
    {34, {-11.865424610272L, 7.573704412073L}, {-24.482786003465L, 20.560417350747L}, 26.219574043869L},
    {36, {-11.866121313006L, 7.561085498057L}, {-24.461675882131L, 20.529962308544L}, 26.198212286283L},
    {38, {-11.867692072289L, 7.550412645819L}, {-24.444797846675L, 20.504201640596L}, 26.181125742516L},
    {40, {-11.842994229202L, 7.541700027511L}, {-24.405016406251L, 20.483275376959L}, 26.141248011603L},
    {45, {-11.844276473927L, 7.524145541323L}, {-24.375931948137L, 20.440924066982L}, 26.111854242684L},
    {50, {-11.846840438964L, 7.511598331356L}, {-24.356783511590L, 20.410648675676L}, 26.092490896698L},
    {55, {-11.849590997263L, 7.502317368255L}, {-24.343469849062L, 20.388251611639L}, 26.079021218178L},
    {60, {-12.560922524405L, 7.497362752921L}, {-25.046275117787L, 20.374702181027L}, 26.780928088915L},
    {65, {-12.537132216410L, 7.491597439392L}, {-25.012512011119L, 20.360804527345L}, 26.747069086288L},
    {70, {-12.518156695186L, 7.487032217075L}, {-24.985638220330L, 20.349801742702L}, 26.720121796987L},
    {75, {-12.503104875216L, 7.483355497084L}, {-24.964224490044L, 20.340940813053L}, 26.698649990529L},
    {80, {-12.490343354306L, 7.480351243652L}, {-24.946263929702L, 20.333702559305L}, 26.680643713275L},
    {85, {-12.480252417465L, 7.477862612617L}, {-24.931866035562L, 20.327705627565L}, 26.666207733639L},
    {90, {-12.471805935460L, 7.475779707082L}, {-24.919814461946L, 20.322686786239L}, 26.654124804380L},
    {95, {-12.464548071234L, 7.474018362060L}, {-24.909507838512L, 20.318443309541L}, 26.643792172406L},
    {100, {-12.458238111615L, 7.472515523852L}, {-24.900596407979L, 20.314823122029L}, 26.634858965398L},
    {110, {-12.447355183479L, 7.470106147993L}, {-24.885542187176L, 20.309021938739L}, 26.619771763880L},
    {120, {-12.440822330254L, 7.468270138643L}, {-24.875831065412L, 20.304596168513L}, 26.610032680045L},
    {130, {-12.434966036199L, 7.466845008523L}, {-24.867507340587L, 20.301163458432L}, 26.601688956834L},
    {140, {-12.430505198895L, 7.465756799346L}, {-24.861160565365L, 20.298547013596L}, 26.595331119850L},
    {150, {-12.426515539449L, 7.464802044449L}, {-24.855519547396L, 20.296242824325L}, 26.589672796137L},
};

/// p_(k+1) = (x - alpha_k) p_k - beta_k p_(k-1), orthogonal with respect to w^2 / sqrt(1 - x^2): sums over
/// Chebyshev nodes are exact for the degrees that occur (W. Gautschi, Orthogonal Polynomials, Oxford
/// 2004, 2.2).
struct Orthogonal {
  std::array<Coefficient, 2> center{}, aside{};  // zeros of w are center +- i aside
  std::size_t pairs;
  std::vector<Coefficient> alpha, beta;

  explicit Orthogonal(const Zeros& of) : pairs(of.second.aside > 0 ? 2 : 1) {
    const Coefficient square = Coefficient(of.stages * of.stages);
    center = {1 - of.first.below / square, 1 - of.second.below / square};
    aside = {of.first.aside / square, of.second.aside / square};
    const std::size_t degree = of.stages - 2 * pairs, nodes = of.stages + 6;
    std::vector<Coefficient> x(nodes), weight(nodes), now(nodes, 1), before(nodes, 0);
    for (std::size_t i = 0; i < nodes; ++i) {
      x[i] = std::cos(std::numbers::pi_v<Coefficient> * (Coefficient(i) + 0.5L) / Coefficient(nodes));
      const Coefficient w = taylor_of_w(x[i])[0];
      weight[i] = w * w;
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

  /// w(x + e) as a polynomial in e.
  std::array<Coefficient, 5> taylor_of_w(Coefficient x) const {
    std::array<Coefficient, 5> w{1};
    for (std::size_t pair = 0; pair < pairs; ++pair) {
      const Coefficient shifted = x - center[pair];
      const std::array<Coefficient, 3> factor{shifted * shifted + aside[pair] * aside[pair], 2 * shifted, 1};
      std::array<Coefficient, 5> product{};
      for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t j = 0; j < 3 && i + j < 5; ++j) product[i + j] += w[i] * factor[j];
      w = product;
    }
    return w;
  }
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
  const auto w = family.taylor_of_w(x);
  return {w[0] * p.value, w[1] * p.value + w[0] * p.first,
          2 * w[2] * p.value + 2 * w[1] * p.first + w[0] * p.second};
}

/// The image of z = 0 in ROCK2: R = 1 + z + z^2/2 + ... there means r r'' = r'^2, and the last such point is
/// right of 1.
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

RockPolynomial make(const Zeros& of) {
  const Orthogonal family(of);
  const bool fourth_order = family.pairs == 2;
  const Coefficient a =
      fourth_order ? 1 + of.origin / Coefficient(of.stages * of.stages) : origin_of(family, of.stages);
  const Jet r = product(family, a);
  const Coefficient scale = r.first / r.value;  // z = scale (x - a)
  RockPolynomial out;
  out.stages = of.stages;
  out.real_interval = scale * (a + 1);
  const auto w = family.taylor_of_w(a);
  Coefficient power = w[0];
  for (std::size_t k = 0; k < 5; ++k, power *= scale) out.last[k] = w[k] / power;
  out.recurrence.resize(family.alpha.size() + 1);
  Coefficient before = 0, now = 1;  // p_(j-2)(a), p_(j-1)(a)
  for (std::size_t j = 1; j < out.recurrence.size(); ++j) {
    const Coefficient shifted = a - family.alpha[j - 1];
    const Coefficient next = shifted * now - family.beta[j - 1] * before;
    out.recurrence[j] = {shifted * now / next, -family.beta[j - 1] * before / next, now / (next * scale), 0,
                         0};
    before = now, now = next;
  }
  if (fourth_order) {
    out.finish = last_stages_of_order_four(elementary_weights(out.recurrence));
    // w once more, now as these stages have it: the last digits of the zeros do not matter
    const auto& f = out.finish;
    std::array<Coefficient, 4> tall{1, 1, 1, 1};
    out.last = {1};
    for (std::size_t k = 1; k < 5; ++k) {
      std::array<Coefficient, 4> next{};
      for (std::size_t i = 0; i < 4; ++i) {
        out.last[k] += f.b[i] * tall[i];
        for (std::size_t j = 0; j < i; ++j) next[i] += f.a[i][j] * tall[j];
      }
      tall = next;
    }
  }
  return out;
}

}  // namespace

const std::vector<RockPolynomial>& rock_polynomials(StabilisedFamily family) {
  const auto all = [](const auto& zeros) {
    std::vector<RockPolynomial> made;
    for (const auto& of : zeros) made.push_back(make(of));
    return made;
  };
  if (family == StabilisedFamily::rock4) {
    static const std::vector<RockPolynomial> rock4 = all(rock4_zeros);
    return rock4;
  }
  static const std::vector<RockPolynomial> rock2 = all(rock2_zeros);
  return rock2;
}

const RockPolynomial& rock_polynomial(StabilisedFamily family, std::size_t stages) {
  for (const auto& polynomial : rock_polynomials(family))
    if (polynomial.stages == stages) return polynomial;
  return rock_polynomials(family).back();
}

}  // namespace odemark
