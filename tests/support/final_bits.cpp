// Prints the bits that a few methods end in, compiled for the purpose: at another -O level and by another
// compiler than the library, the lines must agree.
#include "tests/support/final_bits.hpp"

#include "integrators/integrate.hpp"
#include "integrators/methods/adams_bashforth3.hpp"
#include "integrators/methods/dormand_prince54.hpp"
#include "integrators/methods/esdirk43.hpp"
#include "integrators/methods/explicit_euler.hpp"
#include "integrators/methods/implicit_midpoint.hpp"
#include "integrators/methods/newmark_beta.hpp"
#include "integrators/methods/radau_iia5.hpp"
#include "integrators/methods/rigid_body_splitting.hpp"
#include "integrators/methods/rk4.hpp"
#include "integrators/methods/sdirk2.hpp"
#include "integrators/methods/semi_implicit_euler.hpp"
#include "integrators/methods/taylor.hpp"
#include "integrators/methods/tsitouras54.hpp"
#include "integrators/methods/yoshida4.hpp"
#include "problems/free_rigid_body.hpp"
#include "problems/kepler.hpp"
#include "problems/lorenz63.hpp"
#include "problems/pendulum.hpp"
#include "problems/stiff_spring.hpp"
#include "reference/make_family.hpp"

namespace {

using namespace odemark;

template <const auto& method, class T, class F>
void print_end(const char* problem, const char* type, const F& family, long steps) {
  const ErasedSystem<T> system = erase<T>(family);
  if (!missing_ability(KindOf<method>::needs, system.abilities).empty()) return;
  std::vector<double> start(F::size);
  family.initial(start.data());
  std::vector<T> y(start.begin(), start.end());
  StepperOf<method, ErasedSystem<T>> stepper(system, y);
  integrate(stepper, FixedSteps{steps}, 0, 2, y);
  print_bits(problem, method.id, type, y);
}

template <const auto& method, class F>
void print_controlled_end(const char* problem, const F& family) {
  const auto system = erase<double>(family);
  std::vector<double> y(F::size);
  family.initial(y.data());
  StepperOf<method, ErasedSystem<double>> stepper(system, y);
  integrate(stepper, system, ErrorControl{1e-7, 1e-9}, error_order<method>(), 0, 2, y);
  print_bits(problem, method.id, "controlled", y);
}

template <class F, const auto&... methods>
void print_family(const char* problem, const F& family, long steps) {
  (print_end<methods, double>(problem, "double", family, steps), ...);
  (print_end<methods, float>(problem, "float", family, steps), ...);
  print_controlled_end<dormand_prince54>(problem, family);
  print_controlled_end<taylor8>(problem, family);
  print_controlled_end<esdirk43>(problem, family);
  print_controlled_end<radau_iia5>(problem, family);
}

template <class F>
void print_all(const char* problem, const F& family, long steps) {
  print_family<F, explicit_euler, rk4, dormand_prince54, tsitouras54, adams_bashforth3, semi_implicit_euler,
               yoshida4, implicit_midpoint, sdirk2, radau_iia5, taylor8, newmark_beta, rigid_body_splitting>(
      problem, family, steps);
}

}  // namespace

int main() {
  print_all("kepler", Kepler<>{}, 300);
  print_all("free_rigid_body", FreeRigidBody<>{}, 300);
  print_all("lorenz63", Lorenz63<>{}, 300);
  print_all("pendulum", Pendulum<>{}, 300);
  StiffSpring<> spring;
  spring.k = 10000, spring.c = 50;
  print_all("stiff_spring", spring, 2000);
}
