// Settings: read from text, kept inside their ranges, shorthands resolved, every mistake one sentence.
#include "reference/settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "reference/bad_input.hpp"
#include "reference/truth_wide.hpp"
#include "tests/support/runs.hpp"

namespace odemark::settings_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

template <class F>
std::string complaint(F&& f) {
  try {
    f();
  } catch (const BadInput& e) {
    return e.what();
  }
  return "no complaint";
}
std::string complaint_about(std::string_view problem, std::string_view settings) {
  return complaint([&] { suite_problem(problem, settings); });
}

double value_of(const AnyProblem& problem, std::string_view name) {
  for (const auto& p : problem.parameters)
    if (p.name == name) return p.value;
  ADD_FAILURE() << problem.id << " has no " << name;
  return 0;
}

TEST(Settings, AreReadAndWritten) {
  EXPECT_TRUE(parse_settings("").empty());
  EXPECT_TRUE(parse_settings("  ").empty());
  const auto settings = parse_settings(" k = 6e5 ,m=168,name=a=b");
  ASSERT_EQ(settings.size(), 3u);
  EXPECT_EQ(settings[0].name, "k");
  EXPECT_EQ(settings[0].value, "6e5");
  EXPECT_EQ(settings[2].value, "a=b");
  EXPECT_EQ(to_string(settings), "k=6e5,m=168,name=a=b");
}

TEST(Settings, WhatIsNoSettingIsNamed) {
  for (const char* text : {"k", "k=", "=4", "k=4,", ",k=4", "k=4,,m=1", "   ,  "})
    EXPECT_THAT(complaint([&] { parse_settings(text); }), HasSubstr("is not a setting: write name=value"))
        << text;
  EXPECT_THAT(complaint([] { parse_settings("k=1,k=2"); }), HasSubstr("\"k\" is set twice"));
}

TEST(Settings, NumbersAndQuotients) {
  EXPECT_EQ(parse_number("x", "0.1"), 0.1);
  EXPECT_EQ(parse_number("x", "-3e5"), -3e5);
  EXPECT_EQ(parse_number("x", "+7"), 7);
  EXPECT_EQ(parse_number("x", "8/3"), 8.0 / 3.0);
  EXPECT_EQ(parse_number("x", "1/60"), 1.0 / 60);
  EXPECT_EQ(parse_number("x", "-1/-4"), 0.25);
  for (const char* text : {"", "one", "nan", "inf", "-inf", "1e999", "1/0", "1//2", "1/", "/2", "0x10", "1,5",
                           "1 2", "1e", "--1", "++1", "1/2/3", "1e-308/1e308/1"})
    EXPECT_THAT(complaint([&] { parse_number("zeta", text); }),
                AllOf(HasSubstr("is no value for zeta"), HasSubstr("8/3")))
        << text;
}

TEST(Settings, UnknownParametersGetTheNearestName) {
  EXPECT_THAT(
      complaint_about("damped_spring", "zetta=1"),
      AllOf(HasSubstr("has no parameter \"zetta\""), HasSubstr("did you mean \"zeta\"?"), HasSubstr("k, m")));
  EXPECT_THAT(complaint_about("damped_spring", "temperature=1"),
              AllOf(HasSubstr("has no parameter"), testing::Not(HasSubstr("did you mean"))));
}

TEST(Settings, UnknownProblemsGetTheNearestName) {
  EXPECT_THAT(complaint_about("keplr", ""), HasSubstr("did you mean \"kepler\"?"));
  EXPECT_THAT(complaint_about("oscilator", ""), HasSubstr("did you mean \"oscillator\"?"));
}

TEST(Settings, RangesHoldForEveryParameterOfEveryFamily) {
  for (const auto& family : suite_families())
    for (const auto& p : family.parameters) {
      const std::string name(p.name), id(family.id);
      SCOPED_TRACE(id + "." + name);
      EXPECT_THAT(complaint_about(id, name + "=nan"), HasSubstr("is no value for " + name));
      if (std::isfinite(p.range.lowest)) {
        const std::string below = std::to_string(p.range.lowest - 1);
        EXPECT_THAT(complaint_about(id, name + "=" + below),
                    AllOf(HasSubstr(name + "="), HasSubstr("is out of range for " + id)));
        if (p.range.open_below) {
          EXPECT_THAT(complaint_about(id, name + "=" + std::to_string(p.range.lowest)), HasSubstr("above"));
        }
      }
      if (std::isfinite(p.range.highest)) {
        EXPECT_THAT(complaint_about(id, name + "=" + std::to_string(p.range.highest + 1)),
                    HasSubstr("out of range"));
      }
    }
  EXPECT_THAT(complaint_about("kepler_e06", "e=1"), HasSubstr("it must be at least 0 and below 1"));
}

TEST(Settings, AShorthandSetsWhatItSays) {
  const auto problem = suite_problem("damped_spring", "k=6e5,m=168,zeta=0.1");
  EXPECT_DOUBLE_EQ(value_of(problem, "c"), 2 * 0.1 * std::sqrt(6e5 * 168));
  EXPECT_DOUBLE_EQ(value_of(suite_problem("oscillator", "m=2,omega=3"), "k"), 18);
}

TEST(Settings, APresetsShorthandSeesTheUsersParameters) {
  // critically damped means critically damped for the user's spring too
  const auto critical = suite_problem("damped_spring_critical", "k=9");
  EXPECT_DOUBLE_EQ(value_of(critical, "c"), 6);
  // and yields where the user says the same thing himself
  EXPECT_EQ(value_of(suite_problem("damped_spring_critical", "c=0.5"), "c"), 0.5);
  EXPECT_DOUBLE_EQ(value_of(suite_problem("damped_spring_critical", "zeta=0.5,k=4"), "c"), 2);
}

TEST(Settings, TwoWaysToSayOneThingMustAgree) {
  EXPECT_THAT(complaint_about("damped_spring", "zeta=0.1,c=7"),
              AllOf(HasSubstr("c=7 contradicts another setting"), HasSubstr("give one of the two")));
  EXPECT_EQ(complaint_about("damped_spring", "k=1,m=1,zeta=0.5,c=1"), "no complaint");
}

TEST(Settings, AProblemSaysWhatWasSet) {
  const auto plain = suite_problem("oscillator");
  EXPECT_EQ(plain.id, "oscillator");
  EXPECT_FALSE(plain.customised);
  const auto set = suite_problem("oscillator", "k=4, m = 2");
  EXPECT_EQ(set.id, "oscillator{k=4,m=2}");
  EXPECT_EQ(set.user_settings, "k=4,m=2");
  EXPECT_TRUE(set.customised);
  EXPECT_EQ(value_of(set, "k"), 4);
}

TEST(Settings, AFamilyStandsForItsFirstPreset) { EXPECT_EQ(suite_problem("kepler").preset, "kepler_e00"); }

TEST(Settings, ContradictionsWithinAProblemAreRefused) {
  EXPECT_THAT(complaint_about("stiff_spring_undamped", "k=1,omega=1"), HasSubstr("its own frequency"));
}

/// 0.1 in the settings is 1/10 in wide arithmetic where inputs are exact, and the double next to it
/// otherwise.
TEST(Settings, WideValuesAreExactOrTheDoublesThatProgramsSee) {
  const auto problem = suite_problem("oscillator", "x0=0.1,v0=8/3");
  const WideProblem exact = widened(problem, true), rounded = widened(problem, false);
  EXPECT_EQ(exact.initial[0] * 10, Wide(1));
  EXPECT_NEAR(static_cast<double>(exact.initial[1] * 3 - 8), 0, 1e-48);
  EXPECT_EQ(rounded.initial[0], Wide(0.1));
  EXPECT_EQ(rounded.initial[1], Wide(8.0 / 3));
  EXPECT_NE(exact.initial[0], rounded.initial[0]);
}

}  // namespace
}  // namespace odemark::settings_test
