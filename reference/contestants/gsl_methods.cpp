// The list of GSL's steppers: what each computes, what it needs, what its rows must say.
#include "reference/contestants/gsl_methods.hpp"

#include <gsl/gsl_version.h>

#include "reference/contestants/gsl_run.hpp"
#include "reference/contestants/stability_probe.hpp"

namespace odemark::contestant {
namespace {

// GSL's error test: the worst component, up to 1.1 tolerances; ours is the root mean square, up to 1.
#define ODEMARK_GSL_TEST \
  "Error test: worst component at most 1.1 tolerances, NaN passes it (the run then ends as not_finite). "
#define ODEMARK_GSL_DOUBLING \
  "Estimates its error by step doubling and returns the two half steps: a step h is two steps of h/2. "
#define ODEMARK_GSL_NEWTON "LU decompositions and Newton iterations are not reported by GSL. "

constexpr std::string_view manual =
    "M. Galassi et al., GNU Scientific Library Reference Manual, 3rd ed. (Network Theory, 2009), ch. 27";
constexpr unsigned with_jacobian = Ability::jacobian | Ability::moderate_size;

constexpr GslRow rk2{{"gsl_rk2", "explicit Runge-Kutta", manual, 3, 2, 0, true, true, false,
                      "Steps with the third-order member of its (2, 3) pair: order 3, where GSL's "
                      "step_order() says 2. " ODEMARK_GSL_TEST},
                     &gsl_odeiv2_step_rk2};
constexpr GslRow rk4{{"gsl_rk4", "explicit Runge-Kutta", "W. Kutta, Z. Math. Phys. 46 (1901) 435-453", 4, 4,
                      0, true, true, false, ODEMARK_GSL_DOUBLING ODEMARK_GSL_TEST},
                     &gsl_odeiv2_step_rk4};
constexpr GslRow rkf45{
    {"gsl_rkf45", "explicit Runge-Kutta", "E. Fehlberg, NASA TR R-315 (1969)", 5, 4, 0, true, true, false,
     "Steps with the fifth-order member of the pair. " ODEMARK_GSL_TEST},
    &gsl_odeiv2_step_rkf45};
constexpr GslRow rkck{
    {"gsl_rkck", "explicit Runge-Kutta", "J. R. Cash, A. H. Karp, ACM Trans. Math. Softw. 16 (1990) 201-222",
     5, 4, 0, true, true, false, ODEMARK_GSL_TEST},
    &gsl_odeiv2_step_rkck};
constexpr GslRow rk8pd{{"gsl_rk8pd", "explicit Runge-Kutta",
                        "P. J. Prince, J. R. Dormand, J. Comput. Appl. Math. 7 (1981) 67-75", 8, 7, 0, true,
                        true, false, ODEMARK_GSL_TEST},
                       &gsl_odeiv2_step_rk8pd};
constexpr GslRow rk1imp{{"gsl_rk1imp", "implicit Runge-Kutta", manual, 1, 1, with_jacobian, true, true, false,
                         "Implicit Euler. " ODEMARK_GSL_DOUBLING ODEMARK_GSL_TEST ODEMARK_GSL_NEWTON},
                        &gsl_odeiv2_step_rk1imp};
constexpr GslRow rk2imp{{"gsl_rk2imp", "implicit Runge-Kutta", manual, 2, 2, with_jacobian, true, true, false,
                         "Implicit midpoint rule. " ODEMARK_GSL_DOUBLING ODEMARK_GSL_TEST ODEMARK_GSL_NEWTON},
                        &gsl_odeiv2_step_rk2imp};
constexpr GslRow rk4imp{{"gsl_rk4imp", "implicit Runge-Kutta", manual, 4, 4, with_jacobian, true, true, false,
                         "Gauss with two stages. " ODEMARK_GSL_DOUBLING ODEMARK_GSL_TEST ODEMARK_GSL_NEWTON},
                        &gsl_odeiv2_step_rk4imp};
constexpr GslRow bsimp{
    {"gsl_bsimp", "semi-implicit extrapolation", "G. Bader, P. Deuflhard, Numer. Math. 41 (1983) 373-398", 12,
     0, with_jacobian, false, true, false,
     "Always extrapolates seven levels, whatever the tolerance and the size: 142 evaluations per step, two "
     "of them "
     "the central difference for df/dt. The order is GSL's own number. " ODEMARK_GSL_TEST},
    &gsl_odeiv2_step_bsimp,
    true};
constexpr GslRow msadams{
    {"gsl_msadams", "multistep",
     "P. N. Brown, G. D. Byrne, A. C. Hindmarsh, SIAM J. Sci. Stat. Comput. 10 (1989) 1038-1051", 12, 0, 0,
     false, true, true, "Adams-Moulton of orders 1 to 12, functional iteration. " ODEMARK_GSL_TEST},
    &gsl_odeiv2_step_msadams};
constexpr GslRow msbdf{
    {"gsl_msbdf", "multistep",
     "P. N. Brown, G. D. Byrne, A. C. Hindmarsh, SIAM J. Sci. Stat. Comput. 10 (1989) 1038-1051", 5, 0,
     with_jacobian, false, true, true, "BDF of orders 1 to 5. " ODEMARK_GSL_TEST ODEMARK_GSL_NEWTON},
    &gsl_odeiv2_step_msbdf};

template <const GslRow& row>
RunReport run(const Job& job) {
  return run_gsl(row, job);
}

template <const GslRow& row>
AnyMethod method(std::function<Theory()> theory) {
  return make_contestant<run<row>>("gsl", row, row.multistep, std::move(theory));
}

/// Two half steps: R(z) = (p(z/2) / q(z/2))^2.
Theory doubled(Polynomial p, Polynomial q) {
  for (Polynomial* polynomial : {&p, &q}) {
    Coefficient scale = 1;
    for (auto& coefficient : *polynomial) coefficient *= scale, scale /= 2;
  }
  Theory theory;
  theory.numerator = power(p, 2), theory.denominator = power(q, 2);
  return theory;
}

}  // namespace

void add_gsl(std::vector<AnyMethod>& methods) {
  const auto variable_order = [] {
    return no_theory("varies its order and step: no single stability function");
  };
  methods.push_back(method<rk2>([] { return probed_theory<run<rk2>>(3); }));
  methods.push_back(method<rk4>([] { return probed_theory<run<rk4>>(8); }));
  methods.push_back(method<rkf45>([] { return probed_theory<run<rkf45>>(6); }));
  methods.push_back(method<rkck>([] { return probed_theory<run<rkck>>(6); }));
  methods.push_back(method<rk8pd>([] { return probed_theory<run<rk8pd>>(13); }));
  methods.push_back(method<rk1imp>([] { return doubled({1}, {1, -1}); }));
  methods.push_back(method<rk2imp>([] { return doubled({1, 0.5L}, {1, -0.5L}); }));
  methods.push_back(method<rk4imp>([] { return doubled({1, 0.5L, 1 / 12.0L}, {1, -0.5L, 1 / 12.0L}); }));
  methods.push_back(
      method<bsimp>([] { return no_theory("extrapolated over seven levels: no formula is written down"); }));
  methods.push_back(method<msadams>(variable_order));
  methods.push_back(method<msbdf>(variable_order));
}

ProviderInfo gsl_provider() { return {"gsl", gsl_version, "as installed; its optimisation is not measured"}; }

}  // namespace odemark::contestant
