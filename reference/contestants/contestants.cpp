// Gathers what was compiled in. The only unit that asks which providers those are.
#include "reference/contestants.hpp"

#include "reference/contestants/checks.hpp"
#ifdef ODEMARK_HAS_SUNDIALS
#include "reference/contestants/sundials_methods.hpp"
#endif
#ifdef ODEMARK_HAS_GSL
#include "reference/contestants/gsl_methods.hpp"
#endif
#ifdef ODEMARK_HAS_ODEINT
#include "reference/contestants/odeint_methods.hpp"
#endif

namespace odemark {

std::vector<AnyMethod> contestants() {
  std::vector<AnyMethod> methods;
#ifdef ODEMARK_HAS_SUNDIALS
  contestant::add_cvode(methods);
  contestant::add_arkode(methods);
#endif
#ifdef ODEMARK_HAS_GSL
  contestant::add_gsl(methods);
#endif
#ifdef ODEMARK_HAS_ODEINT
  contestant::add_odeint_explicit(methods);
  contestant::add_odeint_bulirsch_stoer(methods);
  contestant::add_odeint_rosenbrock(methods);
  contestant::add_odeint_velocity_verlet(methods);
#endif
  return methods;
}

std::vector<InlinedContestant> inlined_contestants() {
  std::vector<InlinedContestant> runs;
#ifdef ODEMARK_HAS_ODEINT
  contestant::add_odeint_inlined(runs);
#endif
  return runs;
}

std::vector<ProviderInfo> contestant_providers() {
  std::vector<ProviderInfo> providers;
#ifdef ODEMARK_HAS_SUNDIALS
  providers.push_back(contestant::sundials_provider());
#endif
#ifdef ODEMARK_HAS_GSL
  providers.push_back(contestant::gsl_provider());
#endif
#ifdef ODEMARK_HAS_ODEINT
  providers.push_back(contestant::odeint_provider());
#endif
  return providers;
}

std::vector<LibraryCheck> library_checks() {
  std::vector<LibraryCheck> checks;
#ifdef ODEMARK_HAS_SUNDIALS
  contestant::add_sundials_checks(checks);
#endif
#ifdef ODEMARK_HAS_ODEINT
  contestant::add_odeint_checks(checks);
#endif
  return checks;
}

}  // namespace odemark
