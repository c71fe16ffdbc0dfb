// One word for what became of a run or a limit, and whether a filter shows it.
#pragma once

#include <string_view>

#include "reports/compare.hpp"

namespace odemark {

enum class Fate { same, changed, improved, regressed };

struct FateWord {
  std::string_view word;
  Status status;
};
inline FateWord in_words(Fate fate) {
  switch (fate) {
    case Fate::same: return {"same", Status::muted};
    case Fate::changed: return {"changed", Status::note};
    case Fate::improved: return {"improved", Status::ok};
    case Fate::regressed: return {"regressed", Status::fail};
  }
  return {"", Status::plain};
}

inline bool is_shown(Fate fate, CompareFilter filter) {
  switch (filter) {
    case CompareFilter::all: return true;
    case CompareFilter::regressed: return fate == Fate::regressed;
    case CompareFilter::improved: return fate == Fate::improved;
    case CompareFilter::changed: return fate != Fate::same;
  }
  return true;
}

inline void count_fate(Comparison& comparison, Fate fate) {
  switch (fate) {
    case Fate::same: ++comparison.same; break;
    case Fate::changed: ++comparison.changed; break;
    case Fate::improved: ++comparison.improved; break;
    case Fate::regressed: ++comparison.regressed; break;
  }
}

}  // namespace odemark
