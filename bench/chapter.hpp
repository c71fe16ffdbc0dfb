// The chapter page's numbers: every one of them from a method of the catalogue, stepped now.
#pragma once

#include "bench/data/chapter.hpp"

namespace odemark {

/// Takes some seconds. Throws std::logic_error if the catalogues lack a method or a problem of the chapter.
ChapterData chapter_data();

}  // namespace odemark
