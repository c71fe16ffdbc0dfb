// A strip of cloth, pinned along one edge and let go: masses, springs and shear springs in three dimensions.
#pragma once
#include <algorithm>

#include "problems/family.hpp"
#include "problems/numbered.hpp"

namespace odemark {

/// State (x1 .. x8, y1 .. y8, z1 .. z8 and their rates): four rows of two nodes below the pinned one. Starts
/// flat along x with one corner thrown up.
template <class Real = double>
struct ClothStrip {
  static constexpr std::string_view id = "cloth_strip";
  static constexpr std::string_view title = "Strip of cloth";
  static constexpr std::string_view equations =
      "m ri'' = -m g e_z - sum over springs of k (|d| - l) d/|d|,  d = ri - rj, l = side or sqrt(2) side";
  static constexpr std::string_view source =
      "X. Provot, Graphics Interface (1995) 147-154; structural and shear springs, no bending, no damping";
  static constexpr std::size_t columns = 2, rows = 4, nodes = rows * columns, size = 6 * nodes;
  static constexpr auto components =
      joined(numbered<"x", nodes>("m"), numbered<"y", nodes>("m"), numbered<"z", nodes>("m"),
             numbered<"vx", nodes>("m/s"), numbered<"vy", nodes>("m/s"), numbered<"vz", nodes>("m/s"));
  static constexpr std::array<std::string_view, 1> invariant_names{"energy"};
  static constexpr bool force_depends_on_velocity = false;

  Real m = Real(1) / 64, k = 256, shear = 64, side = Real(1) / 8, g = Real(157) / 16, thrown = 2,
       t_end = Real(1) / 4;

  static constexpr auto parameters() {
    using P = Parameter<ClothStrip, Real>;
    return std::array{P{"m", "kg", "mass of a node", &ClothStrip::m, positive},
                      P{"k", "N/m", "stiffness along the threads", &ClothStrip::k, positive},
                      P{"shear", "N/m", "stiffness along the diagonals", &ClothStrip::shear, not_negative},
                      P{"side", "m", "distance of nodes", &ClothStrip::side, positive},
                      P{"g", "m/s^2", "gravity", &ClothStrip::g, not_negative},
                      P{"thrown", "m/s", "initial speed upwards of the last corner", &ClothStrip::thrown},
                      P{"t_end", "s", "end of the interval", &ClothStrip::t_end, positive}};
  }
  static constexpr std::array presets{
      Preset{"cloth_strip", "", "falls, swings and twists for a quarter of a second"}};

  std::array<double, size> scale() const {
    const double length = double(side) * rows,
                 v = std::max(std::sqrt(double(g) * length), std::abs(double(thrown)));
    std::array<double, size> all;
    for (std::size_t i = 0; i < size; ++i) all[i] = i < size / 2 ? length : v;
    return all;
  }
  double suggested_dt() const { return 0.03125 * std::sqrt(double(m) / double(k)); }

  template <class T>
  void initial(T* y) const {
    for (std::size_t i = 0; i < size; ++i) y[i] = T(0);
    for (std::size_t i = 0; i < nodes; ++i) {
      y[i] = T(side) * T(int(i / columns + 1));
      y[nodes + i] = T(side) * T(int(i % columns));
    }
    y[6 * nodes - 1] = T(thrown);
  }
  template <class T>
  void acceleration(const T&, const T* y, T* a) const {
    using std::sqrt;
    for (std::size_t i = 0; i < 2 * nodes; ++i) a[i] = T(0);
    for (std::size_t i = 2 * nodes; i < 3 * nodes; ++i) a[i] = -T(g);
    for_each_spring(
        y, [&](std::size_t here, std::size_t there, const T* d, const T& stiffness, const T& length) {
          const T pull = stiffness / T(m) * (length / sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - 1);
          for (std::size_t axis = 0; axis < 3; ++axis) {
            a[axis * nodes + here] += pull * d[axis];
            if (there < nodes) a[axis * nodes + there] -= pull * d[axis];
          }
        });
  }
  template <class T>
  void rhs(const T& t, const T* y, T* dydt) const {
    for (std::size_t i = 0; i < size / 2; ++i) dydt[i] = y[i + size / 2];
    acceleration(t, y, dydt + size / 2);
  }
  template <class T>
  void invariants(const T* y, T* out) const {
    using std::sqrt;
    T energy = T(0);
    for (std::size_t i = 0; i < nodes; ++i) energy += T(m) * T(g) * y[2 * nodes + i];
    for (std::size_t i = size / 2; i < size; ++i) energy += T(m) * y[i] * y[i] / 2;
    for_each_spring(y, [&](std::size_t, std::size_t, const T* d, const T& stiffness, const T& length) {
      const T stretch = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - length;
      energy += stiffness * stretch * stretch / 2;
    });
    out[0] = energy;
  }

 private:
  /// visit(node, other node or `nodes` for a pin, vector from there to here, stiffness, length) for every
  /// spring.
  template <class T, class Visit>
  void for_each_spring(const T* y, Visit&& visit) const {
    using std::sqrt;
    const T diagonal = T(side) * sqrt(T(2));
    const auto link = [&](std::size_t here, std::size_t row, std::size_t column, const T& stiffness,
                          const T& length) {
      T d[3];
      if (row == 0) {  // pinned at x = 0
        d[0] = y[here], d[1] = y[nodes + here] - T(side) * T(int(column)), d[2] = y[2 * nodes + here];
        visit(here, std::size_t(nodes), d, stiffness, length);
        return;
      }
      const std::size_t there = (row - 1) * columns + column;
      for (std::size_t axis = 0; axis < 3; ++axis) d[axis] = y[axis * nodes + here] - y[axis * nodes + there];
      visit(here, there, d, stiffness, length);
    };
    for (std::size_t row = 1; row <= rows; ++row)
      for (std::size_t column = 0; column < columns; ++column) {
        const std::size_t here = (row - 1) * columns + column;
        link(here, row - 1, column, T(k), T(side));
        if (column > 0)
          link(here, row, column - 1, T(k), T(side)), link(here, row - 1, column - 1, T(shear), diagonal);
        if (column + 1 < columns) link(here, row - 1, column + 1, T(shear), diagonal);
      }
  }
};

}  // namespace odemark
