// One run of ARKODE: explicit tables through ERKStep or ARKStep, diagonally implicit ones through ARKStep.
#pragma once

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>

#include "reference/contestants/sundials_handles.hpp"

namespace odemark::contestant {

struct FreeTable {
  void operator()(ARKodeButcherTable table) const { ARKodeButcherTable_Free(table); }
};
using OwnedTable = Owned<ARKodeButcherTable, FreeTable>;

enum class ArkodeModule { erk_step, ark_step_explicit, ark_step_implicit };

struct ArkodeRow : Row {
  ArkodeModule module{};
  ARKodeButcherTable (*table)() = nullptr;
};

/// Its own weights instead of the library's: fixed explicit steps otherwise divide by the smallest normal
/// number.
RunReport run_arkode(const ArkodeRow& row, const Job& job);

/// Classical RK4, which ARKODE 6 does not ship.
ARKodeButcherTable classical_rk4_table();

}  // namespace odemark::contestant
