// Every demand bites on a planted fault and is quiet on good rows; NaN and absent values never pass.
#include "reports/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "check_rows.hpp"

namespace odemark::check_test {
namespace {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Planted {
  const char *rules, *case_name, *metric;
  std::function<void(std::vector<Row>&)> fault;
  const char* message;
};

Row& kepler_rk4(std::vector<Row>& rows, long steps) { return run_of(rows, "kepler", "rk4", steps); }

const std::vector<Planted>& planted() {
  static const std::vector<Planted> all{
      {"[[rule]]\ncase = \"*/*\"\norder = \"claimed\"", "kepler/rk4", "order",
       [](auto& rows) {
         for (Row& row : rows)
           if (row.method == "rk4" && row.problem == "kepler")
             row.errors->scaled = 1e-2 * std::pow(*row.dt, 3);
       },
       "order 3.00 < 3.70"},
      {"[[rule]]\ncase = \"kepler/rk4\"\norder = { min = 3.8, max = 4.2 }", "kepler/rk4", "order",
       [](auto& rows) {
         for (Row& row : rows) row.errors->scaled = 1e-2 * std::pow(row.dt.value_or(1), 5);
       },
       "order 5.00 > 4.20"},
      {"[[rule]]\ncase = \"kepler/*\"\norder = \"claimed\"", "kepler/heun", "order",
       [](auto& rows) {
         for (Row& row : rows) row.errors->scaled = nan;
       },
       "inconclusive"},
      {"[[rule]]\ncase = \"kepler/rk4\"\nerror = { at_dt = 0.0195, max = 2e-8 }", "kepler/rk4", "error",
       [](auto& rows) { kepler_rk4(rows, 512).errors->scaled = 3e-8; },
       "scaled error 3.00e-08 > 2e-08 at dt"},
      {"[[rule]]\ncase = \"kepler/rk4\"\nerror = { at_steps = 512, max = 2e-8 }", "kepler/rk4", "error",
       [](auto& rows) { kepler_rk4(rows, 512).errors->scaled = nan; }, "not a number"},
      {"[[rule]]\ncase = \"kepler/rk4\"\nerror = { at = \"finest\", max = 2e-8, norm = \"relative\" }",
       "kepler/rk4", "error", [](auto& rows) { kepler_rk4(rows, 1024).errors->relative.reset(); }, "absent"},
      {"[[rule]]\ncase = \"kepler/*\"\nerror = { at_tol = 1e-6, max = 1e-6, norm = \"trajectory_max\" }",
       "kepler/dormand_prince54", "error", [](auto& rows) { rows.back().errors->trajectory_max = 1e-5; },
       "trajectory_max error 1.00e-05 > 1e-06 at rtol 1e-06"},
      {"[[rule]]\ncase = \"kepler/rk4\"\nerror = { at_steps = 64, max = 1e-3 }", "kepler/rk4", "error",
       [](auto& rows) { kepler_rk4(rows, 64).status = "not_finite", kepler_rk4(rows, 64).errors.reset(); },
       "no error at dt 0.1562: not_finite"},
      {"[[rule]]\ncase = \"*/rk4\"\ndrift = { invariant = \"energy\", max = 1e-4, up_to_dt = 0.2 }",
       "kepler/rk4", "drift", [](auto& rows) { kepler_rk4(rows, 256).drift["energy"] = 1e-3; },
       "energy drifts by 1.00e-03 > 0.0001"},
      {"[[rule]]\ncase = \"*/rk4\"\ndrift = { invariant = \"energy\", max = 0.1 }", "kepler/rk4", "drift",
       [](auto& rows) { kepler_rk4(rows, 256).drift["energy"] = nan; }, "drifts by"},
      {"[[rule]]\ncase = \"*/rk4\"\ndrift = { invariant = \"energy\", max = 0.1 }", "kepler/rk4", "drift",
       [](auto& rows) { kepler_rk4(rows, 256).drift.clear(); }, "no invariant"},
      {"[[rule]]\ncase = \"kepler/*\"\nstatus = \"reached_end\"", "kepler/heun", "status",
       [](auto& rows) { run_of(rows, "kepler", "heun", 16).status = "step_limit"; },
       "step_limit at dt 0.625, not reached_end"},
      {"[defaults]\nrequire_status = { is = \"reached_end\", at = \"finest\" }", "kepler/heun", "status",
       [](auto& rows) { run_of(rows, "kepler", "heun", 1024).status = "step_underflow"; }, "step_underflow"},
  };
  return all;
}

TEST(check, every_demand_is_quiet_on_good_rows) {
  for (const Planted& p : planted()) {
    const auto result = gate(good_rows(), p.rules);
    EXPECT_EQ(exit_code(result), 0) << to_console(result);
    EXPECT_GT(result.compared, 0) << p.rules;
  }
}

TEST(check, every_demand_bites) {
  for (const Planted& p : planted()) {
    auto rows = good_rows();
    p.fault(rows);
    const auto result = gate(rows, p.rules);
    EXPECT_EQ(exit_code(result), 1) << p.rules << '\n' << to_console(result);
    const Finding finding = finding_of(result, p.case_name, p.metric);
    EXPECT_EQ(finding.outcome, Outcome::fail) << to_console(result);
    EXPECT_THAT(finding.message, HasSubstr(p.message));
    EXPECT_GT(finding.line, 1);
  }
}

TEST(check, demands_that_something_fails) {
  auto rows = good_rows();
  const std::string rules =
      "[[rule]]\ncase = \"kepler/heun\"\nstatus = { is = [\"not_finite\", \"step_limit\"], from_dt = 0.6 }";
  EXPECT_EQ(exit_code(gate(rows, rules)), 1) << "it must fail, but reaches the end";
  run_of(rows, "kepler", "heun", 16).status = "not_finite";
  EXPECT_EQ(exit_code(gate(rows, rules)), 0);
}

TEST(check, stability_bites) {
  const std::string rules =
      "[[rule]]\ncase = \"oscillator/*\"\nstability = { rel = 1e-6 }\n"
      "[[rule]]\ncase = \"oscillator/heun\"\nstability_verdict = \"unstable\"";
  const std::vector<StabilityRow> good{good_limit("rk4", "limit", 2.8284271247461903),
                                       good_limit("heun", "unstable", 0),
                                       good_limit("implicit_euler", "unlimited", 0)};
  const auto run = [&](auto&& fault) {
    auto rows = good;
    fault(rows);
    try {
      return exit_code(gate({}, rules, rows));
    } catch (const BadThresholds&) {
      return 2;
    }
  };
  EXPECT_EQ(run([](auto&) {}), 0);
  EXPECT_EQ(run([](auto& rows) { *rows[0].measured *= 1 + 1e-5; }), 1);
  EXPECT_EQ(run([](auto& rows) { rows[0].measured = nan; }), 1);
  EXPECT_EQ(run([](auto& rows) { rows[0].measured.reset(); }), 1);
  EXPECT_EQ(run([](auto& rows) { rows[0].verdict = "unlimited"; }), 1);
  EXPECT_EQ(run([](auto& rows) { rows[0].failure = "the stage was not solved"; }), 1);
  EXPECT_EQ(run([](auto& rows) { rows[0].theory = 2, rows[0].theory_as_seen_verdict = "limit"; }), 1);
  EXPECT_EQ(run([](auto& rows) {
              rows[0].theory = 2, rows[0].theory_as_seen_verdict = "limit";
              rows[0].theory_as_seen = rows[0].measured;
            }),
            0);
  EXPECT_EQ(run([](auto& rows) { rows[1].verdict = rows[1].theory_verdict = "limit"; }), 1);
  EXPECT_EQ(run([](auto& rows) { rows[2].verdict = "unstable"; }), 1);
  EXPECT_EQ(run([](auto& rows) {
              for (auto& row : rows) row.verdict = "blank";
            }),
            2);
}

TEST(check, inconclusive_orders_pass_only_where_people_say_so) {
  auto rows = good_rows();
  for (Row& row : rows) row.errors->scaled = 1e-15;
  const std::string rules = "[[rule]]\ncase = \"*/*\"\norder = ";
  EXPECT_EQ(exit_code(gate(rows, rules + "\"claimed\"")), 1);
  const auto noted = gate(rows, rules + "{ inconclusive = \"note\" }");
  EXPECT_EQ(exit_code(noted), 0);
  EXPECT_EQ(finding_of(noted, "kepler/rk4", "order").outcome, Outcome::note);
}

TEST(check, the_last_rule_wins_per_demand) {
  auto rows = good_rows();
  for (Row& row : rows) row.errors->scaled = 1e-2 * std::pow(row.dt.value_or(1), 3);
  const std::string all = "[[rule]]\ncase = \"*/rk4\"\norder = \"claimed\"\nstatus = \"reached_end\"\n";
  EXPECT_EQ(exit_code(gate(rows, all)), 1);
  EXPECT_EQ(exit_code(gate(rows, all + "[[rule]]\ncase = \"*/rk4\"\norder = { min = 2.8 }")), 0);
  EXPECT_EQ(exit_code(gate(rows, all + "[[rule]]\ncase = \"*/rk4\"\norder = \"off\"")), 0);
  EXPECT_EQ(exit_code(gate(rows, all + "[[rule]]\ncase = \"*/rk4\"\nerror = \"off\"")), 1);
  EXPECT_EQ(exit_code(gate(rows, "[[rule]]\ncase = \"*/rk4\"\norder = { min = 2.8 }\n" + all)), 1);
}

TEST(check, skips_are_counted_and_end) {
  auto rows = good_rows();
  for (Row& row : rows)
    if (row.steps) row.errors->scaled = nan;
  const std::string rules =
      "[[rule]]\ncase = \"*/*\"\nerror = { at = \"finest\", max = 1 }\nstatus = \"reached_end\"\n"
      "[[rule]]\ncase = [\"kepler/*\", \"oscillator/rk4\"]\nskip = true\nreason = \"a close encounter\"\n"
      "until = 2030-06-30\n[[rule]]\ncase = \"kepler/dormand_prince54\"\nskip = false\n";
  const auto before = gate(rows, rules, {}, {.today = "2030-06-30"});
  EXPECT_EQ(exit_code(before), 0) << to_console(before);
  EXPECT_EQ(count(before, Outcome::skipped), 3);
  EXPECT_EQ(before.compared, 1);
  EXPECT_EQ(before.executed, 4);
  EXPECT_THAT(finding_of(before, "kepler/rk4", "skip").message, HasSubstr("encounter (until 2030-06-30)"));
  EXPECT_EQ(exit_code(gate(rows, rules, {}, {.today = "2030-07-01"})), 1);
}

TEST(check, contestants_are_gated_only_where_a_rule_says_so) {
  auto rows = good_rows();
  for (Row& row : rows)
    if (row.method == "heun") row.provider = "gsl", row.errors->scaled = nan;
  const std::string own = "[[rule]]\ncase = \"*/*\"\norder = \"claimed\"\n";
  EXPECT_EQ(exit_code(gate(rows, own)), 0);
  EXPECT_EQ(exit_code(gate(rows, own + "provider = \"*\"")), 1);
  EXPECT_THROW(gate(rows, "[[rule]]\ncase = \"kepler/heun\"\norder = \"claimed\""), BadThresholds);
}

TEST(check, number_types_are_cases_of_their_own) {
  auto rows = good_rows();
  for (Row& row : rows)
    if (row.method == "heun") row.scalar = "float", row.errors->scaled = nan;
  const std::string own = "[[rule]]\ncase = \"*/*\"\norder = \"claimed\"\n";
  EXPECT_EQ(exit_code(gate(rows, own)), 0);
  const auto result = gate(rows, own + "scalar = \"*\"");
  EXPECT_EQ(exit_code(result), 1);
  EXPECT_EQ(finding_of(result, "kepler/heun [float]", "order").method, "heun [float]");
}

TEST(check, exit_codes_tell_failed_from_incomplete) {
  const std::string rules = "[[rule]]\ncase = \"*/rk4\"\nerror = { at_steps = 64, max = 1 }";
  EXPECT_EQ(exit_code(gate(good_rows(), rules)), 0);
  EXPECT_EQ(exit_code(gate({}, rules)), 3) << "nothing was run";
  EXPECT_EQ(exit_code(gate(good_rows(), "")), 3) << "nothing was compared";
  EXPECT_EQ(exit_code(gate(good_rows(), "[[rule]]\ncase = \"*/rk4\"\nerror = { at_steps = 60, max = 1 }")),
            3);
  EXPECT_EQ(exit_code(gate(good_rows(), rules + "\n[[rule]]\ncase = \"kepler/rk4\"\n"
                                                "error = { at_steps = 60, max = 1 }")),
            3);
  EXPECT_EQ(exit_code(gate(good_rows(), rules, {}, {.only = "pendulum"})), 3);
  EXPECT_EQ(exit_code(gate(good_rows(), rules, {}, {.only = "kepler"})), 0);
  auto rows = good_rows();
  kepler_rk4(rows, 64).errors.reset(), kepler_rk4(rows, 64).reason = "no error: the solver stopped";
  EXPECT_EQ(exit_code(gate(rows, rules)), 4) << "no reference solution";
  run_of(rows, "oscillator", "rk4", 64).errors->scaled = 2;
  EXPECT_EQ(exit_code(gate(rows, rules)), 1) << "a violation is told first";
  rows = good_rows();
  kepler_rk4(rows, 64).status = "time_limit";
  EXPECT_EQ(exit_code(gate(rows, rules)), 3) << "a slow machine is no regression";
  EXPECT_THROW(gate(rows, rules, {}, {.only = "("}), std::invalid_argument);
}

TEST(check, stability_that_was_not_measured_is_missing) {
  const std::string named = "[[rule]]\ncase = \"oscillator/rk4\"\nstability_verdict = \"limit\"";
  const auto result = gate(good_rows(), named);
  EXPECT_EQ(exit_code(result), 3);
  EXPECT_THAT(finding_of(result, "oscillator/rk4", "stability_verdict").message,
              HasSubstr("no stability row"));
  const std::string by_glob =
      "[[rule]]\ncase = \"*/*\"\nstatus = \"reached_end\"\nstability = { rel = 1e-6 }";
  EXPECT_EQ(exit_code(gate(good_rows(), by_glob)), 3);
  EXPECT_EQ(exit_code(gate(good_rows(), by_glob, {good_limit("rk4", "limit", 2.8)})), 0);
}

TEST(check, cases_that_cannot_run_are_counted_apart) {
  auto rows = good_rows();
  rows.push_back(good_run("lorenz63", "yoshida4", 4, 16));
  rows.back().status = "not_applicable", rows.back().reason = "needs x'' = a(t, x, v)",
  rows.back().errors.reset();
  const auto result = gate(rows, "[[rule]]\ncase = \"*/*\"\nstatus = \"reached_end\"\norder = \"claimed\"");
  EXPECT_EQ(exit_code(result), 0) << to_console(result);
  EXPECT_EQ(result.not_applicable, 1);
  EXPECT_EQ(result.executed, 4);
  EXPECT_EQ(result.compared, 4);
}

}  // namespace
}  // namespace odemark::check_test
