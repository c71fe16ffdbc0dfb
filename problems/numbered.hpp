// Names of the components of a large system: u1, u2, ...
#pragma once
#include <utility>

#include "problems/family.hpp"

namespace odemark {

/// A short text as a template argument.
template <std::size_t N>
struct Stem {
  char text[N]{};
  constexpr Stem(const char (&from)[N]) {
    for (std::size_t i = 0; i < N; ++i) text[i] = from[i];
  }
};

namespace numbered_detail {

struct Text {
  char letters[16]{};
  std::size_t length = 0;
};

template <Stem stem, std::size_t number>
inline constexpr Text text = [] {
  Text made;
  for (std::size_t i = 0; stem.text[i] != 0; ++i) made.letters[made.length++] = stem.text[i];
  std::size_t power = 1;
  while (number / power >= 10) power *= 10;
  for (; power > 0; power /= 10) made.letters[made.length++] = char('0' + number / power % 10);
  return made;
}();

}  // namespace numbered_detail

/// stem1, stem2, ... of the same unit.
template <Stem stem, std::size_t count>
constexpr std::array<Component, count> numbered(std::string_view unit) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    using numbered_detail::text;
    return std::array<Component, count>{
        Component{{text<stem, i + 1>.letters, text<stem, i + 1>.length}, unit}...};
  }
  (std::make_index_sequence<count>());
}

/// One list of components after the other.
template <std::size_t... sizes>
constexpr auto joined(const std::array<Component, sizes>&... lists) {
  std::array<Component, (sizes + ...)> all{};
  std::size_t at = 0;
  const auto append = [&](const auto& list) {
    for (const Component& component : list) all[at++] = component;
  };
  (append(lists), ...);
  return all;
}

}  // namespace odemark
