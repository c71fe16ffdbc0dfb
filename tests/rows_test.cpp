// Rows survive their way through a file: every field, in one line, under keys that do not change.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bench/json_line.hpp"

namespace odemark::rows_test {
namespace {

using testing::HasSubstr;

const double infinity = std::numeric_limits<double>::infinity();
const double nan = std::numeric_limits<double>::quiet_NaN();

RunHeader full_header() {
  RunHeader h;
  h.suite = "quick", h.version = "0.1.0", h.revision = "abc", h.date = "2024-01-02T03:04:05Z";
  h.compiler = "GCC 12.2.0", h.flags = "-O3", h.build_type = "Release", h.processor = "x", h.system = "Linux";
  h.cores = 2;
  h.providers = {{"gsl", "2.7"}, {"sundials", "6.4.1"}};
  h.footnotes = {"frequency scaling is on"};
  return h;
}

Row full_row() {
  Row r;
  r.id = "convergence/kepler_e06/rk4/double/steps=16", r.plan = "convergence", r.problem = "kepler_e06";
  r.family = "kepler", r.settings = "mu=2", r.method = "rk4", r.kind = "explicit Runge-Kutta";
  r.provider = "odemark", r.order = 4, r.embedded_order = 3, r.scalar = "double", r.compensated = true;
  r.steps = 16, r.dt = 0.625, r.rtol = 1e-3, r.atol = 1e-6, r.filter = "pi";
  r.status = "reached_end", r.reason = "a \"quoted\"\nreason", r.accepted = 16, r.rejected = 2;
  r.t_end = 10, r.t_reached = 10;
  r.work = {64, 1, 2, 3, 4, 5, 65};
  r.errors = RowErrors{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, -0.7, 0.8, 0.0009};
  r.truth_floor = 1e-25, r.sensitivity = 1e-15, r.truth_digits = 25;
  r.drift = {{"energy", 1e-3}, {"angular_momentum", 0}};
  r.events = RowEvents{3, 4, 0.0625};
  r.timing = RowTiming{1e-6, 2e-6, 1e-7, 7, 62.5, 100, "static"};
  r.state_hash = "0123456789abcdef";
  return r;
}

std::string file_of(const std::string& lines) { return to_json_line(full_header()) + "\n" + lines; }

Row round_trip(const Row& row) {
  const auto results = parse_results(file_of(to_json_line(row) + "\n"), "rows");
  EXPECT_EQ(results.rows.size(), 1u);
  return results.rows.at(0);
}

TEST(Rows, HeaderRoundTrip) {
  const auto results = parse_results(file_of(""), "rows");
  EXPECT_EQ(to_json_line(results.header), to_json_line(full_header()));
  EXPECT_EQ(results.header.providers, full_header().providers);
  EXPECT_EQ(results.header.footnotes, full_header().footnotes);
  EXPECT_FALSE(results.cut);
}

TEST(Rows, EveryFieldComesBack) {
  const Row row = full_row(), back = round_trip(row);
  EXPECT_EQ(to_json_line(back), to_json_line(row));
  EXPECT_EQ(back.reason, row.reason);
  EXPECT_EQ(back.steps, row.steps);
  EXPECT_EQ(back.dt, row.dt);
  EXPECT_EQ(back.work.newton, 5);
  EXPECT_EQ(back.work.evaluations, 65);
  EXPECT_EQ(back.errors->phase, row.errors->phase);
  EXPECT_EQ(back.errors->relative, row.errors->relative);
  EXPECT_EQ(back.drift, row.drift);
  EXPECT_EQ(back.events->found, 3);
  EXPECT_EQ(back.events->expected, 4);
  EXPECT_EQ(back.events->worst_time_error, 0.0625);
  EXPECT_EQ(back.timing->tier, "static");
  EXPECT_EQ(back.timing->mad_seconds, row.timing->mad_seconds);
  EXPECT_TRUE(back.compensated);
}

TEST(Rows, ARowIsOneLine) {
  EXPECT_EQ(to_json_line(full_row()).find('\n'), std::string::npos);
  EXPECT_EQ(to_json_line(full_header()).find('\n'), std::string::npos);
}

/// Files of this schema are read by others: a key that is renamed, dropped or moved needs a new schema.
TEST(Rows, KeysAreStable) {
  EXPECT_EQ(row_schema, 1);
  EXPECT_EQ(
      to_json_line(full_row()),
      R"({"record":"run","id":"convergence/kepler_e06/rk4/double/steps=16","plan":"convergence",)"
      R"("problem":"kepler_e06","family":"kepler","settings":"mu=2","method":"rk4",)"
      R"("kind":"explicit Runge-Kutta","provider":"odemark","order":4,"embedded_order":3,)"
      R"("scalar":"double","compensated":true,"steps":16,"dt":0.625,"rtol":0.001,"atol":1e-06,)"
      R"("filter":"pi","status":"reached_end","reason":"a \"quoted\"\nreason","accepted":16,"rejected":2,)"
      R"("t_end":10.0,"t_reached":10.0,"work":{"rhs":64,"acceleration":1,"jacobian":2,"series":3,"lu":4,)"
      R"("newton":5,"evaluations":65},"errors":{"scaled":0.1,"absolute":0.2,"relative":0.3,"rms":0.4,)"
      R"("trajectory_max":0.5,"trajectory_rms":0.6,"amplitude":-0.7,"phase":0.8,"left":0.0009},"truth_floor":1e-25,)"
      R"("sensitivity":1e-15,"truth_digits":25.0,"drift":{"angular_momentum":0.0,"energy":0.001},)"
      R"("events":{"found":3,"expected":4,"worst_time_error":0.0625},)"
      R"("timing":{"minimum_seconds":1e-06,"median_seconds":2e-06,"mad_seconds":1e-07,"repeats":7,)"
      R"("ns_per_step":62.5,"ns_per_simulated_second":100.0,"tier":"static"},)"
      R"("state_hash":"0123456789abcdef"})");
}

TEST(Rows, NumbersComeBackToTheLastBit) {
  Row row = full_row();
  for (const double x : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -0.0, 4.9406564584124654e-320}) {
    row.t_reached = x, row.errors->scaled = x, row.truth_floor = x;
    const Row back = round_trip(row);
    EXPECT_EQ(back.t_reached, x);
    EXPECT_EQ(std::signbit(back.t_reached), std::signbit(x));
    EXPECT_EQ(back.errors->scaled, x);
  }
}

TEST(Rows, WhatIsNoNumberIsAbsentAndNeverGood) {
  Row row = full_row();
  row.errors = RowErrors{nan, infinity, -infinity, nan, nan, infinity, nan, infinity, nan};
  row.drift = {{"energy", infinity}, {"momentum", nan}};
  row.timing->ns_per_step = infinity, row.timing->median_seconds = nan;
  const std::string line = to_json_line(row);
  EXPECT_THAT(line, testing::Not(HasSubstr("nan")));
  EXPECT_THAT(line, testing::Not(HasSubstr("inf,")));
  const Row back = round_trip(row);
  EXPECT_TRUE(std::isnan(back.timing->ns_per_step) && std::isnan(back.timing->median_seconds));
  EXPECT_EQ(back.timing->minimum_seconds, row.timing->minimum_seconds);
  EXPECT_TRUE(std::isnan(back.errors->scaled));
  EXPECT_TRUE(std::isnan(back.errors->absolute));
  EXPECT_TRUE(std::isnan(back.errors->rms));
  EXPECT_FALSE(back.errors->relative || back.errors->phase || back.errors->amplitude);
  ASSERT_EQ(back.drift.size(), 2u);
  EXPECT_TRUE(std::isnan(back.drift.at("energy")));
}

TEST(Rows, AbsentFieldsStayAbsent) {
  Row row;
  row.id = "x", row.status = "not_applicable", row.reason = "needs a Jacobian";
  const Row back = round_trip(row);
  EXPECT_FALSE(back.steps || back.dt || back.rtol || back.atol || back.errors || back.timing);
  EXPECT_TRUE(back.drift.empty() && back.settings.empty() && back.filter.empty());
  EXPECT_EQ(back.reason, "needs a Jacobian");
}

TEST(Rows, StabilityRoundTrip) {
  StabilityRow row;
  row.problem = "oscillator", row.family = "oscillator", row.method = "rk4", row.kind = "k",
  row.provider = "odemark";
  row.scalar = "double", row.verdict = "limit", row.measured = 2.5, row.theory = 2.8284271247461903;
  row.later_bands = {{3, 4}}, row.eigenvalues = {{0, 1}, {0, -1}};
  const auto results = parse_results(file_of(to_json_line(row) + "\n"), "rows");
  ASSERT_EQ(results.stability.size(), 1u);
  EXPECT_EQ(to_json_line(results.stability[0]), to_json_line(row));
  EXPECT_EQ(results.stability[0].eigenvalues, row.eigenvalues);
}

TEST(Rows, ACutLastLineIsLeftOutAndSaid) {
  const std::string line = to_json_line(full_row());
  const std::string whole = file_of(line + "\n" + line + "\n");
  for (std::size_t cut = whole.size() - 1; cut > whole.size() - line.size(); cut -= 7) {
    const auto results = parse_results(std::string_view(whole).substr(0, cut), "rows");
    EXPECT_TRUE(results.cut);
    EXPECT_EQ(results.rows.size(), 1u);
  }
}

std::string complaint(const std::string& text) {
  try {
    parse_results(text, "out/results.jsonl");
  } catch (const BadResults& e) {
    return e.what();
  }
  return "no complaint";
}

TEST(Rows, WhatCannotBeReadIsNamedByLine) {
  const std::string line = to_json_line(full_row()) + "\n";
  EXPECT_THAT(complaint(file_of(line + "garbage\n" + line)),
              HasSubstr("out/results.jsonl:3: not a results line"));
  EXPECT_THAT(complaint(file_of(line + "{\"record\":\"run\",\"id\":7}\n")), HasSubstr("results.jsonl:3:"));
  EXPECT_THAT(complaint(file_of("{\"record\":\"run\",\"id\":\"x\"}\n")), HasSubstr(":2: a run needs"));
  EXPECT_THAT(complaint(file_of("{\"record\":\"dream\"}\n")),
              HasSubstr(":2: \"dream\" is no kind of record"));
  EXPECT_THAT(complaint(line), HasSubstr(":1: the first line must be the header"));
  EXPECT_THAT(complaint(""), HasSubstr("empty, not a results file"));
  EXPECT_THAT(complaint("\n\n"), HasSubstr("empty, not a results file"));
  EXPECT_THAT(complaint("[]\n"), HasSubstr(":1:"));
  EXPECT_THAT(complaint("7\n"), HasSubstr(":1:"));
  EXPECT_THAT(complaint(file_of("null\n")), HasSubstr(":2:"));
}

TEST(Rows, AnotherSchemaIsRefusedInOneSentence) {
  RunHeader header = full_header();
  header.schema = 99;
  EXPECT_THAT(complaint(to_json_line(header) + "\n"), HasSubstr("schema 99, this odemark reads schema 1"));
}

TEST(Rows, AMissingFileIsOneSentence) {
  EXPECT_THROW(
      {
        try {
          read_results("/no/such/folder/results.jsonl");
        } catch (const BadResults& e) {
          EXPECT_THAT(e.what(), HasSubstr("cannot read /no/such/folder/results.jsonl"));
          throw;
        }
      },
      BadResults);
}

TEST(Rows, BlankLinesAndWindowsLineEndsDoNoHarm) {
  const std::string line = to_json_line(full_row());
  EXPECT_EQ(parse_results(file_of("\n" + line + "\r\n\n"), "rows").rows.size(), 1u);
}

}  // namespace
}  // namespace odemark::rows_test
