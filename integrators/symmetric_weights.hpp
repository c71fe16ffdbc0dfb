// The rows of drifts and kicks of symmetric splittings from the weights that are independent.
#pragma once

#include "integrators/stepper.hpp"

namespace odemark {

/// Weights that read the same backwards and add up to 1, from the outermost inwards: `Count` of them, at
/// [Offset, Offset + Count) of a row of `Length`. What is missing to 1 goes to the middle one or the middle
/// two.
template <std::size_t Length, std::size_t Count, std::size_t Offset = 0, std::size_t Given>
constexpr std::array<Coefficient, Length> mirrored(const std::array<Coefficient, Given>& outer) {
  static_assert(Offset + Count <= Length && (Count == 2 * Given + 1 || Count == 2 * Given + 2));
  constexpr std::size_t middles = Count - 2 * Given;
  std::array<Coefficient, Length> row{};
  Coefficient rest = 1;
  for (std::size_t i = 0; i < Given; ++i) {
    row[Offset + i] = row[Offset + Count - 1 - i] = outer[i];
    rest -= 2 * outer[i];
  }
  for (std::size_t i = 0; i < middles; ++i) row[Offset + Given + i] = rest / Coefficient(middles);
  return row;
}

/// Kicks of the symmetric composition of 2 Outer + 1 drift-kick-drift steps with these weights (H. Yoshida,
/// Phys. Lett. A 150 (1990) 262-268, eq. 4.1), the middle one what is missing to 1.
template <std::size_t Outer>
constexpr std::array<Coefficient, 2 * Outer + 2> composed_kicks(
    const std::array<Coefficient, Outer>& weights) {
  return mirrored<2 * Outer + 2, 2 * Outer + 1>(weights);
}

/// The drifts between them: neighbouring half drifts are one.
template <std::size_t Outer>
constexpr std::array<Coefficient, 2 * Outer + 2> composed_drifts(
    const std::array<Coefficient, Outer>& weights) {
  const auto kicks = composed_kicks(weights);
  std::array<Coefficient, 2 * Outer + 2> row{};
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = (kicks[i] + (i > 0 ? kicks[i - 1] : 0)) / 2;
  return row;
}

}  // namespace odemark
