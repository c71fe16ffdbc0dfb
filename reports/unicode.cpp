// Decoding UTF-8 and knowing how wide text is, in console columns and in pixels.
#include "reports/unicode.hpp"

#include <algorithm>
#include <array>

namespace odemark {
namespace {

constexpr char32_t replacement = 0xFFFD;

struct Span {
  char32_t first;
  char32_t last;
};

constexpr std::array zero_width{Span{0x0300, 0x036F}, Span{0x1AB0, 0x1AFF}, Span{0x1DC0, 0x1DFF},
                                Span{0x200B, 0x200F}, Span{0x20D0, 0x20FF}, Span{0xFE00, 0xFE0F},
                                Span{0xFE20, 0xFE2F}, Span{0xFEFF, 0xFEFF}};
constexpr std::array double_width{Span{0x1100, 0x115F},   Span{0x2E80, 0x303E},   Span{0x3041, 0xA4CF},
                                  Span{0xAC00, 0xD7A3},   Span{0xF900, 0xFAFF},   Span{0xFE30, 0xFE6F},
                                  Span{0xFF00, 0xFF60},   Span{0xFFE0, 0xFFE6},   Span{0x1F300, 0x1F64F},
                                  Span{0x1F680, 0x1F6FF}, Span{0x1F900, 0x1F9FF}, Span{0x20000, 0x3FFFD}};

template <std::size_t N>
bool within(const std::array<Span, N>& spans, char32_t c) {
  return std::any_of(spans.begin(), spans.end(), [c](Span s) { return c >= s.first && c <= s.last; });
}

int columns_of(char32_t c) {
  if (within(zero_width, c)) return 0;
  return within(double_width, c) ? 2 : 1;
}

double ems_of(char32_t c) {
  constexpr std::u32string_view thin = U"iljtfrI.,:;'|!()[]/ -·";
  constexpr std::u32string_view broad = U"mwMWQOGDHNU@%&=+<>~−≤≥×";
  if (thin.find(c) != thin.npos) return 0.39;
  if (broad.find(c) != broad.npos) return 0.84;
  return c < 0x2020 ? 0.62 : 0.7 * columns_of(c);
}

}  // namespace

char32_t next_code_point(std::string_view text, std::size_t& position) {
  const auto byte_at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte_at(position++);
  if (lead < 0x80) return lead;
  const std::size_t extra = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
  if (lead < 0xC2 || lead > 0xF4 || position + extra > text.size()) return replacement;
  char32_t code = lead & (0x3Fu >> extra);
  for (std::size_t i = 0; i < extra; ++i) {
    if ((byte_at(position + i) & 0xC0) != 0x80) return replacement;
    code = (code << 6) | (byte_at(position + i) & 0x3Fu);
  }
  constexpr std::array<char32_t, 4> smallest{0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < smallest[extra] || code > 0x10FFFF || surrogate) return replacement;
  position += extra;
  return code;
}

int column_width(std::string_view text) {
  int columns = 0;
  for (std::size_t i = 0; i < text.size();) columns += columns_of(next_code_point(text, i));
  return columns;
}

double pixel_width(std::string_view text, double font_size) {
  double ems = 0;
  for (std::size_t i = 0; i < text.size();) ems += ems_of(next_code_point(text, i));
  return ems * font_size;
}

std::vector<std::string> wrapped(std::string_view text, double font_size, double width) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n\t", start), text.size());
    const std::string_view word = text.substr(start, end - start);
    start = end + 1;
    if (word.empty()) continue;
    std::string longer = line.empty() ? std::string(word) : line + ' ' + std::string(word);
    if (!line.empty() && pixel_width(longer, font_size) > width) {
      lines.push_back(line);
      longer = word;
    }
    line = longer;
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace odemark
