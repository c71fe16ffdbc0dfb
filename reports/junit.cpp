// Violations are failures; what was not measured is an error, so that no reader counts it as passed.
#include "reports/junit.hpp"

#include <fmt/format.h>

#include "reports/check_texts.hpp"
#include "reports/markup.hpp"

namespace odemark {

std::string to_junit(const CheckResult& result) {
  const int errors = count(result, Outcome::missing) + count(result, Outcome::no_reference);
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
      "<testsuite name=\"odemark check\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n",
      result.findings.size() + (result.compared == 0), count(result, Outcome::fail),
      errors + (result.compared == 0), count(result, Outcome::skipped));
  if (result.compared == 0)
    xml +=
        "<testcase classname=\"check\" name=\"compared\"><error message=\"no case was "
        "compared\"/></testcase>\n";
  for (const Finding& finding : result.findings) {
    xml += fmt::format("<testcase classname=\"{}.{}\" name=\"{}\">", escaped(finding.metric),
                       escaped(finding.problem), escaped(finding.method));
    std::string message = full_message(finding);
    if (const auto where = where_of(result, finding); !where.empty()) message += " [" + where + "]";
    message = escaped(message);
    switch (finding.outcome) {
      case Outcome::fail: xml += fmt::format("<failure message=\"{}\"/>", message); break;
      case Outcome::missing:
      case Outcome::no_reference:
        xml += fmt::format("<error type=\"{}\" message=\"{}\"/>", to_string(finding.outcome), message);
        break;
      case Outcome::skipped: xml += fmt::format("<skipped message=\"{}\"/>", message); break;
      case Outcome::pass:
      case Outcome::note:
      case Outcome::improved: xml += fmt::format("<system-out>{}</system-out>", message); break;
    }
    xml += "</testcase>\n";
  }
  return xml + "</testsuite>\n</testsuites>\n";
}

}  // namespace odemark
