// Stability regions by marching squares, with every crossing of a square's side bisected on R itself.
#include "bench/stability_region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "integrators/linear_stability_parts.hpp"

namespace odemark {

namespace {

using Point = std::complex<double>;

/// Corners carry a verdict; the ring outside the window counts as unstable, so that every polygon closes.
class Squares {
 public:
  Squares(const Theory& theory, const RegionWindow& window, int cells)
      : theory_(theory), window_(window), cells_(cells), side_(cells + 3) {
    verdict_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), false);
    for (int row = 0; row <= cells; ++row)
      for (int column = 0; column <= cells; ++column)
        verdict_[index(column, row)] = stable(corner(column, row));
  }

  std::vector<std::vector<Point>> polygons() {
    for (int row = -1; row <= cells_; ++row)
      for (int column = -1; column <= cells_; ++column) visit(column, row);
    std::vector<std::vector<Point>> out;
    while (!next_.empty()) {
      std::vector<Point> polygon;
      for (auto link = next_.begin(); link != next_.end(); link = next_.find(polygon_end_)) {
        polygon.push_back(crossing(link->first));
        polygon_end_ = link->second;
        next_.erase(link);
      }
      if (polygon.size() > 2) out.push_back(std::move(polygon));
    }
    return out;
  }

 private:
  using Edge = std::pair<std::size_t, std::size_t>;  // indices of a stable and an unstable corner

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row + 1) * static_cast<std::size_t>(side_) +
           static_cast<std::size_t>(column + 1);
  }
  /// Corners of the ring lie on the window's edge.
  Point corner(int column, int row) const {
    const auto part = [this](int i) { return double(std::clamp(i, 0, cells_)) / cells_; };
    return {window_.re_min + (window_.re_max - window_.re_min) * part(column),
            window_.im_min + (window_.im_max - window_.im_min) * part(row)};
  }
  Point corner(std::size_t i) const {
    return corner(int(i % static_cast<std::size_t>(side_)) - 1, int(i / static_cast<std::size_t>(side_)) - 1);
  }
  bool stable(Point z) const { return amplification(theory_, WideComplex(z.real(), z.imag())) <= 1 + 1e-13L; }

  /// Links the crossings of one square, stable corners on the left hand.
  void visit(int column, int row) {
    const std::size_t c[4] = {index(column, row), index(column + 1, row), index(column + 1, row + 1),
                              index(column, row + 1)};
    std::vector<std::pair<bool, Edge>> found;  // counter-clockwise; true: from stable to unstable
    for (int i = 0; i < 4; ++i) {
      const std::size_t from = c[i], to = c[(i + 1) % 4];
      if (verdict_[from] != verdict_[to])
        found.emplace_back(verdict_[from], verdict_[from] ? Edge{from, to} : Edge{to, from});
    }
    // The line enters where the square's outline leaves the stable corners and ends where it comes back to
    // them. With two stable corners across, the middle says whether they hang together.
    const bool joined = found.size() == 4 && stable((corner(c[0]) + corner(c[2])) / 2.0);
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i].first) {
        const std::size_t n = found.size();
        next_[found[i].second] = found[(i + (joined ? 1 : n - 1)) % n].second;
      }
  }

  Point crossing(const Edge& edge) const {
    Point in = corner(edge.first), out = corner(edge.second);
    for (int i = 0; i < 48 && in != out; ++i) {
      const Point middle = (in + out) / 2.0;
      (stable(middle) ? in : out) = middle;
    }
    return in;
  }

  const Theory& theory_;
  const RegionWindow window_;
  const int cells_, side_;
  std::vector<bool> verdict_;
  std::map<Edge, Edge> next_;
  Edge polygon_end_;
};

/// A curve for every z that belongs to a point of the circle; which of two is the next piece of which curve
/// is told by nearness.
std::vector<std::vector<Point>> locus(const Theory& theory, const RegionWindow& window) {
  constexpr int points = 720;
  const double far = 4 * std::max(window.re_max - window.re_min, window.im_max - window.im_min);
  std::vector<std::vector<Point>> pieces;
  std::vector<Point> before;
  std::vector<std::size_t> piece_of;  // of every curve; none yet or none any more: npos
  constexpr std::size_t npos = std::numeric_limits<std::size_t>::max();
  for (int i = 0; i < points; ++i) {
    std::vector<Point> now;
    for (const auto& z : root_locus(theory, Coefficient(i) * 2 * std::numbers::pi_v<Coefficient> / points))
      now.emplace_back(double(z.real()), double(z.imag()));
    if (now.size() == 2 && before.size() == 2 &&
        std::abs(now[0] - before[0]) + std::abs(now[1] - before[1]) >
            std::abs(now[0] - before[1]) + std::abs(now[1] - before[0]))
      std::swap(now[0], now[1]);
    piece_of.resize(now.size(), npos);
    for (std::size_t curve = 0; curve < now.size(); ++curve) {
      if (!(std::abs(now[curve]) < far)) {
        piece_of[curve] = npos;
        continue;
      }
      if (piece_of[curve] == npos) {
        piece_of[curve] = pieces.size();
        pieces.emplace_back();
      }
      pieces[piece_of[curve]].push_back(now[curve]);
    }
    before = now;
  }
  return pieces;
}

}  // namespace

RegionWindow region_window(const Theory& theory) {
  double left = 0, right = 0, up = 0;
  for (int i = 0; i <= 48; ++i) {
    WideComplex direction = std::polar(1.0L, Coefficient(i) * std::numbers::pi_v<Coefficient> / 48);
    if (i == 0 || i == 48) direction = i == 0 ? 1 : -1;
    if (i == 24) direction = {0, 1};
    const auto found = detail::is_multistep(theory) ? detail::multistep_stable_along_ray(theory, direction)
                                                    : detail::stable_along_ray(theory, direction);
    for (const auto& [low, high] : found.where)
      for (const Coefficient r : {low, high}) {
        if (!(r < 200)) continue;  // beyond what a picture can show beside the origin
        const WideComplex z = r * direction;
        left = std::min(left, double(z.real())), right = std::max(right, double(z.real()));
        up = std::max(up, double(z.imag()));
      }
  }
  const double size = std::max({right - left, 2 * up, 1.0}), margin = 0.12 * size;
  left = std::min(left, -0.25 * size), right = std::max(right, 0.1 * size), up = std::max(up, 0.35 * size);
  return {left - margin, right + margin, -up - margin, up + margin};
}

StabilityRegion stability_region(const std::string& method, const Theory& theory,
                                 std::optional<RegionWindow> window, int cells) {
  StabilityRegion out;
  out.method = method;
  if (theory.numerator.empty() && !detail::is_multistep(theory)) {
    out.reason = !theory.blank_reason.empty() ? std::string(theory.blank_reason)
                 : !theory.moves.empty() || !theory.oscillator.xx.empty() || theory.second_order_step
                     ? "its step is not a function of one z: it treats x and v apart"
                 : theory.exact_on_linear_part
                     ? "it is exact on linear problems: stable wherever the problem is"
                     : "this method gives no theory";
    return out;
  }
  const RegionWindow seen = window.value_or(region_window(theory));
  out.re_min = seen.re_min, out.re_max = seen.re_max, out.im_min = seen.im_min, out.im_max = seen.im_max;
  out.boundaries = Squares(theory, seen, cells).polygons();
  if (detail::is_multistep(theory)) out.root_locus = locus(theory, seen);
  return out;
}

}  // namespace odemark
