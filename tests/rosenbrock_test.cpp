// Rosenbrock methods given a wrong Jacobian or a wrong df/dt: W-methods keep their order, the others lose it.
#include <gtest/gtest.h>

#include <cmath>

#include "integrators/catalogue.hpp"
#include "integrators/erase_method.hpp"
#include "integrators/rosenbrock_order.hpp"
#include "tests/support/probe_families.hpp"
#include "tests/support/runs.hpp"

namespace odemark::rosenbrock_test {
namespace {

template <class Kind>
concept IsRosenbrock = Kind::kind_name == std::string_view("Rosenbrock");

/// The system of a problem that lies about its derivatives.
struct Misled {
  const ErasedSystem<long double>& honest;
  long double matrix_error, time_error;

  ErasedSystem<long double> view() const {
    auto out = honest;
    out.self = this;
    out.rhs_call = [](const void* p, long double t, const long double* y, long double* dydt) {
      of(p).honest.rhs_call(of(p).honest.self, t, y, dydt);
    };
    out.jacobian_call = [](const void* p, long double t, const long double* y, long double* j) {
      const auto& me = of(p);
      me.honest.jacobian_call(me.honest.self, t, y, j);
      for (std::size_t i = 0; i < me.honest.size * me.honest.size; ++i)
        j[i] +=
            me.matrix_error * (j[i] / 4 + static_cast<long double>(i + 1) / 8);  // in no direction of its own
    };
    out.time_derivative_call = [](const void* p, long double t, const long double* y, long double* dfdt) {
      const auto& me = of(p);
      me.honest.time_derivative_call(me.honest.self, t, y, dfdt);
      for (std::size_t i = 0; i < me.honest.size; ++i)
        dfdt[i] += me.time_error * static_cast<long double>(i + 1) / 4;
    };
    return out;
  }
  static const Misled& of(const void* p) { return *static_cast<const Misled*>(p); }
};

/// log2 of the ratio of the errors of 400 and 800 steps: far from both ends of the ladder, in wide
/// arithmetic.
double slope(const AnyMethod& method, const AnyProblem& problem, long double matrix_error,
             long double time_error) {
  const Misled misled{problem.system<long double>(), matrix_error, time_error};
  const auto system = misled.view();
  double error[2];
  for (int i = 0; i < 2; ++i) {
    std::vector<long double> y(problem.initial.begin(), problem.initial.end());
    const auto report = method.runs<long double>().solve(system, FixedSteps{i == 0 ? 400L : 800L},
                                                         problem.t_begin, problem.t_end, y);
    EXPECT_EQ(report.status, RunStatus::reached_end);
    const long double t = static_cast<long double>(problem.t_end);
    error[i] = double(std::hypot(y[0] - std::sin(t), y[1] - std::cos(t)));
  }
  return std::log2(error[0] / error[1]);
}

template <const auto& method>
int check() {
  if constexpr (IsRosenbrock<KindOf<method>>) {
    SCOPED_TRACE(method.id);
    const AnyMethod& erased = suite_method(method.id);
    constexpr int whatever = w_order(method.alpha, method.gamma, method.b, method.order);
    const auto problem = probe::problem<probe::Driven>("t_end=2");
    const double exact = slope(erased, problem, 0, 0), wrong_matrix = slope(erased, problem, 1, 0),
                 wrong_time = slope(erased, problem, 0, 1);
    std::printf(
        "%-18s order %d observed %.2f; with a wrong matrix claimed %d observed %.2f, wrong df/dt %.2f\n",
        std::string(method.id).c_str(), method.order, exact, whatever, wrong_matrix, wrong_time);
    EXPECT_NEAR(exact, method.order, 0.25);
    EXPECT_EQ(method.w_method, whatever == method.order);
    EXPECT_NEAR(wrong_matrix, whatever, 0.25);
    // df/dt is one column of the matrix of (t, y): it may do less harm than a wrong matrix, never more
    EXPECT_GE(wrong_time, whatever - 0.25);
    return 1;
  } else {
    return 0;
  }
}

template <const auto&... methods>
int check_all(MethodList<methods...>) {
  return (check<methods>() + ...);
}

TEST(Rosenbrock, OnlyWMethodsKeepTheirOrderWithAWrongJacobian) { EXPECT_GE(check_all(SuiteMethods{}), 10); }

TEST(Rosenbrock, OneWrongDigitIsSeen) {
  const auto with = [](auto change) {
    auto m = rodas4;
    change(m);
    return m;
  };
  EXPECT_TRUE(orders_hold(rodas4));
  EXPECT_FALSE(orders_hold(with([](auto& m) { m.alpha[3][1] += 1e-12L; })));
  EXPECT_FALSE(orders_hold(with([](auto& m) { m.gamma[4][0] += 1e-12L; })));
  EXPECT_FALSE(orders_hold(with([](auto& m) { std::swap(m.b[0], m.b[1]); })));
  EXPECT_FALSE(orders_hold(with([](auto& m) { m.b_embedded = m.b; })));
  EXPECT_FALSE(orders_hold(with([](auto& m) { m.order = 3; })));
  EXPECT_FALSE(orders_hold(with([](auto& m) { m.w_method = true; })));
  auto silent = ros34pw2;
  silent.w_method = false;
  EXPECT_FALSE(orders_hold(silent));
  auto slightly = ros34pw2;  // still of order 3 with the exact Jacobian: beta is untouched, f'f is not
  slightly.gamma[2][0] += 1e-9L, slightly.alpha[2][0] -= 1e-9L;
  EXPECT_FALSE(orders_hold(slightly));
}

constexpr auto no_w_method = [] {
  auto m = ros34pw2;  // still of order 3 with the exact Jacobian: alpha + gamma and the nodes are untouched
  m.id = "no_w_method";
  m.gamma[2][0] += 0.05L, m.gamma[2][1] -= 0.05L;
  m.alpha[2][0] -= 0.05L, m.alpha[2][1] += 0.05L;
  return m;
}();

/// The same, seen in steps: with a wrong matrix it falls to order 2 where the right one keeps order 3.
TEST(Rosenbrock, AWMethodThatIsNoneLosesItsOrderWithAWrongJacobian) {
  const auto problem = probe::problem<probe::Driven>("t_end=2");
  const AnyMethod spoiled = erase_method<no_w_method>();
  EXPECT_NEAR(slope(spoiled, problem, 0, 0), 3, 0.25);
  EXPECT_LT(slope(spoiled, problem, 1, 0), 2.5);
  EXPECT_NEAR(slope(suite_method("ros34pw2"), problem, 1, 0), 3, 0.25);
}

/// A stiff problem driven in time, y' = l (y - cos t) - sin t: without h gamma_i f_t the order falls to 1.
struct Prothero {
  using State = std::array<double, 1>;
  bool with_time_derivative;
  void rhs(double t, const State& y, State& dydt) const {
    dydt[0] = -50 * (y[0] - std::cos(t)) - std::sin(t);
  }
  void jacobian(double, const State&, MatrixView<double> j) const { j(0, 0) = -50; }
  void time_derivative(double t, const State&, State& dfdt) const {
    dfdt[0] = with_time_derivative ? -50 * std::sin(t) - std::cos(t) : 0;
  }
};
/// The same without a derivative of its own: a forward difference stands in.
struct PlainProthero {
  using State = std::array<double, 1>;
  void rhs(double t, const State& y, State& dydt) const {
    dydt[0] = -50 * (y[0] - std::cos(t)) - std::sin(t);
  }
  void jacobian(double, const State&, MatrixView<double> j) const { j(0, 0) = -50; }
};

template <class P>
double end_error(const P& system, long steps) {
  typename P::State y{1};
  EXPECT_EQ(solve<rodas4>(system, Control(FixedSteps{steps}), 0, 1, y).status, RunStatus::reached_end);
  return std::abs(y[0] - std::cos(1.0));
}

TEST(Rosenbrock, TheTimeDerivativeIsNeededAndTaken) {
  EXPECT_LT(end_error(Prothero{true}, 100), 1e-8);
  EXPECT_GT(end_error(Prothero{false}, 100), 1e-5);
  EXPECT_GT(std::log2(end_error(Prothero{true}, 100) / end_error(Prothero{true}, 200)), 3);
  EXPECT_LT(std::log2(end_error(Prothero{false}, 100) / end_error(Prothero{false}, 200)), 1.5);
  EXPECT_NEAR(end_error(PlainProthero{}, 100), end_error(Prothero{true}, 100), 1e-9);
}

TEST(Rosenbrock, ATimeDerivativeCountsAsOneEvaluation) {
  for (const auto& [problem, extra] :
       {std::pair{suite_problem("van_der_pol_mu1"), 0L}, std::pair{probe::problem<probe::Driven>(), 1L}}) {
    WorkCounts work;
    const CountingSystem<double> counting(problem.system<double>(), work);
    std::vector<double> y = problem.initial;
    suite_method("rodas4").runs<double>().solve(counting.view(), FixedSteps{7}, 0, 1, y);
    EXPECT_EQ(work.rhs, 7 * (6 + extra)) << problem.id;
    EXPECT_EQ(work.jacobian, 7);
  }
}

}  // namespace
}  // namespace odemark::rosenbrock_test
