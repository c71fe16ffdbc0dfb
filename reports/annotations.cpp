// Escaping as the runner undoes it: %, line ends, and in properties also : and ,
#include "reports/annotations.hpp"

#include <fmt/format.h>

#include <utility>

#include "reports/check_texts.hpp"

namespace odemark {
namespace {

std::string encoded(std::string_view text, bool property) {
  std::string out;
  for (const char c : text) {
    const bool special = c == '%' || c == '\r' || c == '\n' || (property && (c == ':' || c == ','));
    if (special)
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    else
      out += c;
  }
  return out;
}

std::string_view command(Outcome outcome) {
  switch (outcome) {
    case Outcome::fail:
    case Outcome::no_reference:
    case Outcome::missing: return "error";
    case Outcome::improved: return "notice";
    case Outcome::pass:
    case Outcome::note:
    case Outcome::skipped: return "";
  }
  return "";
}

}  // namespace

std::string to_github(const CheckResult& result, std::string path) {
  if (path.empty()) path = result.thresholds_name;
  std::string out;
  for (const Outcome outcome : {Outcome::fail, Outcome::no_reference, Outcome::missing, Outcome::improved})
    for (const Finding* finding : findings_of(result, outcome)) {
      out += fmt::format("::{} ", command(outcome));
      if (finding->line > 0) out += fmt::format("file={},line={},", encoded(path, true), finding->line);
      out += fmt::format("title={}::{}: {}\n",
                         encoded(fmt::format("{} {}", finding->case_name, finding->metric), true),
                         encoded(finding->case_name, false), encoded(full_message(*finding), false));
    }
  if (result.compared == 0) out += "::error title=odemark check::no case was compared\n";
  return out;
}

}  // namespace odemark
