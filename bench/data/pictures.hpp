// What a report shows beside rows: who the methods and problems are, and things to look at. Plain data,
// computed by bench/pictures.cpp.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "bench/data/region.hpp"
#include "bench/data/settling.hpp"
#include "bench/data/trajectory.hpp"

namespace odemark {

struct MethodCard {
  std::string id, kind, provider, source;
  std::string starter, note;  // of a multistep method; what a reader of its rows must know
  int order = 0;
};

struct ProblemCard {
  std::string id, family, title, equations, about, source;
  std::vector<std::string> parameters;  // "k = 1 N/m"
  double t_end = 0, suggested_dt = 0;   // s
  bool in_seconds = false;              // a component has a unit per second: frames per second mean something
  std::string truth;                    // where the right answer comes from, in words; or why there is none
};

/// What one problem does over time. Curves of one component each, or two of a plane.
struct Scene {
  std::string problem;
  std::string x, y;               // components; x is empty where y is drawn over time
  std::vector<Trajectory> exact;  // of y, or of x and y: see `exact_is`
  std::string exact_is;           // how the drawn line was made, and how far it is from the certified values
  struct Run {
    std::string method, status;
    double dt = 0;
    Trajectory y;
    std::optional<Trajectory> x;
  };
  std::vector<Run> runs;
};

/// Regions that are looked at through the same window.
struct RegionGroup {
  std::string id, title;
  std::vector<StabilityRegion> regions;
};

/// |R(z)| of one method at Pictures::damping_at: what is left of a mode after one step.
struct Damping {
  std::string method, reason;  // no numbers: see `reason`
  std::vector<double> amplification;
};

struct Pictures {
  std::vector<MethodCard> methods;    // every method of the registry, in its order
  std::vector<ProblemCard> problems;  // those of the rows
  std::vector<Scene> scenes;
  std::vector<RegionGroup> regions;
  std::vector<std::complex<double>> damping_at;
  std::vector<Damping> damping;
  std::vector<Settling> settling;  // only where rows look at single steps
};

}  // namespace odemark
