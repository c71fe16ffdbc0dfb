// What the readers and writers of results lines share.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "bench/data/stability.hpp"

namespace odemark::json {

using Json = nlohmann::ordered_json;  // keys stay in the order of the schema, so that files diff well

/// NaN and infinity have no JSON; the status of a row says what happened, so such values are left out.
inline void put(Json& j, const char* key, double value) {
  if (std::isfinite(value)) j[key] = value;
}
template <class T>
void put(Json& j, const char* key, const std::optional<T>& value) {
  if (!value) return;
  if constexpr (std::is_floating_point_v<T>)
    put(j, key, *value);
  else
    j[key] = *value;
}
inline void put(Json& j, const char* key, const std::string& text) {
  if (!text.empty()) j[key] = text;
}

inline double number(const Json& j, const char* key) { return j.value(key, 0.0); }
inline std::string text(const Json& j, const char* key) { return j.value(key, std::string()); }
/// A whole number that T holds. The library would cast whatever is there: 1e99 to an int is undefined.
template <class T>
T whole_from(const Json& value, const char* key) {
  if (value.is_number_unsigned() && std::in_range<T>(value.get<std::uint64_t>())) return value.get<T>();
  if (value.is_number_integer() && !value.is_number_unsigned() && std::in_range<T>(value.get<std::int64_t>()))
    return value.get<T>();
  throw std::invalid_argument(std::string("\"") + key + "\" is not a whole number in range");
}
/// 0 where it is missing.
template <class T = long>
T whole(const Json& j, const char* key) {
  const auto found = j.find(key);
  return found == j.end() ? T(0) : whole_from<T>(*found, key);
}
template <class T>
std::optional<T> maybe(const Json& j, const char* key) {
  const auto found = j.find(key);
  if (found == j.end() || found->is_null()) return std::nullopt;
  if constexpr (std::is_integral_v<T>)
    return whole_from<T>(*found, key);
  else
    return found->template get<T>();
}

/// Throws std::invalid_argument for what is no stability row.
StabilityRow stability_from(const Json& j);

}  // namespace odemark::json
