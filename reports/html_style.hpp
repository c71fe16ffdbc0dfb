// The fixed text of every page: its style sheet and its one small script.
#pragma once

#include <string>
#include <string_view>

namespace odemark {

std::string page_style();
std::string_view page_script();  // sorts and filters tables; the page is complete without it

}  // namespace odemark
