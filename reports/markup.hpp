// Text made safe for SVG and HTML: escaping, ids, links, coordinates.
#pragma once

#include <string>
#include <string_view>

namespace odemark {

// Valid in XML and HTML, in text and in quoted attributes. Characters that XML forbids become U+FFFD.
std::string escaped(std::string_view text);

// Letters, digits, - and _ only, starting with a letter; never empty.
std::string safe_id(std::string_view text);

// True for #anchors, relative paths, http, https, mailto; a script URL must not become a link.
bool is_safe_link(std::string_view href);

// One decimal, never "-0.0", never nan: far-off values are clamped so that viewers do not overflow.
std::string coordinate(double pixels);

}  // namespace odemark
