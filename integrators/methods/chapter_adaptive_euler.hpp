#pragma once
#include "integrators/chapter_adaptive.hpp"

namespace odemark {

inline constexpr ChapterAdaptive chapter_adaptive_euler{
    .id = "chapter_adaptive_euler",
    .source = "the source chapter's adaptive listing, as printed",
    .order = 1,
    .embedded_order = 1,
};

}  // namespace odemark
