// What the readers and writers of results lines share.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

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
template <class T>
std::optional<T> maybe(const Json& j, const char* key) {
  const auto found = j.find(key);
  return found == j.end() || found->is_null() ? std::nullopt : std::optional<T>(found->template get<T>());
}

/// Throws std::invalid_argument for what is no stability row.
StabilityRow stability_from(const Json& j);

}  // namespace odemark::json
