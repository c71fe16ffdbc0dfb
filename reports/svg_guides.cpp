// What helps to read the data: bands, reference lines, annotations, and the fan of slopes in the emptiest
// corner.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "reports/markup.hpp"
#include "reports/svg_parts.hpp"
#include "reports/svg_theme.hpp"
#include "reports/unicode.hpp"

namespace odemark::svg {
namespace {

struct Box {
  double left;
  double top;
  double right;
  double bottom;
};

// The stretch of the frame that a band covers; nothing if it lies outside.
std::optional<Box> box_of(const Band& band, const Layout& at) {
  const bool horizontal = band.direction == Direction::horizontal;
  const AxisView& view = horizontal ? at.y : at.x;
  const auto bound = [&](double value, double otherwise) {
    return view.can_place(value) ? std::clamp(view.fraction(value), 0.0, 1.0) : otherwise;
  };
  // Zero or less on a log axis lies below the frame, as minus infinity does.
  const double low = bound(band.low, 0);
  const double high = bound(band.high, band.high > 0 ? 1 : 0);
  if (std::isnan(band.low) || std::isnan(band.high) || low >= high) return {};
  if (horizontal)
    return Box{at.left, at.bottom() - high * at.plot_height, at.right(), at.bottom() - low * at.plot_height};
  return Box{at.left + low * at.plot_width, at.top, at.left + high * at.plot_width, at.bottom()};
}

// How much of the data runs through a box, by sampling every segment.
int crowding(const Chart& chart, const Layout& at, const Box& box) {
  int inside = 0;
  for (const Series& series : chart.series) {
    std::optional<Position> previous;
    for (const Point& p : series.points) {
      if (p.diverged || !at.x.can_place(p.x) || !at.y.can_place(p.y)) {
        previous.reset();
        continue;
      }
      const Position here{at.px(p.x), at.py(p.y)};
      const Position from = previous && series.style.line != Line::none ? *previous : here;
      constexpr int samples = 24;
      for (int i = 1; i <= samples; ++i) {
        const double f = static_cast<double>(i) / samples;
        const double x = from.x + f * (here.x - from.x);
        const double y = from.y + f * (here.y - from.y);
        if (x >= box.left && x <= box.right && y >= box.top && y <= box.bottom) ++inside;
      }
      previous = here;
    }
  }
  return inside;
}

// The free frame above a band on the floor (and its label, if it stands on top of the band).
double floor_of(const Chart& chart, const Layout& at) {
  double floor = at.bottom();
  for (const Band& band : chart.bands) {
    const auto box = box_of(band, at);
    if (box && band.direction == Direction::horizontal && box->bottom >= at.bottom() - 1)
      floor = std::min(floor, box->top - (box->bottom - box->top < 24 ? 20 : 0));
  }
  return floor;
}

std::string slope_text(double slope) { return fmt::format("{:g}", std::abs(slope)); }

}  // namespace

void draw_bands(std::string& out, const Chart& chart, const Layout& at) {
  for (const Band& band : chart.bands) {
    const auto box = box_of(band, at);
    if (!box) continue;
    fmt::format_to(std::back_inserter(out),
                   "<rect class=\"band\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" "
                   "fill-opacity=\"0.14\"><title>{}</title></rect>\n",
                   coordinate(box->left), coordinate(box->top), coordinate(box->right - box->left),
                   coordinate(box->bottom - box->top), theme::band, escaped(band.label));
  }
}

void draw_slope_fan(std::string& out, const Chart& chart, const Layout& at) {
  if (!chart.slopes || chart.slopes->slopes.empty()) return;
  if (at.x.scale != Scale::log10 || at.y.scale != Scale::log10)
    return;  // a power is straight only on log-log
  constexpr double margin = 12;
  constexpr double text_room = 20;
  std::vector<double> slopes = chart.slopes->slopes;
  std::sort(slopes.begin(), slopes.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const bool rising = slopes.back() > 0;
  const double per_order =
      (at.plot_height / (at.y.high - at.y.low)) / (at.plot_width / (at.x.high - at.x.low));
  const auto angle_of = [per_order](double slope) { return std::atan(std::abs(slope) * per_order); };
  // Long enough that the numbers at the tips stand apart.
  double closest = 1;
  for (std::size_t i = 1; i < slopes.size(); ++i)
    closest = std::min(closest, angle_of(slopes[i]) - angle_of(slopes[i - 1]));
  const double radius = std::clamp(13.5 / std::max(closest, 0.01) - 10, 90.0, 150.0);
  const double steepest = angle_of(slopes.back());
  const double width = std::max(radius * std::cos(angle_of(slopes.front())) + 20,
                                pixel_width(chart.slopes->label, theme::small_size));
  const double height = radius * std::sin(steepest) + 14 + text_room;

  const double floor = floor_of(chart, at);
  const double l = at.left + margin;
  const double r = at.right() - margin - width;
  const double t = at.top + margin;
  const double b = floor - margin - height;
  // Rising data leave the lower right free, falling data the upper right; the rest are second choices.
  const std::array<Position, 4> corners{
      rising ? Position{r, b} : Position{r, t}, rising ? Position{l, t} : Position{l, b},
      rising ? Position{r, t} : Position{r, b}, rising ? Position{l, b} : Position{l, t}};
  Box best{};
  int least = -1;
  for (const Position& c : corners) {
    const Box box{c.x, c.y, c.x + width, c.y + height};
    const int crowd = crowding(chart, at, box);
    if (least < 0 || crowd < least) best = box;
    if (least < 0 || crowd < least) least = crowd;
  }

  const double vx = best.left;
  const double vy = rising ? best.bottom - text_room : best.top + text_room;
  const double sign = rising ? -1 : 1;
  std::string rays;
  std::string labels;
  Position last{-1e9, -1e9};
  for (const double slope : slopes) {
    const double angle = angle_of(slope);
    const auto end = [&](double length) {
      return Position{vx + length * std::cos(angle), vy + sign * length * std::sin(angle)};
    };
    const Position tip = end(radius);
    fmt::format_to(std::back_inserter(rays), "M{},{}L{},{}", coordinate(vx), coordinate(vy),
                   coordinate(tip.x), coordinate(tip.y));
    const Position label = end(radius + 10);
    if (std::hypot(label.x - last.x, label.y - last.y) < 13) continue;
    text(labels, label.x, label.y + 5, slope_text(slope),
         {.size = theme::small_size, .anchor = Anchor::middle, .role = "muted", .halo = true});
    last = label;
  }
  fmt::format_to(std::back_inserter(out),
                 "<path class=\"guide\" d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\"/>\n", rays,
                 theme::muted);
  out += labels;
  text(out, vx, rising ? vy + 16 : vy - 8, chart.slopes->label,
       {.size = theme::small_size, .role = "muted", .halo = true});
}

void draw_labels(std::string& out, const Chart& chart, const Layout& at) {
  const TextStyle small{.size = theme::small_size, .anchor = Anchor::end, .role = "muted", .halo = true};
  for (const ReferenceLine& line : chart.lines) {
    const bool horizontal = line.direction == Direction::horizontal;
    if (!(horizontal ? at.y : at.x).shows(line.value)) continue;
    const double where = horizontal ? at.py(line.value) : at.px(line.value);
    fmt::format_to(
        std::back_inserter(out),
        "<path class=\"guide\" d=\"{}\" stroke=\"{}\" stroke-width=\"1.4\" "
        "stroke-dasharray=\"5 4\"><title>{}</title></path>\n",
        horizontal ? fmt::format("M{},{}H{}", coordinate(at.left), coordinate(where), coordinate(at.right()))
                   : fmt::format("M{},{}V{}", coordinate(where), coordinate(at.top), coordinate(at.bottom())),
        theme::muted, escaped(line.label));
    if (line.label.empty()) continue;
    if (horizontal) {
      const bool near_top = where < at.top + 22;
      text(out, at.right() - 8, near_top ? where + 16 : where - 6, line.label, small);
    } else {
      TextStyle upward = small;
      upward.upward = true;
      const bool near_right = where > at.right() - 22;
      text(out, near_right ? where - 6 : where + 16, at.top + 10, line.label, upward);
    }
  }
  for (const Band& band : chart.bands) {
    const auto box = box_of(band, at);
    if (!box || band.label.empty()) continue;
    const double height = box->bottom - box->top;
    if (band.direction == Direction::horizontal) {
      const double y = height >= 24 ? (box->top + box->bottom) / 2 + 5 : box->top - 6;
      text(out, box->right - 8, y, band.label, small);
    } else {
      TextStyle centred = small;
      centred.anchor = Anchor::middle;
      text(out, (box->left + box->right) / 2, at.bottom() - 10, band.label, centred);
    }
  }
  for (const Annotation& note : chart.annotations) {
    if (!at.x.shows(note.x) || !at.y.shows(note.y)) continue;
    text(out, at.px(note.x), at.py(note.y), note.text,
         {.size = theme::small_size, .anchor = note.anchor, .halo = true});
  }
  double leftmost = at.right() + 1;
  for (const Series& series : chart.series) {
    for (const Point& p : series.points) {
      if (p.diverged && at.x.shows(p.x)) leftmost = std::min(leftmost, at.px(p.x));
    }
  }
  if (leftmost > at.right()) return;
  const bool left_is_free = leftmost > at.left + 110;
  text(out, left_is_free ? at.left : at.right(), at.top - 9, "hollow: diverged",
       {.size = theme::small_size, .anchor = left_is_free ? Anchor::start : Anchor::end, .role = "muted"});
}

}  // namespace odemark::svg
