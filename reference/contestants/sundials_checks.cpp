// Measures four traits of the SUNDIALS at hand that decide what its numbers mean.
#include <chrono>

#include "reference/contestants/checks.hpp"
#include "reference/contestants/sundials_arkode.hpp"
#include "reference/contestants/sundials_methods.hpp"

namespace odemark::contestant {
namespace {

/// Best of many, in seconds: on a busy machine only the minimum means something.
template <class F>
double fastest(int repetitions, F&& f) {
  double best = 1e300;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    f();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

/// The same loop one number at a time, however this binary is compiled: an optimised library is no slower.
[[gnu::noinline]] void linear_sum(double a, const double* x, double b, const double* y, double* z,
                                  std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    asm volatile("" : "+r"(i));  // no vectors
    z[i] = a * x[i] + b * y[i];
  }
}

/// An optimised library takes about as long as the loop here; Debian's about 2.7 times as long.
constexpr double unoptimised_above = 1.7;

struct ErkOwner {
  void* memory;
  ~ErkOwner() { ERKStepFree(&memory); }
};
struct ArkOwner {
  void* memory;
  ~ArkOwner() { ARKStepFree(&memory); }
};

int decay(sunrealtype, N_Vector y, N_Vector dydt, void*) {
  N_VScale(-1e-3, y, dydt);
  return 0;
}
int ones(N_Vector, N_Vector weights, void*) {
  N_VConst(1, weights);
  return 0;
}

/// Twenty fixed steps of a large state below 1: seconds, and the error weight the library used.
std::pair<double, double> fixed_steps(bool own_weights) {
  SundialsContext context;
  double weight = 0;
  const double seconds = fastest(9, [&] {
    std::vector<double> numbers(2000, 0.3), used(2000);
    const auto y = context.view(numbers), weights = context.view(used);
    ErkOwner erk{ERKStepCreate(decay, 0, y.get(), context)};
    if (own_weights) ERKStepWFtolerances(erk.memory, ones);
    ERKStepSetTableNum(erk.memory, ARKODE_HEUN_EULER_2_1_2);
    ERKStepSetFixedStep(erk.memory, 0.01);
    double t = 0;
    for (int i = 0; i < 20; ++i) ERKStepEvolve(erk.memory, 1, y.get(), &t, ARK_ONE_STEP);
    ERKStepGetErrWeights(erk.memory, weights.get());
    weight = used[0];
  });
  return {seconds, weight};
}

int robertson(sunrealtype, N_Vector y, N_Vector dydt, void*) {
  const double* s = N_VGetArrayPointer(y);
  double* d = N_VGetArrayPointer(dydt);
  d[0] = -0.04 * s[0] + 1e4 * s[1] * s[2];
  d[2] = 3e7 * s[1] * s[1];
  d[1] = -d[0] - d[2];
  return 0;
}
int robertson_jacobian(sunrealtype, N_Vector y, N_Vector, SUNMatrix matrix, void*, N_Vector, N_Vector,
                       N_Vector) {
  const double* s = N_VGetArrayPointer(y);
  double* j = SUNDenseMatrix_Data(matrix);
  const double columns[9] = {-0.04,      0.04,       0,           1e4 * s[2], -1e4 * s[2] - 6e7 * s[1],
                             6e7 * s[1], 1e4 * s[1], -1e4 * s[1], 0};
  std::copy(columns, columns + 9, j);
  return 0;
}

/// Steps that ARKODE's default fourth-order DIRK takes on Robertson's problem to t = 400 at 1e-4.
long robertson_steps(double newton_constant) {
  SundialsContext context;
  std::vector<double> numbers{1, 0, 0};
  const auto y = context.view(numbers);
  const OwnedMatrix matrix(SUNDenseMatrix(3, 3, context));
  const OwnedLinearSolver linear(SUNLinSol_Dense(y.get(), matrix.get(), context));
  ArkOwner ark{ARKStepCreate(nullptr, robertson, 0, y.get(), context)};
#if SUNDIALS_VERSION_MAJOR < 7
  ARKStepSetErrHandlerFn(ark.memory, say_nothing, nullptr);
#endif
  ARKStepSStolerances(ark.memory, 1e-4, 1e-8);
  ARKStepSetOrder(ark.memory, 4);
  ARKStepSetLinearSolver(ark.memory, linear.get(), matrix.get());
  ARKStepSetJacFn(ark.memory, robertson_jacobian);
  if (newton_constant > 0) ARKStepSetNonlinConvCoef(ark.memory, newton_constant);
  if (newton_constant > 0) ARKStepSetMaxNonlinIters(ark.memory, 10);
  ARKStepSetMaxNumSteps(ark.memory, 100'000);
  ARKStepSetStopTime(ark.memory, 400);
  double t = 0;
  ARKStepEvolve(ark.memory, 400, y.get(), &t, ARK_NORMAL);
  long steps = 0;
  ARKStepGetNumStepAttempts(ark.memory, &steps);
  return steps;
}

LibraryCheck unoptimised() {
  LibraryCheck check{
      "sundials_unoptimised",
      "sundials",
      sundials_slowdown() > unoptimised_above,
      "N_VLinearSum takes " + two_digits(sundials_slowdown()) + " times as long as the same loop here",
      {"cvode_adams", "cvode_bdf", "arkode_erk_dormand_prince54", "arkode_erk_rk4", "arkode_ark_rk4",
       "arkode_dirk_sdirk21", "arkode_dirk_sdirk43", "arkode_dirk_esdirk43", "arkode_dirk_esdirk54"},
      "This SUNDIALS is compiled without optimisation (Debian's is): compiled with -O3 it is 2 to 6 "
      "times faster. Its times say nothing about its methods."};
  if (sundials_slowdown() == 0) check.measured = "not measured: this binary is not optimised itself";
  return check;
}

LibraryCheck order_loss() {
  std::vector<AnyMethod> methods;
  add_arkode(methods);
  const auto order = observed_order(methods[1], methods[0], 0.3, 128);
  const auto as_written = observed_order(methods[2], methods[0], 0.3, 128);
  return {"erkstep_order_loss",
          "sundials",
          order < 3.5,
          "classical RK4: order " + two_digits(order) + " through ERKStep, " + two_digits(as_written) +
              " through ARKStep",
          {"arkode_erk_rk4"},
          "ERKStep takes every table whose last node is 1 for first-same-as-last and loses an order on those "
          "that "
          "are not."};
}

LibraryCheck denormals() {
  const auto [theirs, weight] = fixed_steps(false);
  const auto [ours, one] = fixed_steps(true);
  const bool smallest = weight < 1e-300;
  return {"sundials_fixed_step_denormals",
          "sundials",
          smallest,
          std::string("its error weight in fixed explicit steps is ") +
              (smallest ? "the smallest normal number" : "no denormal's cause") +
              "; 2000 numbers below 1 take " + two_digits(theirs / ours) +
              " times as long as with weights of 1",
          {},
          "In fixed explicit steps SUNDIALS weighs errors with the smallest normal number, and a norm of "
          "denormals is "
          "slow. No row here pays for it: the suite sets the weights."};
}

LibraryCheck newton_constant() {
  const long untuned = robertson_steps(0), tuned = robertson_steps(1e-5);
  return {"arkode_newton_constant",
          "sundials",
          untuned > 2 * tuned,
          "Robertson to t = 400 at 1e-4: " + std::to_string(untuned) +
              " steps with the default Newton constant, " + std::to_string(tuned) + " with 1e-5",
          {"arkode_dirk_sdirk21", "arkode_dirk_sdirk43", "arkode_dirk_esdirk43", "arkode_dirk_esdirk54"},
          "ARKODE's implicit methods run with a Newton constant of 1e-5 here, not the default 0.1."};
}

}  // namespace

double sundials_slowdown() {
#if defined(__OPTIMIZE__)
  static const double ratio = [] {
    constexpr std::size_t n = 1000;
    SundialsContext context;
    std::vector<double> x(n, 0.3), y(n, 0.7), z(n);
    const auto xv = context.view(x), yv = context.view(y), zv = context.view(z);
    const double theirs = fastest(200, [&] { N_VLinearSum(0.5, xv.get(), 2.0, yv.get(), zv.get()); });
    const double ours = fastest(200, [&] {
      for (int i = 0; i < 8; ++i) linear_sum(0.5, x.data(), 2.0 + i, y.data(), z.data(), n);
    });
    return theirs / (ours / 8);
  }();
  return ratio;
#else
  return 0;
#endif
}

void add_sundials_checks(std::vector<LibraryCheck>& checks) {
  checks.push_back(unoptimised());
  checks.push_back(order_loss());
  checks.push_back(denormals());
  checks.push_back(newton_constant());
}

ProviderInfo sundials_provider() {
  char version[64] = "";
  SUNDIALSGetVersion(version, sizeof version);
  const double ratio = sundials_slowdown();
  const std::string measured = " (N_VLinearSum: " + two_digits(ratio) + " times the same loop here)";
  if (ratio == 0) return {"sundials", version, "not measured: this binary is not optimised itself"};
  return {"sundials", version, (ratio > unoptimised_above ? "without optimisation" : "optimised") + measured};
}

}  // namespace odemark::contestant
