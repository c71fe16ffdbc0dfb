#include "integrators/integrate_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "integrators/bracket_root.hpp"

namespace odemark {

namespace {

/// A time that a run in T can start or end at.
template <class T>
double representable(double t) {
  return static_cast<double>(static_cast<T>(t));
}
/// A few ulps of t; long double times are doubles too.
template <class T>
double close_at(double t) {
  return 4 * std::max(double(std::numeric_limits<T>::epsilon()), std::numeric_limits<double>::epsilon()) *
         std::abs(t);
}

template <class T>
class EventRun {
 public:
  EventRun(const MethodRuns<T>& runs, const Pieces<T>& pieces, const ErasedSystem<T>& whole,
           const std::vector<ErasedSystem<T>>& counted, const ErasedSystem<T>& bare, const Control& control,
           double t0, double t1, std::vector<T>& y, Trace<T>& trace, std::vector<FoundEvent>& found)
      : runs_(runs),
        pieces_(pieces),
        whole_(whole),
        counted_(counted),
        bare_(bare),
        t_(t0),
        end_(t1),
        y_(y),
        trace_(trace),
        found_(found),
        left_(y),
        trial_(y),
        right_(y),
        slope_left_(y),
        slope_right_(y),
        g_(pieces.events),
        g_left_(pieces.events),
        g_trial_(pieces.events),
        armed_(pieces.events, false) {
    if (const auto* fixed = std::get_if<FixedSteps>(&control))
      fixed_ = *fixed;
    else
      error_control_ = std::get<ErrorControl>(control), locating_ = true;
    trace.samples.assign(trace.grid.size() * whole.size, std::numeric_limits<T>::quiet_NaN());
    found.clear();
  }

  RunReport run() {
    while (phase_ < pieces_.switch_times.size() && pieces_.switch_times[phase_] <= t_) ++phase_;
    look_around();
    while (t_ < end_) {
      double stop = end_;
      if (locating_ && phase_ < pieces_.switch_times.size())
        stop = std::min(stop, representable<T>(pieces_.switch_times[phase_]));
      if (!advance(stop)) return report_;
      if (!hit_) {
        t_ = stop;
        while (locating_ && phase_ < pieces_.switch_times.size() &&
               representable<T>(pieces_.switch_times[phase_]) <= t_)
          ++phase_;
        if (t_ < end_) look_around();
        continue;
      }
      if (locating_) locate();
      if (!happen()) return report_;
      if (!locating_ && fixed_.count == 0) break;
    }
    report_.status = RunStatus::reached_end;
    report_.t_reached = t_;
    return report_;
  }

 private:
  const ErasedSystem<T>& bare_system() const { return reads_clock() ? bare_ : pieces_.phases[phase_]; }
  const ErasedSystem<T>& system() const { return reads_clock() ? whole_ : counted_[phase_]; }
  /// Fixed steps walk over the switches of a system that reads the clock.
  bool reads_clock() const { return !locating_ && !pieces_.switch_times.empty(); }
  void values(double t, const T* y, std::vector<T>& g) const {
    if (pieces_.events > 0) pieces_.values_call(pieces_.values[phase_], T(t), y, g.data());
  }

  /// A piece begins: which events can come.
  void look_around() {
    values(t_, y_.data(), g_left_);
    for (std::size_t k = 0; k < armed_.size(); ++k) armed_[k] = g_left_[k] > 0;
    begin_piece();
  }
  void begin_piece() {
    t_left_ = t_, left_ = y_;
    if (watches_dips()) system().rhs(T(t_), y_, slope_left_);
  }
  bool watches_dips() const { return locating_ && pieces_.events > 0; }

  /// One piece up to `stop` or to the end of the step that holds an event. False where the run ends for good.
  bool advance(double stop) {
    Trace<T> piece;
    const auto first =
        std::upper_bound(trace_.grid.begin() + std::ptrdiff_t(sampled_), trace_.grid.end(), t_);
    sampled_ = std::size_t(first - trace_.grid.begin());
    piece.grid.assign(first, std::upper_bound(first, trace_.grid.end(), stop));
    hit_ = false;
    long taken = 0;
    bool stopped = false;
    piece.on_step = [&](T t, const T* y) {
      ++taken;
      if (happened_before(double(t), y)) {
        hit_ = true;
        return false;
      }
      if (trace_.on_step && !trace_.on_step(t, y)) stopped = true;
      return !stopped;
    };
    Control control = FixedSteps{fixed_};
    if (locating_) {
      ErrorControl left = error_control_;
      left.step_limit -= report_.accepted + report_.rejected;
      control = left;
      error_control_.first_step = 0;  // the user's word on it is for the start of the run
    }
    const RunReport part = runs_.solve_traced(system(), bare_system(), control, t_, stop, y_, piece);
    report_.accepted += part.accepted, report_.rejected += part.rejected;
    report_.newton.lu += part.newton.lu, report_.newton.newton += part.newton.newton;
    report_.status = part.status, report_.reason = part.reason, report_.t_reached = part.t_reached;
    piece_samples_ = std::move(piece.samples), piece_grid_ = std::move(piece.grid);
    if (hit_) {
      if (!locating_) fixed_.count -= taken;
      return true;
    }
    keep_samples(part.t_reached);
    return part.status == RunStatus::reached_end && !stopped;
  }

  /// Samples up to t are results; those behind an event are not.
  void keep_samples(double t) {
    const std::size_t n = whole_.size;
    for (std::size_t i = 0; i < piece_grid_.size() && piece_grid_[i] <= t + close_at<T>(t); ++i)
      std::copy_n(piece_samples_.begin() + std::ptrdiff_t(i * n), n,
                  trace_.samples.begin() + std::ptrdiff_t((sampled_ + i) * n));
  }

  /// An accepted step: did an armed value fall to 0? If so y_ stays where the last step began.
  bool happened_before(double t, const T* y) {
    if (pieces_.events == 0) return false;
    values(t, y, g_);
    bool crossed = false;
    for (std::size_t k = 0; k < armed_.size(); ++k) crossed = crossed || (armed_[k] && g_[k] <= 0);
    std::copy_n(y, right_.size(), right_.begin());
    t_right_ = t;
    if (!crossed && watches_dips()) crossed = dips();
    if (crossed && (locating_ || pieces_.jumps)) return true;
    if (crossed)  // a kink stepped over leaves nothing to do
      for (std::size_t k = 0; k < armed_.size(); ++k)
        if (armed_[k] && g_[k] <= 0) found_.push_back({k, t});
    for (std::size_t k = 0; k < armed_.size(); ++k) armed_[k] = g_[k] > 0;
    left_.swap(right_), g_left_.swap(g_), slope_left_.swap(slope_right_);
    t_left_ = t;
    return false;
  }

  /// Looks at the cubic through both ends of the step; where it is below 0, a side run decides, and the step
  /// ends there.
  bool dips() {
    system().rhs(T(t_right_), right_, slope_right_);
    const T h = T(t_right_) - T(t_left_);
    for (const double share : {0.25, 0.5, 0.75}) {
      const T s = T(share), r = 1 - s;
      for (std::size_t i = 0; i < trial_.size(); ++i)
        trial_[i] =
            r * left_[i] + s * right_[i] +
            s * r * ((r - s) * (right_[i] - left_[i]) + h * (r * slope_left_[i] - s * slope_right_[i]));
      const double t = representable<T>(t_left_ + share * (t_right_ - t_left_));
      values(t, trial_.data(), g_trial_);
      bool below = false;
      for (std::size_t k = 0; k < armed_.size(); ++k) below = below || (armed_[k] && g_trial_[k] <= 0);
      if (!below || !side_run(t)) continue;
      for (std::size_t k = 0; k < armed_.size(); ++k)
        if (armed_[k] && g_trial_[k] <= 0) {
          right_ = trial_, g_ = g_trial_, t_right_ = t;
          return true;
        }
    }
    return false;
  }

  /// The state at t and its event values into trial_ and g_trial_, by the method itself.
  bool side_run(double t) {
    trial_ = left_;
    if (t > t_left_) {
      ErrorControl control = error_control_;
      control.first_step = t - t_left_;
      const RunReport side = runs_.solve(system(), control, t_left_, t, trial_);
      report_.newton.lu += side.newton.lu, report_.newton.newton += side.newton.newton;
      if (side.status != RunStatus::reached_end) return false;
    }
    values(t, trial_.data(), g_trial_);
    return true;
  }

  /// Moves the right end of the last step to the first event in it. Where a side run fails the event stays at
  /// the end of the step, and its time error tells.
  void locate() {
    for (std::size_t k = 0; k < armed_.size(); ++k) {
      if (!armed_[k] || !(g_[k] <= 0)) continue;
      double positive = t_left_, behind = t_right_;
      T above = g_left_[k], below = g_[k];
      bool good = true;
      // after a jump the value starts at 0: the rise that came before this fall is looked for from behind
      while (good && !(above > 0) && behind - t_left_ > close_at<T>(behind)) {
        const double t = representable<T>(t_left_ + (behind - t_left_) / 2);
        good = side_run(t);
        if (!good) break;
        if (g_trial_[k] > 0)
          positive = t, above = g_trial_[k];
        else
          take_right(t), behind = t, below = g_trial_[k];
      }
      if (!good || !(above > 0)) continue;
      bracket_root(positive, double(above), behind, double(below), close_at<T>(behind), [&](double wished) {
        const double t = representable<T>(wished);
        if (!good || !side_run(t)) {
          good = false;
          return -1.0;
        }
        if (!(g_trial_[k] > 0)) take_right(t);
        return double(g_trial_[k]);
      });
    }
  }
  void take_right(double t) { t_right_ = t, right_ = trial_, g_ = g_trial_; }

  /// The event at the right end of the step happens. False where the run ends there for good.
  bool happen() {
    keep_samples(t_right_);
    t_ = t_right_, y_ = right_;
    if (trace_.on_step && !trace_.on_step(T(t_), y_.data())) {
      report_.status = RunStatus::time_limit, report_.t_reached = t_;
      return false;
    }
    for (std::size_t k = 0; k < armed_.size(); ++k) {
      if (!armed_[k] || !(g_[k] <= 0)) continue;
      found_.push_back({k, t_});
      if (pieces_.jumps) {
        phase_ = pieces_.after_call(pieces_.values[phase_], k, T(t_), y_.data(), phase_);
        break;  // another event of the same instant is judged by the state after this one
      }
    }
    values(t_, y_.data(), g_left_);
    for (std::size_t k = 0; k < armed_.size(); ++k)
      armed_[k] = g_left_[k] > 0 || (pieces_.jumps && g_left_[k] == 0);
    for (std::size_t i = 0; i < piece_grid_.size(); ++i)  // at an instant of an event, the state after it
      if (std::abs(piece_grid_[i] - t_) <= close_at<T>(t_))
        std::copy(y_.begin(), y_.end(), trace_.samples.begin() + std::ptrdiff_t((sampled_ + i) * y_.size()));
    begin_piece();
    if (found_.size() < most_events) return true;
    report_.status = RunStatus::step_limit, report_.t_reached = t_;
    report_.reason = "more events than can be meant";
    return false;
  }

  const MethodRuns<T>& runs_;
  const Pieces<T>& pieces_;
  const ErasedSystem<T>& whole_;
  const std::vector<ErasedSystem<T>>& counted_;
  const ErasedSystem<T>& bare_;
  double t_, end_;
  std::vector<T>& y_;
  Trace<T>& trace_;
  std::vector<FoundEvent>& found_;
  FixedSteps fixed_{0};
  ErrorControl error_control_{};
  bool locating_ = false, hit_ = false;
  std::size_t phase_ = 0, sampled_ = 0;
  double t_left_ = 0, t_right_ = 0;  // of the last step
  std::vector<T> left_, trial_, right_, slope_left_, slope_right_, g_, g_left_, g_trial_;
  std::vector<bool> armed_;
  std::vector<T> piece_samples_;
  std::vector<double> piece_grid_;
  RunReport report_;
};

}  // namespace

template <class T>
RunReport integrate_events(const MethodRuns<T>& runs, const Pieces<T>& pieces, const ErasedSystem<T>& whole,
                           const std::vector<ErasedSystem<T>>& counted, const ErasedSystem<T>& bare,
                           const Control& control, double t0, double t1, std::vector<T>& y, Trace<T>& trace,
                           std::vector<FoundEvent>& found) {
  return EventRun<T>(runs, pieces, whole, counted, bare, control, t0, t1, y, trace, found).run();
}

#define ODEMARK_FOR(T)                                                                                   \
  template RunReport integrate_events<T>(const MethodRuns<T>&, const Pieces<T>&, const ErasedSystem<T>&, \
                                         const std::vector<ErasedSystem<T>>&, const ErasedSystem<T>&,    \
                                         const Control&, double, double, std::vector<T>&, Trace<T>&,     \
                                         std::vector<FoundEvent>&);
ODEMARK_FOR(float)
ODEMARK_FOR(double)
ODEMARK_FOR(long double)
#undef ODEMARK_FOR

}  // namespace odemark
