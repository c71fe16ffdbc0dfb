#include "reference/taylor_truth.hpp"

#include <algorithm>
#include <cmath>

namespace odemark {

namespace {

constexpr double floor_of_scale = 1e-6;

/// sum over k = first .. order of coefficient(k) x^(k - first)
template <class Coefficient>
Wide horner(Coefficient&& coefficient, int first, int order, const Wide& x) {
  Wide sum = coefficient(order);
  for (int k = order; k-- > first;) sum = sum * x + coefficient(k);
  return sum;
}

}  // namespace

TaylorTruth::TaylorTruth(RunTolerance tolerance)
    : tolerance_(std::move(tolerance)),
      order_(std::max(16, int(std::ceil(-1.2 * tolerance_.exponent)) + 4)) {}

std::string TaylorTruth::name() const { return "Taylor series of order " + std::to_string(order_); }

void TaylorTruth::enter(const WideSystem& system) {
  smooth_ = system.phase->tape;
  branches_.clear();
  for (std::size_t e = 0; e < smooth_.entries.size(); ++e)
    if (smooth_.entries[e].op == TapeOp::absolute) branches_.push_back({e, smooth_.entries[e].left});
  if (!branches_.empty()) smooth_.push(TapeOp::constant, 0, 0, Wide(0));
  series_ = std::make_unique<TaylorSeries<Wide>>(smooth_, system.size(), order_);
  for (auto& kink : branches_) set_branch(kink, false);
}

void TaylorTruth::set_branch(Kink& kink, bool negative) {
  kink.negative = negative;
  // x + 0 with the last entry, whose coefficients are 0 at every order
  smooth_.entries[kink.entry] = {negative ? TapeOp::negate : TapeOp::add, kink.argument,
                                 smooth_.entries.size() - 1, Wide(0)};
}

/// Expands the series with every abs on the branch that the solution enters.
void TaylorTruth::choose_branches(const Wide& t, const std::vector<Wide>& y) {
  series_->expand(t, y.data(), order_);
  for (std::size_t attempt = 0; attempt <= 2 * branches_.size(); ++attempt) {
    const auto wrong = std::find_if(branches_.begin(), branches_.end(), [&](Kink& kink) {
      if (series_->entry_coefficient(kink.argument, 0) == 0) kink.here = true;
      for (int k = kink.here ? 1 : 0; k < order_; ++k)
        if (const Wide& c = series_->entry_coefficient(kink.argument, k); c != 0)
          return (c < 0) != kink.negative;
      return false;
    });
    if (wrong == branches_.end()) return;
    set_branch(*wrong, !wrong->negative);
    series_->expand(t, y.data(), order_);
  }
  throw RunFailed("the solution slides along a kink of abs at t = " + t.str(8));
}

/// log2 of the step that keeps each of the last eight terms below the tolerance.
long double TaylorTruth::step_bits(const std::vector<Wide>& y) const {
  const long double tolerance = tolerance_.bits();
  long double bits = 1e9L;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const long double unit = log2_size(error_unit(y[i], floor_of_scale, tolerance_.scale[i]));
    for (int k = order_ - 7; k <= order_; ++k) {
      const Wide& c = series_->coefficient(i, k);
      if (!isfinite(c)) return std::nanl("");
      if (c != 0) bits = std::min(bits, (tolerance + unit - log2_size(c)) / static_cast<long double>(k));
    }
  }
  return bits;
}

/// The first instant in (0, step] at which the argument of abs leaves its branch, on the series.
bool TaylorTruth::first_crossing(const Kink& kink, const Wide& step, Wide& crossing) const {
  const int first = kink.here ? 1 : 0;
  const auto inside = [&](const Wide& x) {  // positive on the branch at hand
    const Wide sum =
        horner([&](int k) { return series_->entry_coefficient(kink.argument, k); }, first, order_ - 1, x);
    return kink.negative ? Wide(-sum) : sum;
  };
  constexpr int samples = 48;
  const auto bisect = [&](Wide low, Wide high) {
    for (int i = 0; i < 180; ++i) {
      const Wide middle = (low + high) / 2;
      (inside(middle) < 0 ? high : low) = middle;
    }
    return high;
  };
  Wide before = inside(Wide(0)), last = before;
  for (int i = 1; i <= samples; ++i) {
    const Wide x = step * i / samples, now = inside(x);
    if (now < 0) return crossing = bisect(step * (i - 1) / samples, x), true;
    if (i >= 2 && last < before && last < now) {  // a minimum in between may dip below 0
      Wide low = step * (i - 2) / samples, high = x;
      for (int j = 0; j < 120; ++j) {
        const Wide a = low + (high - low) * 2 / 5, b = low + (high - low) * 3 / 5;
        (inside(a) < inside(b) ? high : low) = inside(a) < inside(b) ? b : a;
      }
      if (inside(low) < 0) return crossing = bisect(step * (i - 2) / samples, low), true;
    }
    before = last, last = now;
  }
  return false;
}

void TaylorTruth::advance(Wide& t, std::vector<Wide>& y, const Wide& stop, RunBudget& budget) {
  while (t < stop) {
    budget.spend();
    choose_branches(t, y);
    const long double bits = step_bits(y);
    const Wide whole = stop - t;
    if (!(bits > log2_size(whole) - 130)) throw RunFailed("the solution is singular near t = " + t.str(8));
    const bool last = bits >= log2_size(whole);
    Wide step = last ? whole : power_of_two(bits);
    Kink* reached = nullptr;
    for (auto& kink : branches_)
      if (Wide crossing; first_crossing(kink, step, crossing)) step = crossing, reached = &kink;
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] = horner([&](int k) { return series_->coefficient(i, k); }, 0, order_, step);
    t = last && !reached ? stop : Wide(t + step);
    for (auto& kink : branches_) kink.here = &kink == reached;
    if (reached) kinks_.push_back(t);
  }
}

}  // namespace odemark
