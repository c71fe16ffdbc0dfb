// The baseline: equal bytes for equal numbers, written only with a reason, and a gate that sees every change.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "check_rows.hpp"
#include "reports/baseline.hpp"

namespace odemark::check_baseline_test {
namespace {

using testing::HasSubstr;

RunHeader header() {
  RunHeader h;
  h.version = "0.1.0", h.compiler = "g++ 12.2", h.flags = "-O3 -ffp-contract=off", h.build_type = "Release";
  return h;
}

std::string approved() { return approve(good_rows(), header(), std::nullopt, "first run").text; }

CheckResult gate_against(const std::optional<std::string>& text, const std::vector<Row>& rows,
                         const std::string& rules = "[defaults]\nbaseline_factor = 1.5",
                         const CheckOptions& options = {}) {
  return check(rows, {}, parse_thresholds("schema = 1\n" + rules), load_baseline(text), header(), options);
}

TEST(baseline, reads_back_to_the_same_bytes) {
  auto rows = good_rows();
  rows[0].errors->scaled = 0.1 + 0.2, rows[1].errors->scaled = 5e-324;
  rows[2].errors->scaled = std::numeric_limits<double>::quiet_NaN();
  rows[3].drift["energy"] = std::numeric_limits<double>::infinity();
  rows[4].status = "not_finite", rows[4].errors.reset();
  rows[5].provider = "gsl", rows[6].id += " \"quoted\" \\ \n";
  const std::string text = to_text(make_baseline(rows, header(), "why \"not\""));
  EXPECT_EQ(to_text(parse_baseline(text)), text);
  std::reverse(rows.begin(), rows.end());
  auto again = make_baseline(rows, header(), "why \"not\"");
  again.orders = parse_baseline(text).orders;
  EXPECT_EQ(to_text(again), text) << "the order of rows must not matter";
  EXPECT_THAT(text, HasSubstr("\"reached_end\",0.3,")) << "six digits";
  const Baseline read = parse_baseline(text);
  EXPECT_EQ(read.runs.size(), rows.size());
  EXPECT_TRUE(std::isinf(again.runs.at(rows[rows.size() - 4].id).drift.at("energy")));
  EXPECT_TRUE(std::isnan(read.runs.at(rows[rows.size() - 4].id).drift.at("energy")))
      << "not finite, no more is kept";
  EXPECT_EQ(read.runs.at(rows[rows.size() - 6].id).provider, "gsl");
  EXPECT_EQ(read.runs.at(rows[rows.size() - 6].id).case_name, "kepler/rk4");
  // one line a ladder; the run of another provider breaks one into three
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'),
            static_cast<std::ptrdiff_t>(11 + 6 + read.orders.size()));
}

TEST(baseline, damage_is_told_and_never_passes) {
  const std::string text = approved();
  for (std::size_t cut = 0; cut + 2 < text.size(); cut += 97) {
    EXPECT_THROW(parse_baseline(text.substr(0, cut)), BadBaseline) << cut;
  }
  std::string other = text;
  other.replace(other.find("\"schema\":2"), 10, "\"schema\":7");
  const std::string no_baseline_needed = "[[rule]]\ncase = \"*/*\"\norder = \"claimed\"";
  const auto refusal = [&](const std::optional<std::string>& baseline, bool named) -> std::string {
    try {
      gate_against(baseline, good_rows(), no_baseline_needed, {.baseline_named = named});
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusal(other, false), HasSubstr("it has schema 7, this odemark reads 2"));
  EXPECT_THAT(refusal("{", false), HasSubstr("baseline.json: cut or damaged"));
  EXPECT_THAT(refusal(std::nullopt, true), HasSubstr("there is no baseline.json"));
  EXPECT_EQ(refusal(std::nullopt, false), "accepted");
  EXPECT_EQ(refusal(text, true), "accepted");
  for (const char* bad : {"[]", "null", "{\"schema\":1e300}", "{\"schema\":1}", "{\"schema\":2}",
                          "{\"schema\":18446744073709551615}"})
    EXPECT_THROW(parse_baseline(bad), BadBaseline) << bad;
  const auto absent = gate_against(std::nullopt, good_rows());
  EXPECT_EQ(exit_code(absent), 3);
  EXPECT_THAT(to_console(absent), HasSubstr("there is no baseline.json"));
  EXPECT_EQ(exit_code(gate_against(std::nullopt, good_rows(), no_baseline_needed)), 0)
      << "a file that speaks of no baseline needs none";
}

TEST(baseline, every_change_is_seen) {
  const std::string text = approved();
  const auto good = gate_against(text, good_rows());
  EXPECT_EQ(exit_code(good), 0) << to_console(good);
  EXPECT_EQ(good.compared, 4);
  struct Fault {
    const char* metric;
    std::function<void(Row&)> plant;
  };
  const Fault faults[] = {
      {"baseline error", [](Row& row) { row.errors->scaled *= 2; }},
      {"baseline error", [](Row& row) { row.errors->scaled = std::nan(""); }},
      {"baseline status", [](Row& row) { row.status = "step_limit"; }},
      {"baseline status", [](Row& row) { row.status = "not_applicable"; }},
      {"baseline drift", [](Row& row) { row.drift["energy"] *= 2; }},
      {"baseline drift", [](Row& row) { row.drift["energy"] = std::nan(""); }},
      {"baseline drift", [](Row& row) { row.drift.clear(); }},
      {"evaluations", [](Row& row) { row.work.evaluations += row.work.evaluations / 5; }},
  };
  for (const Fault& fault : faults) {
    auto rows = good_rows();
    fault.plant(run_of(rows, "kepler", "heun", 128));
    const auto result = gate_against(text, rows);
    EXPECT_EQ(exit_code(result), 1) << fault.metric;
    EXPECT_EQ(finding_of(result, "kepler/heun", fault.metric).outcome, Outcome::fail) << to_console(result);
  }
  auto rows = good_rows();
  for (Row& row : rows)
    if (row.method == "heun")
      row.errors->scaled *= row.dt.value() > 0.1 ? 1 : 0.2 / std::sqrt(row.dt.value());
  EXPECT_EQ(finding_of(gate_against(text, rows), "kepler/heun", "baseline order").outcome, Outcome::fail);
}

TEST(baseline, better_and_below_the_floor_pass) {
  auto rows = good_rows();
  Row& row = run_of(rows, "kepler", "rk4", 1024);
  row.errors->scaled = 1e-15;
  const auto better = gate_against(approved(), rows);
  EXPECT_EQ(exit_code(better), 0);
  EXPECT_EQ(finding_of(better, "kepler/rk4", "baseline error").outcome, Outcome::improved);
  EXPECT_THAT(to_console(better), HasSubstr("improved, run `odemark approve --only 'kepler/rk4'`"));
  const std::string tiny = approve(rows, header(), std::nullopt, "r").text;
  row.errors->scaled = 9e-14;
  EXPECT_EQ(exit_code(gate_against(tiny, rows)), 0);
  row.errors->scaled = 2e-13;
  EXPECT_EQ(exit_code(gate_against(tiny, rows)), 1);
  row.sensitivity = 1e-12;
  EXPECT_EQ(exit_code(gate_against(tiny, rows)), 0);
}

TEST(baseline, missing_and_new_runs) {
  auto rows = good_rows();
  std::erase_if(rows, [](const Row& row) { return row.method == "heun" && *row.steps > 200; });
  const auto fewer = gate_against(approved(), rows);
  EXPECT_EQ(exit_code(fewer), 3) << to_console(fewer);
  EXPECT_EQ(finding_of(fewer, "kepler/heun", "baseline").others, 2);
  EXPECT_EQ(exit_code(gate_against(approved(), rows, "[defaults]\nbaseline_factor = 1.5", {.only = "rk4"})),
            0);
  rows = good_rows();
  rows.push_back(good_run("pendulum", "rk4", 4, 64));
  const auto more = gate_against(approved(), rows);
  EXPECT_EQ(exit_code(more), 0);
  EXPECT_EQ(finding_of(more, "pendulum/rk4", "baseline").outcome, Outcome::note);
  EXPECT_EQ(more.compared, 4);
}

TEST(baseline, strict_compares_bits) {
  auto rows = good_rows();
  run_of(rows, "kepler", "heun", 128).state_hash = "ffffffffffffffff";
  const std::string rules = "[defaults]\nbaseline_factor = 1.5";
  EXPECT_EQ(exit_code(gate_against(approved(), rows)), 0);
  EXPECT_EQ(exit_code(gate_against(approved(), rows, rules, {.strict = true})), 1);
  EXPECT_EQ(exit_code(gate_against(approved(), good_rows(), rules, {.strict = true})), 0);
}

TEST(baseline, contestants_are_compared_only_where_a_rule_says_so) {
  auto rows = good_rows();
  for (Row& row : rows)
    if (row.method == "heun") row.provider = "gsl";
  const std::string text = approve(rows, header(), std::nullopt, "r").text;
  const std::string rules = "[defaults]\nbaseline_factor = 1.5\n";
  for (Row& row : rows)
    if (row.method == "heun") row.errors->scaled *= 3;
  EXPECT_EQ(exit_code(gate_against(text, rows, rules)), 0);
  EXPECT_EQ(exit_code(gate_against(text, rows,
                                   rules + "[[rule]]\ncase = \"*/heun\"\nprovider = \"gsl\"\n"
                                           "baseline_factor = 2")),
            1);
  std::erase_if(rows, [](const Row& row) { return row.provider == "gsl"; });
  EXPECT_EQ(exit_code(gate_against(text, rows, rules)), 0) << "built without gsl";
}

TEST(approve, needs_a_reason_and_shows_what_changes) {
  EXPECT_THROW(approve(good_rows(), header(), std::nullopt, " \n"), std::invalid_argument);
  EXPECT_THROW(approve(good_rows(), header(), std::nullopt, "r", "("), std::invalid_argument);
  EXPECT_THROW(approve(good_rows(), header(), std::nullopt, "r", "lorenz"), std::invalid_argument);
  EXPECT_THROW(approve({}, header(), std::nullopt, "r"), std::invalid_argument);
  const Baseline old = parse_baseline(approved());
  EXPECT_EQ(approve(good_rows(), header(), old, "again").changes.rows.size(), 0u);
  auto rows = good_rows();
  for (Row& row : rows) row.errors->scaled *= 3;
  rows.push_back(good_run("kepler", "rk38", 4, 16));
  std::erase_if(rows, [](const Row& row) { return row.method == "rk4" && row.steps == 16; });
  const auto part = approve(rows, header(), old, "kepler changed", "^kepler/");
  EXPECT_EQ(part.changed, 6 + 7 + 1);
  EXPECT_EQ(part.added, 1);
  EXPECT_EQ(part.removed, 1);
  EXPECT_EQ(part.changes.rows.size(), 16u);
  EXPECT_NO_THROW(to_text(part.changes));
  const Baseline next = parse_baseline(part.text);
  const std::string other = "convergence/oscillator/rk4/double/steps=64";
  EXPECT_EQ(next.runs.at(other).scaled, old.runs.at(other).scaled) << "not chosen, not touched";
  EXPECT_EQ(next.reason, "kepler changed");
}

}  // namespace
}  // namespace odemark::check_baseline_test
