#include "bench/family_system.hpp"
#include "bench/step_cost/hand_loops.hpp"
#include "bench/step_cost/keep.hpp"
#include "bench/step_cost/tax.hpp"
#include "integrators/integrate.hpp"
#include "integrators/methods/dormand_prince54.hpp"
#include "integrators/methods/explicit_euler.hpp"
#include "integrators/methods/heun.hpp"
#include "integrators/methods/rk4.hpp"
#include "problems/drag_ship.hpp"
#include "problems/lorenz63.hpp"
#include "problems/oscillator.hpp"
#ifdef ODEMARK_HAS_ODEINT
#include "reference/contestants/odeint_static.hpp"
#endif

namespace odemark {

namespace {

template <std::size_t N>
double checksum(const std::array<double, N>& y) {
  double sum = 0;
  for (const double x : y) sum += x;
  return sum;
}

/// Parameters go through memory the compiler cannot see into, as run-time values do.
template <class V>
V opaque(V value) {
  keep(value);
  return value;
}

template <class F, const auto& method>
std::function<double(long)> engine_loop(double h) {
  return [h](long count) {
    using P = FamilySystem<F, double>;
    const P system{opaque(F{})};
    typename P::State y;
    system.family.initial(y.data());
    StepperOf<method, P> stepper(system, y);
    const auto report = integrate(stepper, FixedSteps{count}, 0, h * static_cast<double>(count), y);
    return checksum(y) + static_cast<double>(report.rejected);
  };
}

template <class Scene, class Loop>
std::function<double(long)> hand_loop(Scene scene, std::array<double, Scene::size> start, double h,
                                      Loop loop) {
  return [=](long count) {
    auto y = opaque(start);
    loop(opaque(scene), y, opaque(h), count);
    return checksum(y);
  };
}

#ifdef ODEMARK_HAS_ODEINT
template <class Stepper, class F>
std::function<double(long)> odeint_loop(double h) {
  return [h](long count) {
    const FamilySystem<F, double> system{opaque(F{})};
    typename FamilySystem<F, double>::State y;
    system.family.initial(y.data());
    const auto rhs = [&system](const auto& state, auto& slope, double t) { system.rhs(t, state, slope); };
    odeint_fixed_steps<Stepper>(rhs, y, 0.0, opaque(h), count);
    return checksum(y);
  };
}
#endif

template <class F, class Scene>
void add_cells(std::vector<TaxCell>& cells, Scene scene, double h) {
  std::array<double, F::size> start{};
  F{}.initial(start.data());
  const std::string id(F::id);
  const auto cell = [&](const char* method, auto hand, auto engine) -> TaxCell& {
    return cells.emplace_back(TaxCell{id, method, hand_loop(scene, start, h, hand), engine, {}});
  };
  auto& euler = cell(
      "explicit_euler", [](auto&&... a) { hand::euler(a...); }, engine_loop<F, explicit_euler>(h));
#ifdef ODEMARK_HAS_ODEINT
  using Odeint = OdeintStatic<F::size>;
  euler.odeint = odeint_loop<typename Odeint::Euler, F>(h);
#endif
  cell(
      "heun", [](auto&&... a) { hand::heun(a...); }, engine_loop<F, heun>(h));
  auto& classic = cell(
      "rk4", [](auto&&... a) { hand::rk4(a...); }, engine_loop<F, rk4>(h));
  (void)euler, (void)classic;
#ifdef ODEMARK_HAS_ODEINT
  classic.odeint = odeint_loop<typename Odeint::RungeKutta4, F>(h);
#endif
  auto& dopri = cell(
      "dormand_prince54", [](auto&&... a) { hand::dormand_prince5(a...); },
      engine_loop<F, dormand_prince54>(h));
  (void)dopri;
#ifdef ODEMARK_HAS_ODEINT
  dopri.odeint = odeint_loop<typename Odeint::DormandPrince5, F>(h);
#endif
}

}  // namespace

std::vector<TaxCell> tax_cells() {
  std::vector<TaxCell> cells;
  cells.reserve(12);
  const DragShip<double> ship;
  const Oscillator<double> spring;
  const Lorenz63<double> weather;
  add_cells<DragShip<double>>(cells, hand::Drag{ship.thrust, ship.drag, ship.m}, 1.0 / 64);
  add_cells<Oscillator<double>>(cells, hand::Spring{spring.k, spring.m}, 1.0 / 64);
  add_cells<Lorenz63<double>>(cells, hand::Lorenz{weather.sigma, weather.rho, weather.beta}, 1.0 / 1024);
  return cells;
}

}  // namespace odemark
