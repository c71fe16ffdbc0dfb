// The bench of the chapter page: a method by name, stepped on a problem by name, next to the closed form.
#pragma once

#include <cmath>
#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/data/chapter.hpp"
#include "integrators/any_method.hpp"
#include "reference/any_problem.hpp"

namespace odemark::chapter {

inline constexpr double table_dt = 0.5;  // s, the step of Table 7-1

/// Throws std::logic_error for an id that the catalogue lacks: the page is made for methods it has.
const AnyMethod& method_called(std::string_view id);
AnyProblem problem_called(std::string_view id, std::string_view settings = "");

/// The closed form a time `h` after the state y0 at `from`, of a drag_ship, drag_ship_quadratic or
/// oscillator.
template <class T>
std::vector<T> exact_flow(const AnyProblem& problem, T h, const std::vector<T>& y0, T from = 0);
template <class T>
std::vector<T> initial_state(const AnyProblem& problem);

/// What happened in a run: the state it ended with, how far it came, and what it evaluated.
template <class T>
struct Stepped {
  std::vector<T> y;
  RunReport report;
  long evaluations = 0;
};

template <class T>
using OnStep = std::function<bool(T t, const T* y)>;

/// `count` steps of dt from the problem's initial state; `on_step` may end it.
template <class T>
Stepped<T> step(const AnyMethod& method, const AnyProblem& problem, double dt, long count,
                OnStep<T> on_step = {});
template <class T>
Stepped<T> adapt(const AnyMethod& method, const AnyProblem& problem, const ErrorControl& control,
                 double t_end, OnStep<T> on_step = {});

/// Evaluations of the right-hand side in one step, counted.
int evaluations_per_step(const AnyMethod& method, const AnyProblem& problem);

/// Component `i` along `count` steps of dt, the start included.
Trajectory stepped_curve(std::string_view method, const AnyProblem& problem, std::size_t i, double dt,
                         long count);
Trajectory exact_curve(const AnyProblem& problem, std::size_t i, double from, double to, int points);

/// R(z) of a Runge-Kutta method from its own coefficients.
std::complex<long double> stability_function(const AnyMethod& method, std::complex<long double> z);

/// The spectral radius of the matrix (a b; c d).
long double spectral_radius(long double a, long double b, long double c, long double d);

inline constexpr double pi = 3.14159265358979323846;

// the parts of the page
std::vector<ChapterTable> table_7_1();
std::vector<ChapterFigure> figures(double k, double m, double dt);
std::vector<LocalError> local_errors();
std::vector<ListingHash> listing_hashes();
std::vector<FaceRun> faces();
std::vector<GrowthPoint> growth();
std::vector<Stall> stalls();
std::vector<LimitLine> limits();
std::vector<ErrorCurve> error_curves();
std::vector<ClockLine> clocks();
std::vector<SameStep> same_step(const std::vector<ErrorCurve>& curves);
std::vector<Crossover> crossovers(const std::vector<ErrorCurve>& curves);
std::vector<CostLine> costs(const std::vector<ErrorCurve>& curves);
std::vector<DoublingLine> doublings();
std::vector<EqualCostLine> equal_cost();
ListingOnSpring listing_on_spring();
std::vector<MemoryLine> memory();
std::vector<AdaptiveRun> adaptive_runs();
ZeroEstimate zero_estimate();
Answer answer(int claim, const ChapterData& data);

}  // namespace odemark::chapter
