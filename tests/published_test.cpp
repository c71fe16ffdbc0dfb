// End values printed by others, third witnesses of stored solutions: a wrong constant in a right-hand side or
// an initial value would show here.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/truth.hpp"
#include "reference/truth_store.hpp"
#include "tests/support/runs.hpp"

namespace odemark::published_test {
namespace {

/// What others printed for the end of a preset. `relative` is what their digits are good for; where they are
/// worse than they look, `note` says so. Components printed as 0 are compared in units of the scale.
struct Published {
  const char *preset, *source;
  std::vector<double> end;
  double relative;
  const char* note = "";
};

constexpr const char* bari =
    "F. Mazzia, C. Magherini, Test Set for Initial Value Problem Solvers, release 2.4 (2008)";
constexpr const char* detest = "W. H. Enright, J. D. Pryce, ACM Algorithm 648 (1987)";
constexpr const char* closed = "closed form, evaluated by others to 30 digits";

const std::vector<Published>& published() {
  static const std::vector<Published> table{
      {"pleiades",
       bari,
       {0.3706139143970502,  3.237284092057233,   -3.222559032418324,  0.6597091455775310,
        0.3425581707156584,  1.562172101400631,   -0.7003092922212495, -3.943437585517392,
        -3.271380973972550,  5.225081843456543,   -2.590612434977470,  1.198213693392275,
        -0.2429682344935824, 1.091449240428980,   3.417003806314313,   1.354584501625501,
        -2.590065597810775,  2.025053734714242,   -1.155815100160448,  -0.8072988170223021,
        0.5952396354208710,  -3.741244961234010,  0.3773459685750630,  0.9386858869551073,
        0.3667922227200571,  -0.3474046353808490, 2.344915448180937,   -1.947020434263292},
       2e-12},
      {"hires",
       bari,
       {0.7371312573325668e-3, 0.1442485726316185e-3, 0.5888729740967575e-4, 0.1175651343283149e-2,
        0.2386356198831331e-2, 0.6238968252742796e-2, 0.2849998395185769e-2, 0.2850001604814231e-2},
       2e-12},
      {"pollu",
       bari,
       {0.5646255480022769e-1, 0.1342484130422339,    0.4139734331099427e-8, 0.5523140207484359e-2,
        0.2018977262302196e-6, 0.1464541863493966e-6, 0.7784249118997964e-1, 0.3245075353396018,
        0.7494013383880406e-2, 0.1622293157301561e-7, 0.1135863833257075e-7, 0.2230505975721359e-2,
        0.2087162882798630e-3, 0.1396921016840158e-4, 0.8964884856898295e-2, 0.4352846369330103e-17,
        0.6899219696263405e-2, 0.1007803037365946e-3, 0.1772146513969984e-5, 0.5682943292316392e-4},
       2e-12},
      {"robertson_long", bari, {2.083340149701255e-8, 8.333360770334713e-14, 0.9999999791665050}, 2e-12},
      {"orego",
       bari,
       {0.1000814870318523e1, 0.1228178521549917e4, 0.1320554942846706e3},
       2e-12,
       "y2 and y3 are wrong from the 14th and 13th digit; E. Hairer's own table has others there"},
      {"van_der_pol_mu1000",
       bari,
       {1.706167732170469, -0.8928097010248125e-3},
       2e-12,
       "the same point is printed with three different endings after the 14th digit, none of them right"},
      {"arenstorf",
       "E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I: closed orbit",
       {0.994, 0, 0, -2.00158510637908252},
       1e-9,
       "inputs rounded to double move the end by 1e-11"},
      {"arenstorf_four_loops",
       "E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I: closed orbit",
       {0.994, 0, 0, -2.0317326295573368357},
       1e-9,
       "inputs rounded to double move the end by 1e-11"},
      {"figure_eight",
       "C. Simo: closed orbit, to the eight digits of its data",
       {0.97000436, -0.24308753, -0.97000436, 0.24308753, 0, 0, 0.466203685, 0.43236573, 0.466203685,
        0.43236573, -0.93240737, -0.86473146},
       1e-6},
      {"detest_f1", detest, {-12.94460621213470, 0}, 1e-13},
      {"detest_f2", detest, {70.03731057008607}, 1e-14},
      {"detest_f3", detest, {-3.726957553088175e-1, -6.230137949234190e-1}, 1e-12},
      {"detest_f4",
       detest,
       {9.815017249707434e-11},
       1e-13,
       "copies differ: without the power 16 of the needle's denominator, or with 2/21 = 0 in whole numbers, "
       "y(10) "
       "is not 1/21"},
      {"detest_f5", detest, {1.0}, 1e-14},
      {"kaps", "exp(-2), exp(-1)", {0.13533528323661269189, 0.36787944117144232160}, 1e-14},
      {"kaps_stiff", "exp(-2), exp(-1)", {0.13533528323661269189, 0.36787944117144232160}, 1e-14},
      {"dahlquist_detest_a1", closed, {2.061153622438557828e-9, 0}, 1e-15},
      {"detest_a2", closed, {0.2182178902359923813}, 1e-15},
      {"detest_a3", closed, {2.491650271850414524}, 1e-15},
      {"logistic_detest_a4", closed, {17.73016648131483985}, 1e-15},
      {"detest_a5", closed, {-0.7887826688964014237}, 1e-15},
      {"bessel_e1",
       closed,
       {0.1456723600728246844, -0.09883500195574578},
       1e-13,
       "the start is printed to 16 digits"},
      {"pursuit_e5", closed, {14.11797390542625468, 2.4}, 1e-15},
      {"kepler_detest_d1",
       closed,
       {0.2198835352008396613, 0.9427076846341813085, -0.9787659841058176515, 0.3287977990962036083},
       1e-12,
       "the start is rounded to double"},
      {"kepler_detest_d3",
       closed,
       {-0.5780432953035361232, 0.8633840009194192801, -0.9595083730380727356, -0.06504915126712090168},
       1e-12,
       "the start is rounded to double"},
      {"kepler_detest_d5",
       closed,
       {-1.295266250987574368, 0.4003938963792321527, -0.6775390924707565887, -0.1270838154278686188},
       1e-12,
       "the start is rounded to double"},
  };
  return table;
}

TEST(Published, StoredSolutionsMeetWhatOthersPrinted) {
  for (const auto& [preset, source, printed, relative, note] : published()) {
    SCOPED_TRACE(std::string(preset) + ", " + source + (*note ? std::string("; ") + note : ""));
    const AnyProblem problem = find_problem(suite_families(), preset);
    const auto truth = truth_of(problem);
    const auto& end = truth->last();
    ASSERT_EQ(end.values.size(), printed.size());
    for (std::size_t i = 0; i < printed.size(); ++i) {
      const double size = printed[i] == 0 ? problem.scale[i] : std::abs(printed[i]);
      EXPECT_NEAR((double(end.values[i].hi) - printed[i]) / size, 0, relative) << problem.components[i].name;
    }
  }
}

/// What is printed for settings that no preset has: a run in double meets it.
TEST(Published, RunsInDoubleMeetWhatOthersPrinted) {
  const Published rows[] = {
      {"ring_modulator_fast{t_end=1e-3}",
       bari,
       {-0.2339057358486745e-1, -0.7367485485540825e-2, 0.2582956709291169, -0.4064465721283450,
        -0.4039455665149794, 0.2607966765422943, 0.1106761861269975, 0.2939904342435596e-6,
        -0.2840029933642329e-7, 0.7267198267264553e-3, 0.7929487196960840e-3, -0.7255283495698965e-3,
        -0.7941401968526521e-3, 0.7088495416976114e-4, 0.2390059075236570e-4},
       1e-6,
       "printed to 16 digits from a run at the tolerance 1e-12"},
  };
  for (const auto& [id, source, printed, relative, note] : rows) {
    SCOPED_TRACE(std::string(id) + ", " + source + "; " + note);
    const std::string text = id, name = text.substr(0, text.find('{'));
    const AnyProblem problem =
        suite_problem(name, text.substr(name.size() + 1, text.size() - name.size() - 2));
    ErrorControl control{1e-10, 1e-10};
    control.scale = problem.scale.data();
    const auto end = solve(suite_method("radau"), problem, control);
    ASSERT_EQ(end.report.status, RunStatus::reached_end);
    for (std::size_t i = 0; i < printed.size(); ++i)
      EXPECT_NEAR((end.y[i] - printed[i]) / problem.scale[i], 0, relative) << problem.components[i].name;
  }
}

}  // namespace
}  // namespace odemark::published_test
