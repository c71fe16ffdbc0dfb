// The chart model: what a picture shows, free of any drawing. Emitters (SVG now, interactive later) lay it
// out.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace odemark {

enum class Scale { linear, log10 };

struct AxisRange {
  double low;
  double high;
};

struct Axis {
  std::string label;
  Scale scale = Scale::linear;
  std::optional<AxisRange> range{};  // absent: fitted to the data, so that nothing drawn is hidden
};

// A diverged point needs only a finite x: it is drawn hollow on the top frame whatever its y, never dropped.
// Any other point that is not finite breaks the line and is counted in the notes under the picture.
struct Point {
  double x;
  double y;
  bool diverged = false;
  std::string note{};  // shown on hover and in the data table
};

enum class Line { none, solid, dashed, dotted };

enum class Marker {
  none,
  circle,
  square,
  triangle_up,
  diamond,
  triangle_down,
  cross,
  plus,
  star,
  triangle_right,
  hourglass
};

// How one series looks. Take it from a Palette, so that a method looks the same in every chart.
struct Style {
  int colour = 0;  // index into theme_colour(), taken modulo its length
  Marker marker = Marker::circle;
  Line line = Line::solid;
  bool filled = true;  // false: hollow markers
};

// A curve, or with Line::none a cloud of dots (eigenvalues times dt). Drawn above regions, in the order
// given.
struct Series {
  std::string id;
  std::string label;
  std::string family;  // groups the legend
  std::vector<Point> points;
  Style style{};
};

struct Position {
  double x;
  double y;
};

// A set in the plane, such as |R(z)| <= 1: closed outlines, filled by the even-odd rule.
struct Region {
  std::string id;
  std::string label;
  std::string family;
  std::vector<std::vector<Position>> outlines;
  Style style{};
};

// Slopes of a log-log chart, drawn as a labelled fan in the emptiest corner. Use -p where error falls with x.
struct SlopeFan {
  std::vector<double> slopes;
  std::string label = "order";
};

enum class Direction { horizontal, vertical };

struct ReferenceLine {
  Direction direction;
  double value;
  std::string label{};
};

// A shaded strip, such as the round-off floor. An infinite end reaches to the frame.
struct Band {
  Direction direction;  // horizontal: low and high are y values
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  std::string label{};
};

enum class Anchor { start, middle, end };

struct Annotation {
  double x;
  double y;
  std::string text;
  Anchor anchor = Anchor::start;
};

struct Chart {
  std::string id;  // names the figure's anchor in a page
  std::string title;
  std::string caption;  // what to see, in words
  Axis x{};
  Axis y{};
  std::vector<Series> series{};
  std::vector<Region> regions{};
  std::optional<SlopeFan> slopes{};
  std::vector<ReferenceLine> lines{};
  std::vector<Band> bands{};
  std::vector<Annotation> annotations{};
  bool equal_aspect = false;  // one unit is as long on x as on y; only with two linear axes
};

}  // namespace odemark
