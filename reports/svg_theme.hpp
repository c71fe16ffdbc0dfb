// Sizes and neutral colours shared by all parts of a picture; series colours are in palette.hpp.
#pragma once

#include <string_view>

namespace odemark::theme {

// A view 600 wide shown at 390 px (a phone) scales 16 to 10.4 px: still readable.
inline constexpr double view_width = 600;
inline constexpr double plot_height = 360;
inline constexpr double title_size = 20;
inline constexpr double text_size = 16;
inline constexpr double small_size = 14.5;
inline constexpr double exponent_size = 12.5;

inline constexpr std::string_view font =
    "system-ui,-apple-system,'Segoe UI',Roboto,'Helvetica Neue',Arial,sans-serif";

inline constexpr std::string_view paper = "#ffffff";
inline constexpr std::string_view ink = "#1b1f24";
inline constexpr std::string_view muted = "#57606a";
inline constexpr std::string_view grid = "#e7eaee";
inline constexpr std::string_view axis = "#8c959f";
inline constexpr std::string_view zero = "#c3c9d0";
inline constexpr std::string_view band = "#6e7781";

inline constexpr std::string_view dark_paper = "#0f1318";
inline constexpr std::string_view dark_ink = "#e8ecf1";
inline constexpr std::string_view dark_muted = "#a0a9b4";
inline constexpr std::string_view dark_grid = "#242a32";
inline constexpr std::string_view dark_axis = "#66707c";
inline constexpr std::string_view dark_zero = "#414a55";
inline constexpr std::string_view dark_band = "#aab4c0";

}  // namespace odemark::theme
