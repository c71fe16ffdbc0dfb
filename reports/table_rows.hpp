// What every table renderer needs first: complete rows and printed headers.
#pragma once

#include <string>
#include <vector>

#include "reports/table.hpp"

namespace odemark {

std::string header_text(const Column& column);
std::vector<std::vector<Cell>> full_rows(const Table& table);  // short rows filled with blanks

}  // namespace odemark
