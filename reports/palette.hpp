// Stable looks: colour by family, marker by method, both from one explicit list, never from the alphabet.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reports/chart.hpp"

namespace odemark {

struct ThemeColour {
  std::string_view light;
  std::string_view dark;
};

int theme_colour_count();
ThemeColour theme_colour(int index);  // taken modulo the count

struct PaletteMember {
  std::string id;
  std::string family;
};

// Give every chart of a report the same list (the catalogue's order), however few of its methods a chart
// shows.
class Palette {
 public:
  explicit Palette(const std::vector<PaletteMember>& in_order);

  // Throws std::invalid_argument for an id that the list lacks: a silent default would look like another
  // method.
  Style style_of(std::string_view id) const;

 private:
  std::map<std::string, Style, std::less<>> styles_;
};

}  // namespace odemark
