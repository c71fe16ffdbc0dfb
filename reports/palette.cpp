// Stable looks: colour by family, marker by method, both from one explicit list, never from the alphabet.
#include "reports/palette.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace odemark {
namespace {

// Ten hues found by search: at least 3:1 against white (light) and 4.5:1 against #0f1318 (dark), and any two
// at least 22 CIELAB units apart for normal, protanopic and deuteranopic sight (simulated after Viénot,
// Brettel and Mollon, Color Research and Application 24, 1999). The first six are further apart than the
// rest. Markers carry the rest.
constexpr std::array<ThemeColour, 10> theme_colours{{{"#0d96f5", "#5ea7ff"},
                                                     {"#9c2900", "#e64f03"},
                                                     {"#26a48c", "#96f9b2"},
                                                     {"#782283", "#b56980"},
                                                     {"#563142", "#c4edff"},
                                                     {"#c78700", "#ffdf00"},
                                                     {"#373cd7", "#4b7af7"},
                                                     {"#3d9ebd", "#00aece"},
                                                     {"#954c45", "#e4705c"},
                                                     {"#ab904d", "#ddee73"}}};

constexpr std::array markers{
    Marker::circle, Marker::square, Marker::triangle_up,    Marker::diamond, Marker::triangle_down,
    Marker::cross,  Marker::star,   Marker::triangle_right, Marker::plus,    Marker::hourglass};

struct FamilySeat {
  std::size_t index;
  std::size_t members = 0;
};

Style nth_style(std::size_t family, std::size_t member) {
  // Families start at different markers (3 and 10 are coprime), so a "best of family" chart is readable in
  // grey.
  const Marker marker = markers[(3 * family + member) % markers.size()];
  constexpr std::array cycles{Line::solid, Line::dashed, Line::dotted};
  return {.colour = static_cast<int>(family % theme_colours.size()),
          .marker = marker,
          .line = cycles[(family / theme_colours.size()) % cycles.size()],
          .filled = (member / markers.size()) % 2 == 0};
}

}  // namespace

int theme_colour_count() { return static_cast<int>(theme_colours.size()); }

ThemeColour theme_colour(int index) {
  const int count = theme_colour_count();
  return theme_colours[static_cast<std::size_t>(((index % count) + count) % count)];
}

Palette::Palette(const std::vector<PaletteMember>& in_order) {
  std::map<std::string, FamilySeat> families;
  for (const PaletteMember& member : in_order) {
    if (styles_.contains(member.id)) continue;  // the first mention decides
    FamilySeat& seat = families.try_emplace(member.family, FamilySeat{families.size()}).first->second;
    styles_.emplace(member.id, nth_style(seat.index, seat.members++));
  }
}

Style Palette::style_of(std::string_view id) const {
  const auto found = styles_.find(id);
  if (found == styles_.end()) throw std::invalid_argument(fmt::format("the palette does not list '{}'", id));
  return found->second;
}

}  // namespace odemark
