// Extrapolation methods: of a fixed order, as a one-step method with an estimate; and with order and step
// chosen together as they go.
#pragma once

#include "integrators/extrapolation_control.hpp"
#include "integrators/gragg_table.hpp"
#include "integrators/linearly_implicit_table.hpp"

namespace odemark {

/// What is extrapolated.
struct GraggRule {
  static constexpr std::string_view kind_name = "extrapolation";
  static constexpr bool solves_equations = false;
  static constexpr std::size_t most_rows = 10;  // order 20
  static constexpr int order_of(std::size_t rows) { return 2 * int(rows); }
  template <class P, std::size_t Rows>
  using FixedTable = GraggTable<P, Rows>;
  template <class P>
  using VariableTable = GraggTable<P, most_rows>;
  template <std::size_t Rows>
  static Theory theory() {
    return gragg_theory<Rows>();
  }
};
struct LinearlyImplicitRule {
  static constexpr std::string_view kind_name = "linearly implicit extrapolation";
  static constexpr bool solves_equations = true;
  static constexpr std::size_t most_rows = 9;
  static constexpr int order_of(std::size_t rows) { return int(rows); }
  template <class P, std::size_t Rows>
  using FixedTable = LinearlyImplicitTable<P, Rows, 1>;
  template <class P>
  using VariableTable = LinearlyImplicitTable<P, most_rows, 2>;  // one substep would tell too little
  template <std::size_t Rows>
  static Theory theory() {
    return linearly_implicit_theory<Rows, 1>();
  }
};

/// Always all rows; the estimate is the difference of the last two entries of the last one. Of a step that is
/// not to be trusted it is not a number: error control refuses that as it refuses any that is too large, and
/// fixed steps, which have no other step to take, go on.
template <class Table>
class ExtrapolationStepper {
 public:
  using State = typename Table::State;
  using Real = typename Table::Real;

  template <System P>
  ExtrapolationStepper(const P& system, const State& model) : table_(system, model) {
    if constexpr (has_doubts) table_.always_go_on();
  }

  void start() { begun_ = false; }
  void accept() { begun_ = false; }
  NewtonCounts newton_counts() const { return table_.counts(); }

  StepStatus attempt(Real t, const State& y, Real h, State& next, State& error) {
    if (!begun_) table_.begin(t, y);
    begun_ = true;  // what is known of the start stays known if this attempt is rejected
    for (std::size_t row = 0; row < Table::rows; ++row)
      if (!table_.add_row(row, t, y, h, next, error)) return StepStatus::newton_diverged;
    if constexpr (has_doubts)
      if (!table_.is_trusted())
        for_each_component(error,
                           [&](std::size_t i) { error.data()[i] = std::numeric_limits<Real>::quiet_NaN(); });
    return StepStatus::ok;
  }

 private:
  static constexpr bool has_doubts = requires(const Table& table) { table.is_trusted(); };

  Table table_;
  bool begun_ = false;
};

template <class Rule, std::size_t Rows>
struct FixedExtrapolation {
  static constexpr std::string_view kind_name = Rule::kind_name;
  static constexpr bool solves_equations = Rule::solves_equations;
  static constexpr unsigned needs = 0;

  std::string_view id, source;
  std::string_view note = "", advice = "";
  int order = Rule::order_of(Rows);
  int embedded_order = Rule::order_of(Rows - 1);
  bool jumps_over_poles = false;  // see AnyMethod

  Theory theory() const { return Rule::template theory<Rows>(); }

  template <const auto& method, System P>
  using Stepper = ExtrapolationStepper<typename Rule::template FixedTable<P, Rows>>;
};

template <class Rule>
struct VariableExtrapolation {
  static constexpr std::string_view kind_name = Rule::kind_name;
  static constexpr bool solves_equations = Rule::solves_equations;
  static constexpr unsigned needs = 0;
  static constexpr bool takes_fixed_steps = false;

  std::string_view id, source;
  std::string_view advice = "";
  int order = Rule::order_of(Rule::most_rows - 1);
  int embedded_order = Rule::order_of(Rule::most_rows - 2);

  Theory theory() const {
    Theory theory;
    theory.blank_reason = "varies its order and step: no single stability function";
    return theory;
  }

  /// One step of a given size with all rows: it serves values between the steps of a run.
  template <const auto& method, System P>
  using Stepper = ExtrapolationStepper<typename Rule::template VariableTable<P>>;

  template <const auto& method, System P, class Observer>
  static RunReport drive(const P& system, const Control& control, double t0, double t1, typename P::State& y,
                         Observer&& observe) {
    if (const auto* adaptive = std::get_if<ErrorControl>(&control))
      return extrapolate<typename Rule::template VariableTable<P>>(system, *adaptive, t0, t1, y, observe);
    return chooses_its_own_steps(t0);
  }
};

}  // namespace odemark
