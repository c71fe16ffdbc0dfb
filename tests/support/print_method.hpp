// How GoogleTest names a method in what it prints.
#pragma once

#include <ostream>

#include "integrators/any_method.hpp"

namespace odemark {

inline void PrintTo(const AnyMethod& method, std::ostream* out) { *out << method.id; }

}  // namespace odemark
