// The data itself: regions, lines, markers, and the hollow markers of diverged points on the top frame.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

#include "reports/format.hpp"
#include "reports/markup.hpp"
#include "reports/palette.hpp"
#include "reports/svg_parts.hpp"
#include "reports/svg_theme.hpp"

namespace odemark::svg {
namespace {

std::string axis_text(const Axis& axis, const char* fallback, double value) {
  return fmt::format("{}: {}", axis.label.empty() ? fallback : axis.label, compact(value, 5));
}

std::string hover(const Chart& chart, const Series& series, const Point& p) {
  std::string text = series.label + "\n" + axis_text(chart.x, "x", p.x) + "\n";
  text += p.diverged ? "diverged" : axis_text(chart.y, "y", p.y);
  if (!p.note.empty()) text += "\n" + p.note;
  return escaped(text);
}

// A gap for whatever cannot be placed; a point alone between gaps becomes a dot through its round cap.
std::string line_path(const Series& series, const Layout& at) {
  std::string path;
  std::size_t run = 0;
  const auto finish_run = [&] {
    if (run == 1) path += "h0";
    run = 0;
  };
  for (const Point& p : series.points) {
    if (p.diverged || !at.x.can_place(p.x) || !at.y.can_place(p.y)) {
      finish_run();
      continue;
    }
    fmt::format_to(std::back_inserter(path), "{}{},{}", run == 0 ? 'M' : 'L', coordinate(at.px(p.x)),
                   coordinate(at.py(p.y)));
    ++run;
  }
  finish_run();
  return path;
}

void put_marker(std::string& out, std::string_view prefix, Marker marker, double x, double y,
                const std::string& title) {
  fmt::format_to(std::back_inserter(out), "<use href=\"#{}-m{}\" x=\"{}\" y=\"{}\"><title>{}</title></use>\n",
                 prefix, static_cast<int>(marker), coordinate(x), coordinate(y), title);
}

// Attributes of a marker group. Filled markers get a thin paper outline that separates overlapping ones.
void open_markers(std::string& out, bool filled) {
  if (filled) {
    fmt::format_to(std::back_inserter(out),
                   "<g class=\"halo\" fill=\"currentColor\" stroke=\"{}\" stroke-width=\"0.8\">\n",
                   theme::paper);
  } else {
    fmt::format_to(std::back_inserter(out),
                   "<g class=\"paper\" fill=\"{}\" stroke=\"currentColor\" stroke-width=\"2\">\n",
                   theme::paper);
  }
}

// Diverged points that share a place on the frame stand side by side.
class FrameSeats {
 public:
  FrameSeats(const Chart& chart, const Layout& at) : at_(at) {
    for (const Series& series : chart.series) {
      for (const Point& p : series.points) {
        if (p.diverged && at.x.shows(p.x)) ++wanted_[place(p.x)];
      }
    }
  }

  double next(double x) {
    const double number = taken_[place(x)]++;
    return at_.px(x) + spacing * (number - (wanted_[place(x)] - 1) / 2.0);
  }

 private:
  static constexpr double spacing = 12;
  long place(double x) const { return std::lround(at_.px(x) / spacing); }

  const Layout& at_;
  std::map<long, int> wanted_;
  std::map<long, int> taken_;
};

}  // namespace

std::string colour_attributes(const Style& style) {
  const int count = theme_colour_count();
  return fmt::format("class=\"c{}\" color=\"{}\"", ((style.colour % count) + count) % count,
                     theme_colour(style.colour).light);
}

std::string stroke_attributes(const Style& style, double width) {
  std::string out = fmt::format(
      "fill=\"none\" stroke=\"currentColor\" stroke-width=\"{}\" stroke-linejoin=\"round\" "
      "stroke-linecap=\"round\"",
      width);
  if (style.line == Line::dashed) out += " stroke-dasharray=\"8 5\"";
  if (style.line == Line::dotted) out += " stroke-dasharray=\"1.5 5\"";
  return out;
}

std::string_view marker_path(Marker marker) {
  constexpr std::array paths{
      "",
      "M5,0A5,5 0 1 1 -5,0A5,5 0 1 1 5,0Z",
      "M-4.5,-4.5H4.5V4.5H-4.5Z",
      "M0,-6.2L5.7,4.2H-5.7Z",
      "M0,-6.3L5.6,0L0,6.3L-5.6,0Z",
      "M0,6.2L5.7,-4.2H-5.7Z",
      "M-5.6,-3.4L-3.4,-5.6L0,-2.2L3.4,-5.6L5.6,-3.4L2.2,0L5.6,3.4L3.4,5.6L0,2.2L-3.4,5.6L"
      "-5.6,3.4L-2.2,0Z",
      "M-1.7,-6H1.7V-1.7H6V1.7H1.7V6H-1.7V1.7H-6V-1.7H-1.7Z",
      "M0,-7L1.9,-2.4L6.7,-2.2L2.9,0.9L4.1,5.7L0,3L-4.1,5.7L-2.9,0.9L-6.7,-2.2L-1.9,-2.4Z",
      "M6.2,0L-4.2,5.7V-5.7Z",
      "M-5,-5.6H5L-5,5.6H5Z"};
  return paths[static_cast<std::size_t>(marker)];
}

void swatch(std::string& out, const Style& style, bool is_region, double x, double y) {
  fmt::format_to(std::back_inserter(out), "<g {} transform=\"translate({} {})\">", colour_attributes(style),
                 coordinate(x), coordinate(y));
  if (is_region) {
    fmt::format_to(std::back_inserter(out),
                   "<path d=\"M4,-6H28V6H4Z\" {}/><path d=\"M4,-6H28V6H4Z\" fill=\"currentColor\" "
                   "fill-opacity=\"0.14\"/>",
                   stroke_attributes(style, 2));
  } else {
    if (style.line != Line::none)
      fmt::format_to(std::back_inserter(out), "<path d=\"M2,0H30\" {}/>", stroke_attributes(style, 2.2));
    if (style.marker != Marker::none) {
      open_markers(out, style.filled);
      fmt::format_to(std::back_inserter(out), "<path transform=\"translate(16 0)\" d=\"{}\"/></g>",
                     marker_path(style.marker));
    }
  }
  out += "</g>";
}

void draw_regions(std::string& out, const Chart& chart, const Layout& at, std::string_view prefix) {
  for (const Region& region : chart.regions) {
    std::string path;
    for (const auto& outline : region.outlines) {
      bool started = false;
      for (const Position& p : outline) {
        if (!at.x.can_place(p.x) || !at.y.can_place(p.y))
          continue;  // the outline closes over the missing corner
        fmt::format_to(std::back_inserter(path), "{}{},{}", started ? 'L' : 'M', coordinate(at.px(p.x)),
                       coordinate(at.py(p.y)));
        started = true;
      }
      if (started) path += 'Z';
    }
    fmt::format_to(std::back_inserter(out),
                   "<g {0} data-series=\"{1}\" clip-path=\"url(#{2}-clip)\"><title>{3}</title>"
                   "<path d=\"{4}\" fill=\"currentColor\" fill-opacity=\"0.09\" fill-rule=\"evenodd\"/>"
                   "<path d=\"{4}\" {5}/></g>\n",
                   colour_attributes(region.style), escaped(region.id), prefix, escaped(region.label), path,
                   stroke_attributes(region.style, 2));
  }
}

void draw_series(std::string& out, const Chart& chart, const Layout& at, std::string_view prefix) {
  FrameSeats seats(chart, at);
  for (const Series& series : chart.series) {
    const Style& style = series.style;
    fmt::format_to(std::back_inserter(out), "<g {} data-series=\"{}\"><title>{}</title>\n",
                   colour_attributes(style), escaped(series.id), escaped(series.label));
    const std::string path = style.line == Line::none ? "" : line_path(series, at);
    if (!path.empty())
      fmt::format_to(std::back_inserter(out), "<path d=\"{}\" {} clip-path=\"url(#{}-clip)\"/>\n", path,
                     stroke_attributes(style, 2), prefix);
    std::string marks;
    std::string diverged;
    for (const Point& p : series.points) {
      if (!at.x.shows(p.x)) continue;
      if (p.diverged) {
        const Marker shape = style.marker == Marker::none ? Marker::circle : style.marker;
        fmt::format_to(std::back_inserter(diverged),
                       "<path transform=\"translate({} {})\" d=\"{}\"><title>{}</title></path>\n",
                       coordinate(seats.next(p.x)), coordinate(at.top), marker_path(shape),
                       hover(chart, series, p));
      } else if (style.marker != Marker::none && at.y.shows(p.y)) {
        put_marker(marks, prefix, style.marker, at.px(p.x), at.py(p.y), hover(chart, series, p));
      }
    }
    if (!marks.empty()) {
      open_markers(out, style.filled);
      out += marks + "</g>\n";
    }
    if (!diverged.empty()) {
      open_markers(out, false);
      out += diverged + "</g>\n";
    }
    out += "</g>\n";
  }
}

}  // namespace odemark::svg
