// Measures what odeint's rosenbrock4 makes of a right-hand side that depends on time.
#include "reference/contestants/checks.hpp"
#include "reference/contestants/odeint_methods.hpp"

namespace odemark::contestant {

void add_odeint_checks(std::vector<LibraryCheck>& checks) {
  std::vector<AnyMethod> methods;
  add_odeint_rosenbrock(methods);
  add_odeint_explicit(methods);
  const AnyMethod &rosenbrock = methods.front(), &reference = methods[2];
  const double forced = observed_order(rosenbrock, reference, 0.3, 64);
  const double free = observed_order(rosenbrock, reference, 0.0, 64);
  checks.push_back(
      {"odeint_rosenbrock_time",
       "odeint",
       forced < free - 0.5,
       "order " + two_digits(forced) + " where f depends on time, " + two_digits(free) + " where it does not",
       {"odeint_rosenbrock4"},
       "odeint's rosenbrock4 has the fourth coefficient of df/dt with the wrong sign (d4 = +0.0362 instead "
       "of -0.0362): order 1 on time-dependent problems."});
}

}  // namespace odemark::contestant
