// Rosenbrock coefficients in the form that steps: no product of the Jacobian with a vector.
#pragma once

#include "integrators/stepper.hpp"

namespace odemark {

/// With U = Gamma K the stages become (I - h g J) u_i = g (h f(t + c_i h, y + sum a_ij u_j) + sum c_ij u_j +
/// h^2 gamma_i f_t), y+ = y + sum m_j u_j (E. Hairer, G. Wanner, Solving ODEs II, IV.7, eq. 7.25), where g is
/// the diagonal of Gamma. Everything is derived; what rounding left of a whole number is that number.
template <std::size_t S>
struct RosenbrockForm {
  using Row = std::array<Coefficient, S>;
  using Matrix = std::array<Row, S>;

  Coefficient diagonal{};
  Matrix argument{};  // a_ij = (alpha Gamma^-1)_ij
  Matrix coupling{};  // g c_ij, C = 1/g - Gamma^-1
  Row node{};         // c_i, row sums of alpha
  Row time{};         // g gamma_i, gamma_i row sums of Gamma
  Row weight{};       // m = b Gamma^-1
  Row error{};        // (b - b_embedded) Gamma^-1

  constexpr RosenbrockForm(const Matrix& alpha, const Matrix& gamma, const Row& b, const Row& b_embedded)
      : diagonal(gamma[0][0]) {
    Matrix inverse{};
    for (std::size_t j = 0; j < S; ++j)
      for (std::size_t i = j; i < S; ++i) {
        Coefficient sum = i == j ? 1 : 0;
        for (std::size_t k = j; k < i; ++k) sum -= gamma[i][k] * inverse[k][j];
        inverse[i][j] = sum / gamma[i][i];
      }
    for (std::size_t i = 0; i < S; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        node[i] += alpha[i][j], time[i] += gamma[i][j];
        for (std::size_t k = j; k < S; ++k) argument[i][j] += alpha[i][k] * inverse[k][j];
        argument[i][j] = whole(argument[i][j]);
        if (j < i) coupling[i][j] = whole(-diagonal * inverse[i][j]);
        weight[j] += b[i] * inverse[i][j];
        error[j] += (b[i] - b_embedded[i]) * inverse[i][j];
      }
    for (std::size_t i = 0; i < S; ++i) {
      node[i] = whole(node[i]), time[i] = whole(time[i]) * diagonal;
      weight[i] = whole(weight[i]), error[i] = whole(error[i]);
    }
  }

  /// Stage i asks for f where stage i - 1 did.
  constexpr bool repeats(std::size_t i) const { return i > 0 && continues(argument[i], i, 0); }
  /// The argument of stage i is that of stage i - 1 plus u_(i-1).
  constexpr bool extends(std::size_t i) const { return i > 0 && continues(argument[i], i, 1); }
  /// y+ is the argument of the last stage plus its u.
  constexpr bool ends_extended() const { return continues(weight, S, 1); }
  /// The last stage asks for f(t + h, y+): the first slope of the next step.
  constexpr bool first_same_as_last() const {
    if (!near(node[S - 1], 1)) return false;
    for (std::size_t j = 0; j < S; ++j)
      if (!near(argument[S - 1][j], weight[j])) return false;
    return S > 1;
  }
  constexpr bool needs_time_derivative() const {
    for (const Coefficient t : time)
      if (t != 0) return true;
    return false;
  }

 private:
  static constexpr bool near(Coefficient x, Coefficient y) {
    const Coefficient gap = x - y, size = (y < 0 ? -y : y) + 1;
    return gap <= 1e-16L * size && gap >= -1e-16L * size;
  }
  static constexpr Coefficient whole(Coefficient x) {
    if (x > 1000 || x < -1000) return x;
    const Coefficient n = static_cast<Coefficient>(static_cast<long>(x < 0 ? x - 0.5L : x + 0.5L));
    return near(x, n) ? n : x;
  }
  /// `row` equals the argument of stage i - 1, with `last` as its entry for that stage.
  constexpr bool continues(const Row& row, std::size_t i, Coefficient last) const {
    for (std::size_t j = 0; j + 1 < i; ++j)
      if (!near(row[j], argument[i - 1][j])) return false;
    return row[i - 1] == last;
  }
};

}  // namespace odemark
