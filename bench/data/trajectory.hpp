// One component of one run over time. Plain data.
#pragma once

#include <string>
#include <vector>

namespace odemark {

struct Trajectory {
  std::string problem{};  // id, with what was set: "drag_ship{t_end=60}"
  std::string method{};   // id of the catalogue, or "exact" for the closed form
  std::string scalar = "double";
  std::string component{}, unit{};  // "v", "m/s"
  double dt = 0;                    // s; 0 for a closed form
  std::vector<double> t{}, value{};
};

}  // namespace odemark
