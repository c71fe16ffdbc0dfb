// A check for a pull request: the verdict, failures first, never longer than hosts accept.
#include <fmt/format.h>

#include "reports/check.hpp"
#include "reports/check_texts.hpp"

namespace odemark {
namespace {

constexpr std::size_t longest = 900'000;  // bytes; hosts cut or drop summaries at 1 MiB

/// Safe in a cell of a table: no pipe, no line end, no markup.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '|': out += "\\|"; break;
      case '\n':
      case '\r': out += ' '; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '&': out += "&amp;"; break;
      case '*':
      case '_':
      case '`':
      case '[':
      case ']':
      case '\\': (out += '\\') += c; break;
      default: out += c;
    }
  return out;
}

struct Writer {
  std::string text;
  std::size_t left_out = 0;

  void line(std::string_view line, std::size_t reserved) {
    if (text.size() + line.size() + reserved > longest)
      ++left_out;
    else
      text += line;
  }
};

void add_section(Writer& out, const CheckResult& result, Outcome outcome, std::string_view title,
                 bool folded) {
  const auto findings = findings_of(result, outcome);
  if (findings.empty()) return;
  constexpr std::size_t reserve = 2'000;  // for the closing lines
  if (out.text.size() + reserve > longest) {
    out.left_out += findings.size();
    return;
  }
  out.text += folded ? fmt::format("\n<details><summary>{} {}</summary>\n", findings.size(), title)
                     : fmt::format("\n### {} {}\n", findings.size(), title);
  out.text += "\n| case | metric | measured and allowed | demanded in |\n|---|---|---|---|\n";
  for (const Finding* finding : findings)
    out.line(fmt::format("| {} | {} | {} | {} |\n", cell(finding->case_name), cell(finding->metric),
                         cell(full_message(*finding)), cell(where_of(result, *finding))),
             reserve);
  if (folded) out.text += "\n</details>\n";
}

std::string_view verdict(int code) {
  switch (code) {
    case 0: return "passed";
    case 1: return "FAILED";
    case 4: return "no reference where one was needed";
    default: return "incomplete";
  }
}

}  // namespace

std::string to_markdown(const CheckResult& result) {
  Writer out;
  out.text = fmt::format("<!-- odemark check -->\n## odemark check: {}\n\n**{}**; {}.\n",
                         verdict(exit_code(result)), counts_in_words(result), cell(headline(result)));
  add_section(out, result, Outcome::fail, "failed", false);
  add_section(out, result, Outcome::no_reference, "without a reference", false);
  add_section(out, result, Outcome::missing, "missing", false);
  add_section(out, result, Outcome::improved, "improved", false);
  add_section(out, result, Outcome::note, "notes", true);
  add_section(out, result, Outcome::skipped, "skipped", true);
  add_section(out, result, Outcome::pass, "passed", true);
  if (out.left_out > 0)
    out.text += fmt::format("\n{} more lines left out: this text ends at 900 kB.\n", out.left_out);
  return out.text;
}

}  // namespace odemark
