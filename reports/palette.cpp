// Stable looks: colour by family, marker by method, both from one explicit list, never from the alphabet.
#include "reports/palette.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace odemark {
namespace {

// Ten hues told apart with any common colour blindness, at least 3:1 against white (light) or #0f1318 (dark).
// After Okabe and Ito, "Color Universal Design" (2008), darkened or lightened to reach that contrast.
constexpr std::array<ThemeColour, 10> theme{{{"#0069a8", "#5ab4f0"},
                                             {"#d55e00", "#ff8a3d"},
                                             {"#00876a", "#2fc9a0"},
                                             {"#b0478a", "#e58cc4"},
                                             {"#3d4450", "#c3cad4"},
                                             {"#b07d00", "#e8b830"},
                                             {"#5b3fb0", "#a794f5"},
                                             {"#2494cc", "#8fd8f8"},
                                             {"#8a1f3d", "#f27a93"},
                                             {"#6f7a12", "#c2cc5a"}}};

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
  return {.colour = static_cast<int>(family % theme.size()),
          .marker = marker,
          .line = cycles[(family / theme.size()) % cycles.size()],
          .filled = (member / markers.size()) % 2 == 0};
}

}  // namespace

int theme_colour_count() { return static_cast<int>(theme.size()); }

ThemeColour theme_colour(int index) {
  const int count = theme_colour_count();
  return theme[static_cast<std::size_t>(((index % count) + count) % count)];
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
