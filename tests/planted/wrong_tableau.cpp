// Must not compile when WRONG is defined: one digit of Dormand-Prince's tableau changed, 49/176 to 48/176.
#include "integrators/methods/dormand_prince54.hpp"

namespace {
constexpr auto changed = [] {
  auto method = odemark::dormand_prince54;
#ifdef WRONG
  method.a[5][3] = 48.0L / 176;
#endif
  return method;
}();
static_assert(orders_hold(changed));
}  // namespace

int main() {}
