// The chapter page: the book's table, its figures and its seven claims, each beside our measurement.
#pragma once

#include "bench/data/chapter.hpp"
#include "reports/html.hpp"

namespace odemark {

/// Throws std::invalid_argument if the data lack a measurement that a sentence needs.
Page chapter_page(const ChapterData& data);

}  // namespace odemark
