// The files of a report, from plain data. Apart from report.cpp, which sees methods and problems.
#pragma once

#include <string>

#include "bench/data/chapter.hpp"
#include "bench/data/facts.hpp"
#include "bench/data/pictures.hpp"
#include "bench/data/problem_sheet.hpp"
#include "bench/json_line.hpp"

namespace odemark {

/// Writes report.html, chapter.html, methods.html and a page per method, problems.html and a page per
/// family, report.md, svg/ and csv/ into the
/// folder of the results. Returns the sentence to print. Throws CannotWrite.
std::string write_report(Results results, Pictures pictures, const ChapterData& chapter,
                         const std::vector<FactSheet>& methods, const std::vector<ProblemSheet>& problems,
                         const std::string& folder, const std::string& title);

}  // namespace odemark
