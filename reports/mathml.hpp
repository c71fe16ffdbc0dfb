// Equations as they stand in the catalogue, "x'' = -(k/m) x;  v' = a/b", for a browser to set.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace odemark {

/// A <math> element with one row for every equation between semicolons; well-formed whatever the text. A word
/// of three letters and more that is neither one of `names` (what components and parameters are called) nor a
/// function or a Greek letter is set as text.
std::string to_mathml(std::string_view equations, const std::vector<std::string>& names);

}  // namespace odemark
