// Pages of problems: equations that a browser can set, and what is certified, from plain data.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "reference/any_problem.hpp"
#include "reports/mathml.hpp"
#include "reports/page_files.hpp"
#include "reports/problem_sheet_page.hpp"

namespace odemark::report_problems_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Every element that is opened is closed, in order.
bool is_balanced(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != xml.npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == xml.npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else {
      open.push_back(tag.substr(0, tag.find(' ')));
    }
  }
  return open.empty();
}

TEST(MathML, SetsWhatMattersInEquations) {
  EXPECT_THAT(to_mathml("v' = -(k/m) x", {}),
              HasSubstr("<msup><mrow><mi>v</mi></mrow><mo>′</mo></msup><mo>=</mo><mo>−</mo>"));
  EXPECT_THAT(to_mathml("(F - c v)/m", {}),
              HasSubstr("<mfrac><mrow><mi>F</mi><mo>−</mo><mi>c</mi><mi>v</mi></mrow>"
                        "<mrow><mi>m</mi></mrow></mfrac>"));
  EXPECT_THAT(to_mathml("r^3", {}), HasSubstr("<msup><mrow><mi>r</mi></mrow><mrow><mn>3</mn></mrow></msup>"));
  EXPECT_THAT(to_mathml("|t - i|^(1/3)", {}), HasSubstr("<mo>|</mo></mrow></mrow><mrow><mfrac>"));
  EXPECT_THAT(to_mathml("sqrt(x^2 + y2)", {}), HasSubstr("<msqrt>"));
  EXPECT_THAT(to_mathml("y2", {}), HasSubstr("<msub><mi>y</mi><mi>2</mi></msub>"));
  EXPECT_THAT(to_mathml("lambda_re re", {"re", "lambda_re"}),
              HasSubstr("<msub><mi>λ</mi><mi>re</mi></msub><mi>re</mi>"));
  EXPECT_THAT(to_mathml("thrust for t", {"thrust"}),
              HasSubstr("<mi>thrust</mi><mtext>&#xA0;for&#xA0;</mtext>"));
  EXPECT_THAT(to_mathml("x' = v;  v' = -g", {}), HasSubstr("</mtr><mtr>"));
  EXPECT_THAT(to_mathml("x <= 1 -> y >= 0", {}), HasSubstr("<mo>≤</mo>"));
}

TEST(MathML, IsWellFormedWhateverTheText) {
  std::string parentheses(200, '(');
  for (const std::string& text :
       {std::string("<b>&\"'"), std::string(")(|]/^_'"), parentheses, std::string("a/"), std::string("x^"),
        std::string("x^-"), std::string("|a|b|"), std::string("sqrt("), std::string("1e-3 .5 1e"),
        std::string("ü ∫ y dt"), std::string(";;;")}) {
    const std::string xml = to_mathml(text, {});
    EXPECT_TRUE(is_balanced(xml)) << text << " -> " << xml;
    EXPECT_THAT(xml, Not(HasSubstr("<b>")));
  }
  for (const auto& family : suite_families())
    EXPECT_TRUE(is_balanced(to_mathml(family.equations, {}))) << family.id;
}

ProblemSheet ball() {
  ProblemSheet sheet;
  sheet.id = "ball", sheet.title = "A <ball>", sheet.equations = "x' = v;  v' = -g", sheet.source = "us";
  sheet.components = {{"x", "m"}, {"v", "m/s"}};
  sheet.parameters = {{"g", "m/s^2", "gravity", "> 0", 9.8125, false},
                      {"fall", "s", "sets g", "> 0", 0, true}};
  sheet.events = {"bounce"}, sheet.offers = {"closed form"};
  SheetPreset preset;
  preset.id = "ball", preset.about = "three bounces", preset.t_end = 2, preset.suggested_dt = 0.125;
  preset.digits = 44, preset.origin = "closed form", preset.checked_by = "Taylor series", preset.events = 3;
  preset.fastest_decay = 1000, preset.stiffness_ratio = 500;
  preset.limits = {{"rk4", 0.0027}, {"implicit_euler", {}}};
  sheet.presets = {preset};
  Trajectory falling;
  falling.component = "v", falling.unit = "m/s", falling.t = {0, 1, 2}, falling.value = {0, -10, -20};
  sheet.scene.emplace().problem = "ball";
  sheet.scene->exact = {falling};
  return sheet;
}

TEST(ProblemPages, SayWhatIsKnown) {
  const auto pages = family_pages({ball()});
  ASSERT_EQ(pages.size(), 1u);
  EXPECT_EQ(pages.front().name, "families/ball.html");
  const std::string html = to_html(pages.front().page);
  for (const char* part : {"<math", "A &lt;ball&gt;", "bounce", "Taylor series", "44", "gravity",
                           "three bounces", "no limit", "0.0027", "500"})
    EXPECT_THAT(html, HasSubstr(part));
  EXPECT_THAT(to_markdown(pages.front().page, "svg"), HasSubstr("```\nx' = v;  v' = -g\n```"));
  EXPECT_THAT(html, Not(HasSubstr(">t</text>")));
  EXPECT_THAT(html, HasSubstr(">t [s]</text>"));
  auto without_unit = ball();
  for (auto& [name, unit] : without_unit.components) unit.clear();
  EXPECT_THAT(to_html(family_pages({without_unit}).front().page), HasSubstr(">t</text>"));
  const std::string overview = to_html(families_page({ball()}));
  EXPECT_THAT(overview, HasSubstr("families/ball.html"));
  EXPECT_THAT(overview, HasSubstr("1 families, 1 presets, 1 of them certified to 30 digits or more"));
}

}  // namespace
}  // namespace odemark::report_problems_test
