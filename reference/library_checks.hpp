// Known defects of third-party libraries, measured on the ones this binary is linked with (odemark doctor).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace odemark {

struct LibraryCheck {
  std::string_view id, provider;
  bool applies = false;                   // the library at hand has the defect
  std::string measured;                   // what was seen, in one line
  std::vector<std::string_view> affects;  // methods whose rows need the footnote where it applies
  std::string_view footnote;
};

/// Every check of every provider that was compiled in. Takes a fraction of a second.
std::vector<LibraryCheck> library_checks();

}  // namespace odemark
