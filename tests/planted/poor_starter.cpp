// Must not compile when WRONG is defined: Adams-Bashforth 4 started by a method of order 2.
#include "integrators/methods/adams_bashforth4.hpp"
#include "integrators/methods/heun.hpp"

namespace {
#ifdef WRONG
#define STARTER odemark::heun
#else
#define STARTER odemark::rk4
#endif
constexpr odemark::ExplicitMultistep<4, STARTER> started{
    .id = "started",
    .source = "planted",
    .order = 4,
    .formula = odemark::adams_bashforth4.formula,
};
static_assert(multistep_holds(started));
}  // namespace

int main() {}
