// What is known of one family of problems before anybody is timed on it. Plain data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/data/pictures.hpp"

namespace odemark {

struct SheetParameter {
  std::string name, unit, meaning, range;
  double value = 0;        // of the first preset
  bool shorthand = false;  // sets others; has no value of its own
};

/// Largest stable dt of a method along the trajectory, from the eigenvalues of the Jacobian there.
struct SheetLimit {
  std::string method;
  std::optional<double> dt;  // absent: no limit
};

struct SheetPreset {
  std::string id, settings, about;
  double t_end = 0, suggested_dt = 0;
  // truth
  int digits = 0;  // certified, of the worst component at the worst of the stored times; 0: see `origin`
  std::string origin, checked_by;
  double sensitivity = 0;
  long events = 0;
  // eigenvalues of the Jacobian along the solution, 1/s
  double fastest_decay = 0, fastest_growth = 0, fastest_turn = 0;
  std::optional<double> stiffness_ratio;  // fastest over slowest decay; absent without two that decay
  std::vector<SheetLimit> limits;
};

struct ProblemSheet {
  std::string id, title, equations, source;
  std::vector<std::pair<std::string, std::string>> components;  // name, unit
  std::vector<SheetParameter> parameters;
  std::vector<std::string> invariants, events, offers;  // offers: "Jacobian by hand", "closed form"
  std::vector<SheetPreset> presets;
  std::optional<Scene> scene;  // of the first preset
};

}  // namespace odemark
