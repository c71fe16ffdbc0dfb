// A problem whose type is gone: what truths, contestants, benches and the command line see of a family.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "integrators/integrate_events.hpp"
#include "problems/family.hpp"
#include "reference/settings.hpp"

namespace odemark {

/// Components whose names may be made at run time; `letters` holds those.
struct ComponentNames {
  std::shared_ptr<const std::string> letters;
  std::vector<Component> all;
};
/// stem1, stem2, ... of every group, each an equal part of `size`.
ComponentNames numbered_components(std::span<const Component> groups, std::size_t size);

/// Above this many components a solution is compared at some of them and at its end alone.
inline constexpr std::size_t largest_compared_size = 256;

struct ParameterInfo {
  std::string_view name, unit, meaning;
  Range range;
  double value = 0;        // of this problem; of the default preset in a family
  bool shorthand = false;  // sets other parameters; has no value of its own
};

/// One problem: a family with every parameter given. Copies share the family value.
struct AnyProblem {
  std::string id;      // of the preset, or "oscillator{k=4}" where the user set something
  std::string preset;  // the preset it started from
  std::string preset_settings, user_settings;
  bool customised = false;  // the user set something
  std::string_view family, title, equations, source, about;

  std::vector<Component> components;
  std::vector<ParameterInfo> parameters;
  double t_begin = 0, t_end = 0, suggested_dt = 0;
  std::vector<double> initial, scale;
  std::vector<double> switch_times;  // where the right-hand side jumps
  std::vector<std::string_view> event_names;
  std::vector<std::string_view> invariant_names;
  unsigned abilities = 0;
  bool has_exact = false, has_written_jacobian = false;

  std::shared_ptr<const void> value;  // the Family<double>
  std::tuple<ErasedSystem<float>, ErasedSystem<double>, ErasedSystem<long double>> systems;
  std::tuple<Pieces<float>, Pieces<double>, Pieces<long double>> pieces_by_type;
  void (*invariants_call)(const void*, const long double* y, long double* out) = nullptr;
  Oscillation (*oscillation_call)(const void*, const double* y) = nullptr;
  /// Linear families: the same problem with every drive removed, so that 0 is a fixed point.
  std::shared_ptr<const AnyProblem> homogeneous;

  std::size_t size() const { return initial.size(); }
  bool is_large() const { return size() > largest_compared_size; }
  /// One smooth piece: nothing switches and nothing happens.
  bool smooth() const { return switch_times.empty() && event_names.empty(); }
  /// Valid as long as this problem or a copy of it lives. T is float, double or long double.
  template <class T>
  const ErasedSystem<T>& system() const {
    return std::get<ErasedSystem<T>>(systems);
  }
  template <class T>
  const Pieces<T>& pieces() const {
    return std::get<Pieces<T>>(pieces_by_type);
  }
};

/// Fills in which preset this is and what the user changed.
void name_problem(AnyProblem& problem, const Preset& preset, const std::vector<Setting>& user);

/// A family whose type is gone.
struct AnyFamily {
  std::string_view id, title, equations, source;
  std::vector<Component> components;
  std::vector<Preset> presets;
  std::vector<ParameterInfo> parameters;  // defaults of the first preset, then shorthands
  std::vector<std::string_view> invariant_names, event_names;
  unsigned abilities = 0;
  bool has_exact = false;
  /// Throws BadInput for an unknown parameter or a value out of range.
  AnyProblem (*create)(const Preset& preset, const std::vector<Setting>& user) = nullptr;
};

/// Every family of problems/catalogue.txt, in its order.
const std::vector<AnyFamily>& suite_families();

/// The preset or family called `id` with the user's settings on top; throws BadInput with the nearest name.
AnyProblem find_problem(const std::vector<AnyFamily>& families, std::string_view id,
                        std::string_view settings = "");

/// Ids of all presets, in catalogue order.
std::vector<std::string> problem_ids(const std::vector<AnyFamily>& families);

}  // namespace odemark
