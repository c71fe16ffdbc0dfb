// Numbers as people read them. What is not finite prints as the dash no_value, never as "nan".
#pragma once

#include <string>
#include <string_view>

namespace odemark {

inline constexpr std::string_view no_value = "–";

std::string scientific(double x, int digits);   // 1.23e-05
std::string engineering(double x, int digits);  // 12.3e-06: the exponent is a multiple of three
std::string significant(double x, int digits);  // 0.0123; scientific beyond 1e-4 .. 1e6
std::string compact(double x, int digits);      // the same without trailing zeros: 0.5, 40, 1e-12
std::string percent(double fraction, int digits);
std::string duration(double seconds, int digits = 3);  // 12.3 ns, 4.56 µs, 7.89 ms, 1.23 s
std::string power_of_ten(int exponent);                // 10⁻⁸

// A difference that the measurement cannot tell from nothing prints as "0 within 1e-16".
std::string within_resolution(double x, double resolution, int digits);

}  // namespace odemark
