// Right-hand sides that change their form at t = 1, 2, 3, ...
#pragma once
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace odemark {

/// Which piece a time lies in: the one that is held, or what the clock says. At a switch the next one has
/// begun.
struct UnitPieces {
  int held = -1;

  template <class T>
  int at(const T& t) const {
    if (held >= 0) return held;
    if constexpr (std::is_floating_point_v<T>) {
      return t < T(1) ? 0 : t < T(1e6) ? int(t) : 1'000'000;
    } else if constexpr (requires { bool(t < T(1)); }) {
      int piece = 0;
      while (piece < 1'000'000 && !(t < T(piece + 1))) ++piece;
      return piece;
    } else {
      throw std::logic_error("a switch in time cannot be recorded: stop there and use during(phase)");
    }
  }
  static std::vector<double> switches_before(double end) {
    std::vector<double> times;
    for (double t = 1; t < end; t += 1) times.push_back(t);
    return times;
  }
};

}  // namespace odemark
