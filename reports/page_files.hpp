// A page as other files: Markdown, and its pictures and tables by name.
#pragma once

#include <string>
#include <vector>

#include "reports/html.hpp"

namespace odemark {

/// The whole page for readers of plain text and of code hosts; pictures are links into `picture_folder`.
std::string to_markdown(const Page& page, const std::string& picture_folder);

struct PageFile {
  std::string name;  // "svg/kepler_e06-error-dt.svg"
  std::string content;
};

/// One SVG per chart, one CSV per table, named by its id; of equal ids the first.
std::vector<PageFile> page_files(const Page& page, const std::string& picture_folder,
                                 const std::string& table_folder);

}  // namespace odemark
