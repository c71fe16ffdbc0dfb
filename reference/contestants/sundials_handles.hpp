// SUNDIALS objects that free themselves, the callbacks it calls, and its return flags as statuses.
#pragma once

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_version.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_band.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <memory>

#include "reference/contestants/adapter.hpp"

namespace odemark::contestant {

struct FreeVector {
  void operator()(N_Vector v) const { N_VDestroy(v); }
};
struct FreeMatrix {
  void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
};
struct FreeLinearSolver {
  void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
};
struct FreeNonlinearSolver {
  void operator()(SUNNonlinearSolver s) const { SUNNonlinSolFree(s); }
};
template <class Handle, class Free>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Free>;
using OwnedVector = Owned<N_Vector, FreeVector>;
using OwnedMatrix = Owned<SUNMatrix, FreeMatrix>;
using OwnedLinearSolver = Owned<SUNLinearSolver, FreeLinearSolver>;
using OwnedNonlinearSolver = Owned<SUNNonlinearSolver, FreeNonlinearSolver>;

/// One per run: contexts must not be shared between threads.
class SundialsContext {
 public:
  SundialsContext() {
#if SUNDIALS_VERSION_MAJOR >= 7
    if (SUNContext_Create(SUN_COMM_NULL, &context_) != 0) context_ = nullptr;
    if (context_) SUNContext_ClearErrHandlers(context_);
#else
    if (SUNContext_Create(nullptr, &context_) != 0) context_ = nullptr;
#endif
  }
  ~SundialsContext() {
    if (context_) SUNContext_Free(&context_);
  }
  SundialsContext(const SundialsContext&) = delete;
  SundialsContext& operator=(const SundialsContext&) = delete;
  operator SUNContext() const { return context_; }

  /// A vector that looks at somebody else's numbers.
  OwnedVector view(std::vector<double>& numbers) const {
    return OwnedVector(N_VMake_Serial(sunindextype(numbers.size()), numbers.data(), context_));
  }

 private:
  SUNContext context_ = nullptr;
};

/// The user data of every callback.
struct SundialsProblem {
  explicit SundialsProblem(const ErasedSystem<double>& system)
      : callee(system), shape(system.jacobian_shape()) {}

  Callee callee;
  MatrixShape shape;
  std::vector<double> band;

  static int rhs(sunrealtype t, N_Vector y, N_Vector dydt, void* p) {
    auto& me = *static_cast<SundialsProblem*>(p);
    return me.callee.rhs(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dydt)) ? 0 : -1;
  }
  static int jacobian(sunrealtype t, N_Vector y, N_Vector, SUNMatrix j, void* p, N_Vector, N_Vector,
                      N_Vector) {
    auto& me = *static_cast<SundialsProblem*>(p);
    return me.callee.jacobian(t, N_VGetArrayPointer(y), SUNDenseMatrix_Data(j)) ? 0 : -1;
  }
  static int band_jacobian(sunrealtype t, N_Vector y, N_Vector, SUNMatrix j, void* p, N_Vector, N_Vector,
                           N_Vector) {
    auto& me = *static_cast<SundialsProblem*>(p);
    if (!me.callee.band(t, N_VGetArrayPointer(y), me.band.data())) return -1;
    for (std::size_t column = 0; column < me.shape.size; ++column)
      std::copy_n(me.band.data() + column * me.shape.rows(), me.shape.rows(),
                  SUNBandMatrix_Column(j, sunindextype(column)) - sunindextype(me.shape.upper));
    return 0;
  }
};

/// What Newton's iteration of CVODE and ARKODE solves with: a band where the Jacobian is one as it stands,
/// else a whole matrix.
struct SundialsNewton {
  OwnedMatrix matrix;
  OwnedLinearSolver linear;
  CVLsJacFn jacobian = nullptr;

  /// Why there is none; empty where there is.
  static std::string_view obstacle(const ErasedSystem<double>& system) {
    if (is_band(system.jacobian_shape()) || system.size <= largest_moderate_size) return "";
    return "computes with whole matrices unless the Jacobian is banded as it stands: takes no more than 2000 "
           "components";
  }
  void set_up(SundialsProblem& problem, N_Vector y, SUNContext context) {
    const MatrixShape& shape = problem.shape;
    const auto size = sunindextype(shape.size);
    if (is_band(shape)) {
      problem.band.assign(shape.size * shape.rows(), 0.0);
      matrix.reset(SUNBandMatrix(size, sunindextype(shape.upper), sunindextype(shape.lower), context));
      linear.reset(SUNLinSol_Band(y, matrix.get(), context));
      jacobian = SundialsProblem::band_jacobian;
    } else {
      matrix.reset(SUNDenseMatrix(size, size, context));
      linear.reset(SUNLinSol_Dense(y, matrix.get(), context));
      if (problem.callee.has_jacobian()) jacobian = SundialsProblem::jacobian;
    }
  }

 private:
  static bool is_band(const MatrixShape& shape) { return !shape.is_dense() && !shape.interleaved; }
};

/// Instead of messages on stderr.
inline void say_nothing(int, const char*, const char*, char*, void*) {}

/// absolute_tolerance * scale_i, as the solvers want it.
inline std::vector<double> absolute_tolerances(const ErrorControl& control, std::size_t size) {
  std::vector<double> out(size, control.absolute_tolerance);
  if (control.scale)
    for (std::size_t i = 0; i < size; ++i) out[i] *= control.scale[i];
  return out;
}

/// CVODE's and ARKODE's flags agree where they overlap.
inline RunReport gave_up(RunReport report, int flag, const std::vector<double>& y, double t) {
  if (!all_finite(y)) return ended(report, RunStatus::not_finite, t);
  switch (flag) {
    case CV_TOO_MUCH_ACC:
      return ended(report, RunStatus::solver_failed, t, "asked for more accuracy than the machine has");
    case CV_ERR_FAILURE:
      return ended(report, RunStatus::solver_failed, t, "the error test failed too often in one step");
    case CV_CONV_FAILURE:
      return ended(report, RunStatus::newton_diverged, t,
                   "the nonlinear solver failed too often in one step");
    case CV_LSETUP_FAIL:
    case CV_LSOLVE_FAIL: return ended(report, RunStatus::newton_diverged, t, "the linear solver failed");
    case CV_TOO_CLOSE:
      return ended(report, RunStatus::solver_failed, t, "the interval is too short to start");
    case CV_ILL_INPUT: return ended(report, RunStatus::solver_failed, t, "refused the request as ill-posed");
    default: return ended(report, RunStatus::solver_failed, t, "failed for a reason of its own");
  }
}

}  // namespace odemark::contestant
