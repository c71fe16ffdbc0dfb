// Text made safe for SVG and HTML: escaping, ids, links, coordinates.
#include "reports/markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "reports/unicode.hpp"

namespace odemark {

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t start = i;
    const char32_t c = next_code_point(text, i);
    const bool forbidden = (c < 0x20 && c != '\n' && c != '\t' && c != '\r') || c == 0x7F || c == 0xFFFD ||
                           c == 0xFFFE || c == 0xFFFF;
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      default:
        if (forbidden) {
          out += "\xEF\xBF\xBD";
        } else {
          out += text.substr(start, i - start);
        }
    }
  }
  return out;
}

std::string safe_id(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    out += plain ? c : '-';
  }
  const bool starts_with_letter = !out.empty() && std::isalpha(static_cast<unsigned char>(out.front())) != 0;
  return starts_with_letter ? out : "x" + out;
}

bool is_safe_link(std::string_view href) {
  if (href.empty() || std::any_of(href.begin(), href.end(), [](char c) { return c >= 0 && c < 0x20; }))
    return false;
  std::string scheme(href.substr(0, href.find_first_of(":/?#")));
  if (scheme.size() == href.size() || href[scheme.size()] != ':') return true;  // relative path or anchor
  std::transform(scheme.begin(), scheme.end(), scheme.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return scheme == "http" || scheme == "https" || scheme == "mailto";
}

std::string coordinate(double pixels) {
  constexpr double far = 20000;
  const double bounded = std::isnan(pixels) ? -far : std::clamp(pixels, -far, far);
  const double tenths = std::round(bounded * 10);
  return fmt::format("{:.1f}", tenths == 0 ? 0.0 : tenths / 10);
}

}  // namespace odemark
