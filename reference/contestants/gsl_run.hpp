// One run of a stepper of GSL's odeiv2, driven step by step so that it can be limited, watched and stopped.
#pragma once

#include <gsl/gsl_odeiv2.h>

#include "reference/contestants/adapter.hpp"

namespace odemark::contestant {

struct GslRow : Row {
  const gsl_odeiv2_step_type** type =
      nullptr;                        // a variable of the library: its value is known at run time only
  bool uses_time_derivative = false;  // df/dt is needed beside df/dy
};

RunReport run_gsl(const GslRow& row, const Job& job);

}  // namespace odemark::contestant
