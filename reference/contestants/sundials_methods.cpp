// The list of ARKODE's tables that compete, and what their rows must say.
#include "reference/contestants/sundials_methods.hpp"

#include "reference/contestants/sundials_arkode.hpp"

namespace odemark::contestant {
namespace {

#define ODEMARK_ARKODE_GRID "Grid values: its Hermite interpolant. In fixed steps its clock adds up h. "
#define ODEMARK_ARKODE_NEWTON                                                                                \
  "Newton constant 1e-5 instead of 0.1 and up to 10 iterations instead of 3: Robertson's problem takes 126 " \
  "steps instead of 7291. Dense or banded Jacobian, the problem's where it has one. "

constexpr std::string_view arkode = "D. R. Reynolds et al., ACM Trans. Math. Softw. 49 (2023) 19";
constexpr std::string_view kutta = "W. Kutta, Z. Math. Phys. 46 (1901) 435-453";

constexpr ArkodeRow erk_dp54{{"arkode_erk_dormand_prince54", "explicit Runge-Kutta",
                              "J. R. Dormand, P. J. Prince, J. Comput. Appl. Math. 6 (1980) 19-26", 5, 4, 0,
                              true, true, false, ODEMARK_ARKODE_GRID},
                             ArkodeModule::erk_step,
                             [] { return ARKodeButcherTable_LoadERK(ARKODE_DORMAND_PRINCE_7_4_5); }};
constexpr ArkodeRow erk_rk4{{"arkode_erk_rk4", "explicit Runge-Kutta", kutta, 4, 0, 0, true, false, false,
                             "SUNDIALS 6.4.1 takes every table whose last node is 1 for first-same-as-last "
                             "and reuses the last stage's "
                             "slope: three evaluations per step and order 3, not 4. arkode_ark_rk4 steps "
                             "with the table as written. "},
                            ArkodeModule::erk_step,
                            classical_rk4_table};
constexpr ArkodeRow ark_rk4{{"arkode_ark_rk4", "explicit Runge-Kutta", kutta, 4, 0, 0, true, false, false,
                             "ARKStep in explicit mode. " ODEMARK_ARKODE_GRID},
                            ArkodeModule::ark_step_explicit,
                            classical_rk4_table};
constexpr ArkodeRow sdirk21{{"arkode_dirk_sdirk21", "diagonally implicit Runge-Kutta", arkode, 2, 1, 0, true,
                             true, false, ODEMARK_ARKODE_NEWTON ODEMARK_ARKODE_GRID},
                            ArkodeModule::ark_step_implicit,
                            [] { return ARKodeButcherTable_LoadDIRK(ARKODE_SDIRK_2_1_2); }};
constexpr ArkodeRow sdirk43{
    {"arkode_dirk_sdirk43", "diagonally implicit Runge-Kutta",
     "E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed. (Springer, "
     "1996), IV.6, table 6.5",
     4, 3, 0, true, true, false, ODEMARK_ARKODE_NEWTON ODEMARK_ARKODE_GRID},
    ArkodeModule::ark_step_implicit,
    [] { return ARKodeButcherTable_LoadDIRK(ARKODE_SDIRK_5_3_4); }};
constexpr ArkodeRow esdirk43{{"arkode_dirk_esdirk43", "diagonally implicit Runge-Kutta",
                              "C. A. Kennedy, M. H. Carpenter, NASA/TM-2016-219173 (2016)", 4, 3, 0, true,
                              true, false, ODEMARK_ARKODE_NEWTON ODEMARK_ARKODE_GRID},
                             ArkodeModule::ark_step_implicit,
                             [] { return ARKodeButcherTable_LoadDIRK(ARKODE_ESDIRK436L2SA_6_3_4); }};
constexpr ArkodeRow esdirk54{{"arkode_dirk_esdirk54", "diagonally implicit Runge-Kutta",
                              "C. A. Kennedy, M. H. Carpenter, NASA/TM-2016-219173 (2016)", 5, 4, 0, true,
                              true, false, ODEMARK_ARKODE_NEWTON ODEMARK_ARKODE_GRID},
                             ArkodeModule::ark_step_implicit,
                             [] { return ARKodeButcherTable_LoadDIRK(ARKODE_ESDIRK547L2SA_7_4_5); }};

template <const ArkodeRow& row>
RunReport run(const Job& job) {
  return run_arkode(row, job);
}

/// From the table the library ships, in the library's own digits.
template <std::size_t Stages>
Theory theory_of(const ArkodeRow& row) {
  const OwnedTable table(row.table());
  if (!table || std::size_t(table->stages) != Stages)
    return no_theory("its table has another size than expected");
  std::array<std::array<Coefficient, Stages>, Stages> a{};
  std::array<Coefficient, Stages> b{};
  for (std::size_t i = 0; i < Stages; ++i) {
    b[i] = Coefficient(table->b[i]);
    for (std::size_t j = 0; j < Stages; ++j) a[i][j] = Coefficient(table->A[i][j]);
  }
  return runge_kutta_theory(a, b);
}

template <const ArkodeRow& row, std::size_t Stages>
AnyMethod method() {
  return make_contestant<run<row>>("sundials", row, false, [] { return theory_of<Stages>(row); });
}

}  // namespace

void add_arkode(std::vector<AnyMethod>& methods) {
  methods.push_back(method<erk_dp54, 7>());
  // it remembers a slope that is not its table's
  methods.push_back(make_contestant<run<erk_rk4>>("sundials", erk_rk4, true, [] {
    return no_theory("reuses the last stage's slope: it does not step with its table");
  }));
  methods.push_back(method<ark_rk4, 4>());
  methods.push_back(method<sdirk21, 2>());
  methods.push_back(method<sdirk43, 5>());
  methods.push_back(method<esdirk43, 6>());
  methods.push_back(method<esdirk54, 7>());
}

}  // namespace odemark::contestant
