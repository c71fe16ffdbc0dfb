// Decoding UTF-8 and knowing how wide text is, in console columns and in pixels.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace odemark {

// Decodes one code point and advances; an invalid byte yields U+FFFD and advances by one.
char32_t next_code_point(std::string_view text, std::size_t& position);

int column_width(std::string_view text);  // combining marks 0, East Asian wide and emoji 2, all else 1

// An upper estimate for common sans-serif fonts: no metrics are at hand, and clipped text is worse than a
// gap.
double pixel_width(std::string_view text, double font_size);

// Breaks at spaces; a longer word keeps a line of its own.
std::vector<std::string> wrapped(std::string_view text, double font_size, double width);

}  // namespace odemark
