// Stability limits measured on the compiled steppers, and that the gate bites when they or the theory are
// wrong.
#include "bench/stability.hpp"

#include <algorithm>
#include <cmath>

#include "integrators/erase_method.hpp"
#include "integrators/methods/heun.hpp"
#include "integrators/methods/rk4.hpp"
#include "integrators/methods/stormer_verlet.hpp"
#include "tests/stability_cases.hpp"

namespace odemark::stability_test {
namespace {

// --- measured ---

TEST(StabilityMeasured, OscillatorVerdictsAndLimits) {
  const auto p = problem("oscillator");
  struct Case {
    const char *id, *verdict;
    double limit;
  };
  for (const Case& c :
       {Case{"explicit_euler", "unstable", 0}, Case{"heun", "unstable", 0},
        Case{"adams_bashforth2", "unstable", 0}, Case{"taylor10", "unstable", 0},
        Case{"rk4", "limit", 2 * std::sqrt(2.0)}, Case{"semi_implicit_euler", "limit", 2},
        Case{"stormer_verlet", "limit", 2}, Case{"yoshida4", "limit", 1.57340194743},
        Case{"position_verlet", "limit", 2}, Case{"verlet_position_form", "limit", 2},
        Case{"rkn5", "unstable", 0}, Case{"average_vector_field", "unlimited", 0},
        Case{"bogacki_shampine32", "limit", std::sqrt(3.0)},
        Case{"adams_bashforth3", "limit", 12 / (5 * std::sqrt(11.0))}, Case{"implicit_euler", "unlimited", 0},
        Case{"implicit_trapezoid", "unlimited", 0}, Case{"implicit_midpoint", "unlimited", 0},
        Case{"sdirk2", "unlimited", 0}, Case{"exponential_euler", "unlimited", 0}}) {
    const auto row = measure_stability(method(c.id), p);
    EXPECT_EQ(row.verdict, c.verdict) << c.id << " " << row.reason;
    EXPECT_EQ(row.theory_verdict, c.verdict) << c.id;
    if (row.verdict == "limit") {
      EXPECT_NEAR(row.measured.value_or(-1), c.limit, 2e-9) << c.id;
    } else if (row.verdict == "unlimited") {
      EXPECT_GE(row.scanned_to, 1e6) << c.id;
    }
    EXPECT_EQ(stability_faults({row}), std::vector<std::string>());
  }
  const double h = p.suggested_dt;
  EXPECT_NEAR(measure_stability(method("heun"), p).growth_per_second.value_or(0),
              std::log1p(h * h * h * h / 4) / 2 / h, 1e-12);
  EXPECT_NEAR(measure_stability(method("explicit_euler"), p).growth_per_second.value_or(0),
              std::log1p(h * h) / 2 / h, 1e-12);
  const auto chapter = measure_stability(method("chapter_adaptive_euler"), p);
  EXPECT_EQ(chapter.verdict, "blank");
  EXPECT_FALSE(chapter.reason.empty());
  EXPECT_EQ(measure_stability(method("rk4"), problem("pendulum")).verdict, "blank");
  EXPECT_EQ(measure_stability(method("stormer_verlet"), problem("dahlquist")).verdict, "blank");
  EXPECT_EQ(measure_stability(method("rk4"), problem("dahlquist", "lambda_re=1")).reason,
            "the problem itself grows");
}

TEST(StabilityMeasured, EverySuiteMethodAgreesWithItsTheory) {
  StabilityOptions options;
  options.jobs = 2;
  std::size_t calls = 0;
  options.progress = [&](std::size_t done, std::size_t, const StabilityRow&) { EXPECT_EQ(done, ++calls); };
  const std::vector<AnyProblem> problems{problem("oscillator"),
                                         damped(0.1),
                                         damped(0.5),
                                         damped(2),
                                         problem("stiff_spring_k1e8"),
                                         problem("stiff_spring_critical"),
                                         problem("drag_ship")};
  std::vector<AnyMethod> methods;
  for (const auto& m : suite_methods())
    if (m.id.substr(0, 6) != "taylor" || m.id == "taylor5" || m.id == "taylor10" || m.id == "taylor20")
      methods.push_back(m);
  const auto rows = measure_stability(methods, problems, options);
  EXPECT_EQ(rows.size(), calls);
  for (const auto& fault : stability_faults(rows)) ADD_FAILURE() << fault;
  std::size_t compared = 0, cannot_run = 0;
  for (const auto& row : rows) {
    compared += row.verdict != "blank" && !row.theory_verdict.empty();
    cannot_run += row.reason == "the method needs what the problem does not offer";
  }
  const auto count_of = [&](auto&& which) {
    return static_cast<std::size_t>(std::count_if(methods.begin(), methods.end(), which));
  };
  const auto needing = [&](Ability ability) {
    return count_of([&](const AnyMethod& m) { return (m.needs & ability) != 0; });
  };
  // what has no single limit: what chooses its own steps, what chooses its stages by the problem and so is no
  // fixed matrix, and what turns a body
  const auto has_no_limit = [](const AnyMethod& m) {
    return !m.takes_fixed_steps || !m.runs<double>().transition || (m.needs & Ability::rotation) != 0;
  };
  for (const auto& m : methods)
    EXPECT_EQ(!m.theory().blank_reason.empty(), has_no_limit(m)) << m.id << ": " << m.theory().blank_reason;
  EXPECT_GE(compared + cannot_run, rows.size() - count_of(has_no_limit) * problems.size());
  // forces without velocity: the oscillator alone among these; a body that turns: none
  EXPECT_LE(cannot_run, 6 * needing(Ability::separable) + 7 * needing(Ability::rotation));
}

TEST(StabilityMeasured, FloatAgreesToo) {
  for (const auto* id : {"rk4", "heun", "semi_implicit_euler", "adams_bashforth3", "implicit_trapezoid"})
    for (const auto& p : {problem("oscillator"), damped(0.1)}) {
      const auto row = measure_stability(method(id), p, "float");
      EXPECT_EQ(row.scalar, "float");
      EXPECT_EQ(row.verdict, row.theory_verdict) << id << " on " << p.id;
      EXPECT_EQ(stability_faults({row}), std::vector<std::string>());
    }
}

// --- the gate ---

inline constexpr ExplicitRungeKutta<4> misprinted_rk4{
    .id = "misprinted_rk4",
    .source = "a slip in the weights that keeps order 1 and the theory of rk4",
    .order = 4,
    .a = rk4.a,
    .b = {1.0L / 6, 1.0L / 3 + 0.001L, 1.0L / 3 - 0.001L, 1.0L / 6},
};
inline constexpr Splitting<2> biased_verlet{
    .id = "biased_verlet",
    .source = "a second kick that is a little too strong",
    .order = 2,
    .drift = {0, 1},
    .kick = {0.5L, 0.5L + 1e-8L},
};

TEST(StabilityGate, BitesOnPlantedFaults) {
  const auto faults = [](const AnyMethod& m, const AnyProblem& p) {
    return stability_faults({measure_stability(m, p)}).size();
  };
  AnyMethod slip = erase_method<misprinted_rk4>();
  EXPECT_EQ(faults(slip, damped(0.1)), 0u);  // its own coefficients: consistent with itself
  slip.theory = [] { return rk4.theory(); };
  EXPECT_GE(faults(slip, damped(0.1)), 1u);
  EXPECT_GE(faults(slip, problem("oscillator")), 1u);
  EXPECT_GE(faults(slip, problem("drag_ship")), 1u);
  AnyMethod biased = erase_method<biased_verlet>();
  biased.theory = [] { return stormer_verlet.theory(); };
  EXPECT_GE(faults(biased, problem("oscillator")), 1u);
  AnyMethod damped_exactly = method("semi_implicit_euler_exact_damping");
  EXPECT_EQ(faults(damped_exactly, damped(0.5)), 0u);
  damped_exactly.theory = method("engine_drag_rule").theory;
  EXPECT_GE(faults(damped_exactly, damped(0.1)), 1u);
  AnyMethod claims = erase_method<heun>();  // "improved Euler is stable on the oscillator"
  claims.theory = [] { return rk4.theory(); };
  EXPECT_GE(faults(claims, problem("oscillator")), 1u);
  auto row = measure_stability(method("heun"), problem("oscillator"));
  row.theory_verdict = "limit", row.theory = row.resolution;
  EXPECT_EQ(stability_faults({row}).size(), 1u);
  row = measure_stability(method("rk4"), problem("oscillator"));
  row.measured = *row.measured * (1 + 1e-7);
  EXPECT_EQ(stability_faults({row}).size(), 1u);
  row = measure_stability(method("stormer_verlet"), damped(0.5));
  row.later_bands.clear();
  EXPECT_EQ(stability_faults({row}).size(), 1u);
  row = measure_stability(method("explicit_euler"), problem("oscillator"));
  row.growth_per_second = *row.growth_per_second * 1.001;
  EXPECT_EQ(stability_faults({row}).size(), 1u);
}

TEST(StabilityGate, AnUnsolvedStageIsAFault) {
  AnyMethod stuck = method("implicit_euler");
  std::get<MethodRuns<double>>(stuck.by_type).transition = [](const ErasedSystem<double>& system, double h) {
    TransitionMatrix<double> out;
    out.size = system.size, out.solved = h < 100;
    out.columns.assign(system.size * system.size, 0.0);
    return out;
  };
  const auto row = measure_stability(stuck, problem("oscillator"));
  EXPECT_EQ(row.verdict, "blank");
  EXPECT_EQ(stability_faults({row}).size(), 1u);
}

// --- one dt ---

TEST(StabilityCheck, WillItExplodeAtMyDt) {
  const auto suspension = problem("damped_spring", "k=6e5,m=168,zeta=0.1");
  const auto frame = check_dt(method("semi_implicit_euler"), suspension, 1.0 / 30);
  EXPECT_EQ(frame.verdict, "unstable");
  EXPECT_NEAR(frame.limit.value_or(0), 0.0303, 1e-4);
  EXPECT_NEAR(frame.margin.value_or(0), 0.0303 * 30, 3e-3);
  EXPECT_GT(frame.growth_per_second, 0);
  EXPECT_EQ(frame.substeps, 2);
  const auto fine = check_dt(method("semi_implicit_euler"), suspension, 1.0 / 60);
  EXPECT_EQ(fine.verdict, "stable");
  EXPECT_EQ(fine.substeps, 1);
  EXPECT_LT(fine.growth_per_second, 0);
  EXPECT_EQ(check_dt(method("explicit_euler"), suspension, 1.0 / 60).substeps, 5);  // 3.35 ms
  const auto never = check_dt(method("heun"), problem("oscillator"), 1e-4);
  EXPECT_EQ(never.verdict, "unstable");
  EXPECT_FALSE(never.substeps);
  EXPECT_TRUE(check_dt(method("implicit_euler"), suspension, 10).unlimited);
  EXPECT_EQ(check_dt(method("rk4"), problem("pendulum"), 0.1).verdict, "blank");
  EXPECT_THROW(check_dt(method("rk4"), suspension, 0), std::invalid_argument);
}

TEST(StabilityCheck, VDriftsRankingMeasured) {
  const auto ranking = [](const std::string& zeta) {
    std::vector<std::pair<double, std::string>> by_limit;
    for (const auto& [id, evaluations] :
         {std::pair{"explicit_euler", 1}, {"semi_implicit_euler", 1}, {"heun", 2}, {"rk4", 4}})
      by_limit.emplace_back(
          -measure_stability(method(id), problem("damped_spring", "k=6e5,m=168,zeta=" + zeta))
                  .measured.value() /
              evaluations,
          id);
    std::sort(by_limit.begin(), by_limit.end());
    std::vector<std::string> ids;
    for (const auto& entry : by_limit) ids.push_back(entry.second);
    return ids;
  };
  using Ids = std::vector<std::string>;
  EXPECT_EQ(ranking("0.1"), (Ids{"semi_implicit_euler", "rk4", "heun", "explicit_euler"}));
  EXPECT_EQ(ranking("1"), (Ids{"explicit_euler", "heun", "semi_implicit_euler", "rk4"}));
  EXPECT_EQ(ranking("2"), (Ids{"explicit_euler", "semi_implicit_euler", "heun", "rk4"}));
}

}  // namespace
}  // namespace odemark::stability_test
