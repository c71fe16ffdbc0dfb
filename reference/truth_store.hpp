// Stored solutions: what is in the files of reference/solutions, and whether it still belongs to the problem.
#pragma once

#include <span>

#include "reference/truth.hpp"
#include "reference/wide_problem.hpp"

namespace odemark {

/// A file of reference/solutions, built into the library so that it is found wherever the program runs.
struct StoredSolution {
  std::string_view preset, json;
};
/// Written by cmake/solutions.cmake.
std::span<const StoredSolution> stored_solutions();

/// What the stored numbers depend on, as 16 hexadecimal digits: family, every parameter and the initial state
/// to the last bit, and the right-hand side in wide arithmetic at two states, so that an edited equation is
/// noticed too.
std::string fingerprint(const AnyProblem& problem, const WideProblem& wide);

/// One file. `truth` is on the common grid.
std::string to_json(const Truth& truth, std::string_view preset, std::string_view fingerprint);
/// Throws std::runtime_error for a file that cannot be read or belongs to another problem.
Truth from_json(const AnyProblem& problem, std::string_view json, std::string_view fingerprint);

/// The stored truth of a preset, or null if there is none or its definition has changed since.
std::shared_ptr<const Truth> stored_truth(const AnyProblem& problem, std::string_view fingerprint);

/// Solves again up to `sample` of the stored times, spread over the interval and always with the last, and
/// compares. Returns what is wrong in one sentence, or nothing.
std::string verify(const AnyProblem& problem, const Truth& stored, std::size_t sample);

}  // namespace odemark
