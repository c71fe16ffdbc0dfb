// The rendering half of reports: bytes of small pictures, and that nothing is lost, unescaped or
// undetermined.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

#include "reports/axis.hpp"
#include "reports/chart_notes.hpp"
#include "reports/chart_table.hpp"
#include "reports/decimate.hpp"
#include "reports/format.hpp"
#include "reports/html.hpp"
#include "reports/markup.hpp"
#include "reports/palette.hpp"
#include "reports/svg.hpp"
#include "reports/table.hpp"
#include "reports/unicode.hpp"

namespace odemark::render_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

Axis log_axis(std::string label) { return {.label = std::move(label), .scale = Scale::log10}; }

Chart with_points(std::vector<Point> points, Scale scale) {
  Chart chart{.id = "c", .title = "t", .caption = ""};
  chart.x.scale = chart.y.scale = scale;
  chart.series.push_back({"rk4", "RK4", "Runge–Kutta", std::move(points)});
  return chart;
}

Chart convergence() {
  const Palette palette({{"euler", "Runge–Kutta"}, {"rk4", "Runge–Kutta"}, {"ab2", "Adams"}});
  Chart chart{.id = "convergence", .title = "Error against step size", .caption = "Slopes 1, 4 and 2."};
  chart.x = log_axis("dt");
  chart.y = log_axis("error");
  chart.series = {{"euler", "Euler", "Runge–Kutta", {{0.01, 1e-2}, {0.1, 1e-1}}, palette.style_of("euler")},
                  {"rk4", "RK4", "Runge–Kutta", {{0.01, 1e-9}, {0.1, 1e-5}}, palette.style_of("rk4")},
                  {"ab2", "AB2", "Adams", {{0.01, 1e-4}, {0.1, nan, true}}, palette.style_of("ab2")}};
  chart.slopes = SlopeFan{{1, 2, 4}};
  chart.bands = {{.direction = Direction::horizontal, .high = 1e-9, .label = "round-off"}};
  return chart;
}

Chart disc() {
  Chart chart{.id = "disc", .title = "Stability of Euler", .caption = "The unit disc around -1."};
  chart.x.label = "Re z";
  chart.y.label = "Im z";
  chart.equal_aspect = true;
  chart.regions = {{"euler", "Euler", "", {{{-2, 0}, {-1, 1}, {0, 0}, {-1, -1}}}}};
  chart.series = {{"dots", "λ dt", "", {{-0.5, 0.5}, {-0.5, -0.5}}, {.colour = 4, .line = Line::none}}};
  chart.lines = {{Direction::vertical, -1, "centre"}};
  chart.annotations = {{-1.5, 0.2, "stable", Anchor::middle}};
  return chart;
}

// To accept a changed picture, look at it first, then run with ODEMARK_WRITE_GOLDEN=1.
void expect_golden(const Chart& chart) {
  const std::string path = std::string(ODEMARK_GOLDEN_DIR) + "/" + chart.id + ".svg";
  const std::string svg = to_svg(chart, chart.id);
  if (std::getenv("ODEMARK_WRITE_GOLDEN") != nullptr) std::ofstream(path, std::ios::binary) << svg;
  std::ifstream file(path, std::ios::binary);
  ASSERT_TRUE(file) << path;
  EXPECT_EQ(svg, std::string(std::istreambuf_iterator<char>(file), {}));
}

std::vector<std::string> tick_texts(double low, double high, Scale scale) {
  std::vector<std::string> texts;
  for (const Tick& tick : choose_ticks(fit_axis({"", scale, AxisRange{low, high}}, {}), 9)) {
    if (!tick.label.base.empty()) texts.push_back(tick.label.base + "^" + tick.label.exponent);
  }
  return texts;
}

TEST(Svg, GoldenConvergence) { expect_golden(convergence()); }
TEST(Svg, GoldenStabilityRegion) { expect_golden(disc()); }

TEST(Svg, TwoCallsGiveTheSameBytes) {
  EXPECT_EQ(to_svg(convergence(), "a"), to_svg(convergence(), "a"));
  EXPECT_NE(to_svg(convergence(), "a"), to_svg(convergence(), "b"));
}

TEST(Svg, EveryIdAndReferenceCarriesThePrefix) {
  const std::string svg = to_svg(convergence(), "p1");
  EXPECT_EQ(count(svg, "id=\""), count(svg, "id=\"p1"));
  EXPECT_EQ(count(svg, "url(#"), count(svg, "url(#p1-"));
  EXPECT_EQ(count(svg, "href=\""), count(svg, "href=\"#p1-"));
}

TEST(Svg, EscapesEveryText) {
  Chart chart = convergence();
  const std::string evil = "<script>&\"'";
  chart.title = chart.caption = chart.x.label = chart.y.label = chart.bands[0].label = evil;
  for (Series& s : chart.series) s.id = s.label = s.family = s.points[0].note = evil;
  chart.slopes->label = evil;
  chart.lines = {{Direction::horizontal, 1e-3, evil}};
  chart.annotations = {{0.05, 1e-3, evil}};
  const std::string svg = to_svg(chart, evil);
  EXPECT_EQ(svg.find("<script"), svg.npos);
  EXPECT_EQ(svg.find("&\""), svg.npos);
  EXPECT_EQ(svg.find(evil), svg.npos);
  EXPECT_NE(svg.find("&lt;script&gt;&amp;&quot;&#39;"), svg.npos);
}

TEST(Svg, DivergedPointsStayHollowOnTheFrame) {
  const Chart chart = with_points({{0.01, 1e-3}, {0.1, infinity, true}, {0.2, nan, true}}, Scale::log10);
  const std::string svg = to_svg(chart, "p");
  EXPECT_EQ(count(svg, "diverged</title>"), 2u);
  EXPECT_EQ(count(svg, "<use "), 1u);
  EXPECT_EQ(svg.find("nan"), svg.npos);
  EXPECT_EQ(svg.find("inf"), svg.npos);
  EXPECT_EQ(chart_notes(chart).at(0), "2 points diverged, hollow on the top frame: RK4");
}

TEST(Svg, NotFinitePointsBreakTheLineAndAreCounted) {
  const Chart chart = with_points({{0, 1}, {1, 2}, {2, nan}, {3, infinity}, {4, 2}, {5, 1}}, Scale::linear);
  const std::string svg = to_svg(chart, "p");
  const std::size_t line = svg.find("<path d=\"M", svg.find("data-series"));
  const std::string path = svg.substr(line, svg.find("/>", line) - line);
  EXPECT_EQ(count(path, "M"), 2u);
  EXPECT_NE(svg.find("2 points not finite, not drawn: RK4"), svg.npos);
}

TEST(Svg, NegativeAndZeroOnALogAxisAreNoted) {
  const std::string svg = to_svg(with_points({{0.1, 1e-3}, {0.2, -1}, {0.3, 0}}, Scale::log10), "p");
  EXPECT_NE(svg.find("2 points zero or negative"), svg.npos);
}

TEST(Svg, PointsOutsideAFixedRangeAreNoted) {
  Chart chart = with_points({{0, 0}, {1, 5}, {2, 50}}, Scale::linear);
  chart.y.range = AxisRange{0, 10};
  EXPECT_EQ(chart_notes(chart).at(0), "1 point outside the frame: RK4");
}

TEST(Svg, DegenerateDataStillGiveAPicture) {
  for (const Scale scale : {Scale::linear, Scale::log10}) {
    const std::vector<std::vector<Point>> cases{
        {},           {{1, 1}},          {{1, 2}, {2, 2}}, {{0, 0}}, {{1e308, 1e308}, {-1e308, -1e308}},
        {{nan, nan}}, {{5e-324, 5e-324}}};
    for (const auto& points : cases) {
      const std::string svg = to_svg(with_points(points, scale), "p");
      EXPECT_NE(svg.find("</svg>"), svg.npos);
      EXPECT_EQ(svg.find("\"nan"), svg.npos);
    }
  }
  EXPECT_NE(to_svg(Chart{}, "").find("</svg>"), std::string::npos);
}

TEST(Ticks, LogRanges) {
  const auto wide = tick_texts(1e-16, 1, Scale::log10);
  EXPECT_EQ(wide, (std::vector<std::string>{"10^−16", "10^−14", "10^−12", "10^−10", "10^−8", "10^−6", "10^−4",
                                            "10^−2", "10^0"}));
  const auto narrow = tick_texts(0.9, 1.1, Scale::log10);
  EXPECT_GE(narrow.size(), 3u);
  EXPECT_EQ(narrow.front(), "0.90^");
  EXPECT_EQ(tick_texts(1, 20, Scale::log10), (std::vector<std::string>{"10^0", "10^1"}));
  EXPECT_EQ(tick_texts(1.5, 20, Scale::log10), (std::vector<std::string>{"2^", "5^", "10^", "20^"}));
}

TEST(Ticks, LinearRanges) {
  EXPECT_EQ(tick_texts(-2, 2, Scale::linear).front(), "−2.0^");
  EXPECT_EQ(tick_texts(0, 3e-9, Scale::linear).back(), "3.0×10^−9");
  EXPECT_EQ(tick_texts(1, 1.0000001, Scale::linear).at(1), "1.00000002^");
}

TEST(Looks, AMethodKeepsItsColourAndMarker) {
  const std::vector<PaletteMember> list{{"zeta", "A"}, {"alpha", "A"}, {"beta", "B"}};
  const Palette palette(list);
  EXPECT_EQ(palette.style_of("zeta").colour, palette.style_of("alpha").colour);
  EXPECT_NE(palette.style_of("zeta").marker, palette.style_of("alpha").marker);
  EXPECT_EQ(palette.style_of("zeta").colour, 0);  // order of the list, not of the alphabet
  EXPECT_EQ(palette.style_of("beta").colour, 1);
  EXPECT_THROW(palette.style_of("gamma"), std::invalid_argument);
}

Table sample() {
  return {
      .id = "t",
      .title = "Orders",
      .note = "n",
      .columns = {{"method"}, {"error", Align::right, "m"}},
      .rows = {{{"a,\"b\""}, number_cell(0.5, "0.5")}, {{"λ|µ"}, number_cell(nan, "nan")}, {{"x < y\nz"}}}};
}

TEST(Tables, CsvQuotes) {
  EXPECT_EQ(to_csv(sample()), "method,error [m]\r\n\"a,\"\"b\"\"\",0.5\r\nλ|µ,–\r\n\"x < y\nz\",\r\n");
}

TEST(Tables, MarkdownAndText) {
  EXPECT_NE(to_markdown(sample()).find("| λ\\|µ | – |"), std::string::npos);
  EXPECT_NE(to_markdown(sample()).find("| x &lt; y<br>z |  |"), std::string::npos);
  EXPECT_NE(to_text(sample()).find("λ|µ              –\n"), std::string::npos);
}

TEST(Tables, HtmlEscapesAndRefusesScriptLinks) {
  Table table = sample();
  table.rows[0][0].link = "javascript:alert(1)";
  table.rows[1][0].link = "#a\"b";
  const std::string html = to_html(table);
  EXPECT_EQ(html.find("javascript"), html.npos);
  EXPECT_NE(html.find("href=\"#a&quot;b\""), html.npos);
  EXPECT_NE(html.find("x &lt; y"), html.npos);
  EXPECT_NE(html.find("<td class=\"right muted\">–\n"), html.npos);
  EXPECT_NE(html.find("data-sort=\"0.5\""), html.npos);
}

TEST(Tables, SurplusCellsAreAnError) {
  Table table = sample();
  table.rows[0].resize(3);
  EXPECT_THROW(to_csv(table), std::invalid_argument);
}

TEST(Text, WidthOfUtf8) {
  EXPECT_EQ(column_width("µs – 10⁻⁸"), 9);
  EXPECT_EQ(column_width("漢字"), 4);
  EXPECT_EQ(column_width("e\u0301"), 1);
  EXPECT_EQ(column_width("\xff\xfe"), 2);
  EXPECT_EQ(escaped("a\x01\xff"), "a\uFFFD\uFFFD");
}

TEST(Numbers, Formats) {
  EXPECT_EQ(scientific(1.234e-5, 3), "1.23e-05");
  EXPECT_EQ(engineering(1.234e-5, 3), "12.3e-06");
  EXPECT_EQ(significant(0.012345, 3), "0.0123");
  EXPECT_EQ(significant(9.996, 3), "10.0");
  EXPECT_EQ(compact(-0.0, 3) + compact(40, 6) + compact(1e-12, 6), "0401e-12");
  EXPECT_EQ(percent(0.1234, 1), "12.3 %");
  EXPECT_EQ(duration(1.23e-8), "12.3 ns");
  EXPECT_EQ(duration(9.9996e-7), "1.00 µs");
  EXPECT_EQ(power_of_ten(-18), "10⁻¹⁸");
  EXPECT_EQ(within_resolution(3e-17, 1e-16, 3), "0 within 1e-16");
  for (const double x : {nan, infinity, -infinity}) EXPECT_EQ(significant(x, 3) + duration(x), "––");
}

TEST(Decimation, KeepsExtremesGapsAndDivergedPoints) {
  std::vector<Point> points;
  for (int i = 0; i < 10000; ++i) points.push_back({i * 0.01, std::sin(i * 0.01)});
  points[1234].y = 50;
  points[4321].y = -50;
  points[6000].y = nan;
  points[9000].diverged = true;
  const std::vector<Point> kept = decimate(points);
  EXPECT_LE(kept.size(), points_per_series);
  EXPECT_EQ(kept.front().x, points.front().x);
  EXPECT_EQ(kept.back().x, points.back().x);
  const auto has = [&kept](auto test) { return std::any_of(kept.begin(), kept.end(), test); };
  EXPECT_TRUE(has([](const Point& p) { return p.y == 50; }));
  EXPECT_TRUE(has([](const Point& p) { return p.y == -50; }));
  EXPECT_TRUE(has([](const Point& p) { return std::isnan(p.y); }));
  EXPECT_TRUE(has([](const Point& p) { return p.diverged; }));
}

TEST(Html, SelfContainedUniqueAndDeterministic) {
  Page page{.title = "Report <1>", .sections = {{"s", "Section", {convergence(), convergence(), sample()}}}};
  const std::string html = to_html(page);
  EXPECT_EQ(html, to_html(page));
  EXPECT_NE(html.find("<title>Report &lt;1&gt;</title>"), html.npos);
  EXPECT_EQ(count(html, "id=\"convergence\""), 1u);
  EXPECT_EQ(count(html, "id=\"convergence-2\""), 1u);
  EXPECT_EQ(count(html, "<details>"), 2u);
  EXPECT_EQ(count(html, "src="), 0u);
  EXPECT_EQ(count(html, "http"), count(html, "http://www.w3.org/2000/svg"));
}

TEST(Html, ChartDataTableKeepsEveryPoint) {
  const Table table = chart_table(convergence());
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.columns.size(), 4u);
  EXPECT_EQ(table.rows[1][3].text, "diverged");
  EXPECT_EQ(chart_table(disc()).rows.size(), 3u);
}

}  // namespace
}  // namespace odemark::render_test
