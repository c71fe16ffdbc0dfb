// thresholds.toml: what is wrong is told in one sentence with its line; nothing unknown passes silently.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "check_rows.hpp"
#include "reports/thresholds.hpp"

namespace odemark::check_thresholds_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string refusal(const std::string& toml) {
  try {
    parse_thresholds(toml, "t.toml");
  } catch (const BadThresholds& e) {
    return e.what();
  }
  return "accepted";
}

std::string refusal_of_rule(const std::string& demand) {
  return refusal("schema = 1\n[[rule]]\ncase = \"a/b\"\n" + demand);
}

TEST(thresholds, mistakes_name_their_line) {
  struct Mistake {
    const char *demand, *message;
  };
  const Mistake mistakes[] = {
      {"ordre = \"claimed\"", "t.toml:4: unknown key \"ordre\" in a rule"},
      {"order = \"4\"", "t.toml:4: order = \"4\" is not known: claimed, off"},
      {"order = { min = \"4\" }", "t.toml:4: min must be a finite number"},
      {"order = { min = nan }", "t.toml:4: min must be a finite number"},
      {"order = { min = 4, max = 3 }", "t.toml:4: no order is above 4 and below 3"},
      {"order = { inconclusive = \"pass\" }", "t.toml:4: inconclusive = \"pass\" is not known"},
      {"order = 4", "t.toml:4: order is written \"claimed\", \"off\" or"},
      {"error = { at_dt = 0.1 }", "t.toml:4: error needs max"},
      {"error = { max = 0.1 }", "t.toml:4: error needs at_dt"},
      {"error = { at_dt = 0.1, at_tol = 1e-3, max = 0.1 }", "t.toml:4: a demand selects its runs by one key"},
      {"error = { at_dt = -1, max = 0.1 }", "t.toml:4: at_dt must be above 0, not -1"},
      {"error = { at_dt = 0.1, max = 0.1, norm = \"l2\" }", "t.toml:4: norm = \"l2\" is not known"},
      {"error = []", "t.toml:4: an empty list demands nothing"},
      {"error = [\n{ at_dt = 0.1, max = 1 },\n{ at_dt = 0.1, maxx = 1 }]", "t.toml:6: unknown key \"maxx\""},
      {"drift = { max = 1 }", "t.toml:4: drift needs invariant"},
      {"status = \"ok\"", "t.toml:4: there is no status \"ok\": reached_end"},
      {"status = { at_dt = 1 }", "t.toml:4: status needs is"},
      {"evaluations = { max_factor = 0.5 }", "t.toml:4: max_factor is a factor of 1 or more, not 0.5"},
      {"stability = { rel = true }", "t.toml:4: rel must be a finite number"},
      {"stability_verdict = \"shaky\"", "t.toml:4: stability_verdict = \"shaky\" is not known"},
      {"optional = 1", "t.toml:4: optional must be true or false"},
      {"skip = \"yes\"", "t.toml:4: skip must be true or false"},
      {"skip = true", "t.toml:2: skip = true needs a reason"},
      {"skip = true\nreason = \"r\"\norder = \"claimed\"", "t.toml:2: a rule that skips cannot demand"},
      {"skip = true\nreason = \"r\"\nuntil = \"soon\"", "t.toml:6: until is a date without quotes"},
      {"until = 2030-01-01\norder = \"off\"", "t.toml:2: until belongs to skip"},
      {"scalar = \"double\"", "t.toml:2: the rule demands nothing"},
      {"order = \"off\"\norder = \"claimed\"", "t.toml:5: "},
      {"order = ", "t.toml:4: "},
      {"case = \"c/d\"", "t.toml:4: "},
      {"order = \"off\"\n[[rules]]\ncase = \"x/y\"", "t.toml:5: unknown key \"rules\" in the file"},
      {"order = \"off\"\n[[rule]]\norder = \"claimed\"", "t.toml:5: a rule needs case"},
      {"order = \"off\"\n[[rule]]\ncase = \"rk4\"\norder = \"off\"", "t.toml:5: case = \"rk4\" has no \"/\""},
      {"order = \"off\"\n[defaults]\nfloor = 0", "t.toml:6: floor must be above 0"},
  };
  for (const auto& [demand, message] : mistakes) {
    EXPECT_THAT(refusal_of_rule(demand), AllOf(StartsWith(message), Not(HasSubstr("\n")))) << demand;
  }
  EXPECT_THAT(refusal(""), StartsWith("t.toml:1: the file must say schema = 1"));
  EXPECT_THAT(refusal("schema = 2"), StartsWith("t.toml:1: this odemark reads schema = 1"));
  EXPECT_THAT(refusal("schema = 1\nrule = 3"), StartsWith("t.toml:2: rules are written [[rule]]"));
  EXPECT_THAT(refusal("schema = 1\n[rule]\ncase = \"a/b\""),
              StartsWith("t.toml:2: rules are written [[rule]]"));
}

TEST(thresholds, everything_that_may_be_said) {
  const auto all = parse_thresholds(R"(
schema = 1
[defaults]
baseline_factor = 2
evaluations_factor = 1.5
floor = 1e-12
order_slack = 0.2
require_status = { is = ["reached_end", "step_limit"], at = "finest" }
[[rule]]
case = ["kepler*/rk?", "x/y"]
provider = "*"
scalar = "float"
compensated = true
optional = true
order = { min = 3, max = 5, inconclusive = "note" }
error = [{ at_dt = 0.1, max = 1e-3 }, { at_tol = 1e-6, max = 1e-3, norm = "phase" }]
drift = { invariant = "energy", max = 1, from_dt = 0.5 }
status = "not_finite"
evaluations = { max_factor = 1 }
baseline_factor = 3
stability = { rel = 1e-6 }
stability_verdict = "unlimited"
)");
  EXPECT_EQ(all.defaults.baseline_factor, 2);
  EXPECT_EQ(all.defaults.require_status->expected.size(), 2u);
  EXPECT_EQ(all.defaults.require_status->runs.kind, RunSelector::Kind::finest);
  ASSERT_EQ(all.rules.size(), 1u);
  EXPECT_TRUE(all.rules[0].optional);
  const Rule& rule = all.rules[0];
  EXPECT_EQ(rule.line, 9);
  EXPECT_EQ(rule.order->line, 15);
  EXPECT_FALSE(rule.order->inconclusive_fails);
  EXPECT_EQ(rule.error->at(1).norm, "phase");
  EXPECT_EQ(rule.error->at(1).runs.kind, RunSelector::Kind::at_tol);
  EXPECT_EQ(rule.drift->at(0).runs.value, 0.5);
  EXPECT_EQ(rule.baseline->factor, 3);
  EXPECT_TRUE(all.defaults.needs_baseline);
  EXPECT_FALSE(parse_thresholds("schema = 1").defaults.needs_baseline);
}

TEST(thresholds, globs) {
  EXPECT_TRUE(matches_glob("*", ""));
  EXPECT_TRUE(matches_glob("*/*", "kepler/rk4"));
  EXPECT_TRUE(matches_glob("kepler*/rk?", "kepler_e06/rk4"));
  EXPECT_TRUE(matches_glob("*a*b*", "xxaaxxbb"));
  EXPECT_TRUE(matches_glob("kepler{e=0.3}/rk4", "kepler{e=0.3}/rk4"));
  EXPECT_FALSE(matches_glob("kepler/rk4", "kepler/rk45"));
  EXPECT_FALSE(matches_glob("kepler/rk?", "kepler/rk"));
  EXPECT_FALSE(matches_glob("", "a"));
  EXPECT_FALSE(matches_glob("*a*b", "ab_"));
  EXPECT_FALSE(matches_glob(std::string(2000, '*') + "b", std::string(2000, 'a')));
}

TEST(thresholds, names_that_were_not_run_are_refused) {
  const auto refused = [](const std::string& name, std::vector<Row> rows = good_rows()) -> std::string {
    try {
      gate(rows, "[[rule]]\ncase = \"" + name + "\"\norder = \"claimed\"");
    } catch (const BadThresholds& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refused("kepler/rk5"),
              StartsWith("thresholds.toml:2: no executed case is \"kepler/rk5\": is it "
                         "\"kepler/rk4\"?"));
  auto rows = good_rows();
  for (Row& row : rows)
    if (row.method == "heun") row.scalar = "float";
  EXPECT_THAT(refused("kepler/heun", rows), HasSubstr("it ran as kepler/heun [float]"));
  for (Row& row : rows) row.provider = "gsl";
  EXPECT_THAT(refused("kepler/rk4", rows), HasSubstr("add provider = \"gsl\""));
  for (Row& row : rows) row.status = "not_applicable", row.reason = "needs a Jacobian";
  EXPECT_THAT(refused("kepler/rk4", rows), HasSubstr("needs a Jacobian"));
  EXPECT_EQ(refused("lorenz*/rk4"), "accepted");
  const auto result = gate(good_rows(), "[[rule]]\ncase = [\"lorenz*/rk4\", \"*/rk4\"]\norder = \"claimed\"");
  EXPECT_EQ(finding_of(result, "lorenz*/rk4", "rule").outcome, Outcome::missing);
  EXPECT_EQ(finding_of(result, "lorenz*/rk4", "rule").line, 2);
  EXPECT_EQ(exit_code(result), 3);
  for (const char* absent : {"lorenz*/rk4", "kepler/rk5"}) {
    const auto excused = gate(good_rows(), std::string("[[rule]]\noptional = true\ncase = [\"") + absent +
                                               "\", \"*/rk4\"]\norder = \"claimed\"");
    EXPECT_EQ(finding_of(excused, absent, "rule").outcome, Outcome::note);
    EXPECT_EQ(exit_code(excused), 0);
  }
}

}  // namespace
}  // namespace odemark::check_thresholds_test
