// A check for the terminal and as JSON.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/check.hpp"
#include "reports/check_texts.hpp"

namespace odemark {

std::string where_of(const CheckResult& result, const Finding& finding) {
  return finding.line > 0 ? fmt::format("{}:{}", result.thresholds_name, finding.line) : "";
}

std::string full_message(const Finding& finding) {
  return finding.others > 0 ? fmt::format("{} (and {} more)", finding.message, finding.others)
                            : finding.message;
}

std::vector<const Finding*> findings_of(const CheckResult& result, Outcome outcome) {
  std::vector<const Finding*> found;
  for (const Finding& finding : result.findings)
    if (finding.outcome == outcome) found.push_back(&finding);
  return found;
}

std::string headline(const CheckResult& result) {
  std::string line = fmt::format("compared {} of {} cases against {}", result.compared, result.executed,
                                 result.thresholds_name);
  if (!result.baseline_name.empty()) line += ", " + result.baseline_name;
  if (result.not_applicable > 0) line += fmt::format(" ({} more are not applicable)", result.not_applicable);
  return line;
}

std::string counts_in_words(const CheckResult& result) {
  std::string words =
      fmt::format("{} failed, {} passed", count(result, Outcome::fail), count(result, Outcome::pass));
  if (const int n = count(result, Outcome::note); n > 0)
    words += fmt::format(", {} note{}", n, n == 1 ? "" : "s");
  for (const Outcome outcome : {Outcome::improved, Outcome::skipped, Outcome::missing, Outcome::no_reference})
    if (const int n = count(result, outcome); n > 0) words += fmt::format(", {} {}", n, to_string(outcome));
  return words;
}

std::string to_console(const CheckResult& result) {
  struct Shown {
    Outcome outcome;
    std::string_view label;
  };
  constexpr Shown shown[] = {{Outcome::fail, "FAIL"},       {Outcome::no_reference, "NO REFERENCE"},
                             {Outcome::missing, "MISSING"}, {Outcome::improved, "improved"},
                             {Outcome::note, "note"},       {Outcome::skipped, "skipped"}};
  std::string text = headline(result) + '\n';
  for (const auto& [outcome, label] : shown)
    for (const Finding* finding : findings_of(result, outcome)) {
      std::string line = fmt::format("{:<12}  {:<36}  {}: {}", label, finding->case_name, finding->metric,
                                     full_message(*finding));
      if (const auto where = where_of(result, *finding); !where.empty()) line += "  " + where;
      text += line + '\n';
    }
  if (result.compared == 0)
    text += fmt::format(
        "{:<12}  nothing was compared: neither {} nor the baseline demands anything of a case that was run\n",
        "MISSING", result.thresholds_name);
  return text + fmt::format("{}  exit {}\n", counts_in_words(result), exit_code(result));
}

std::string to_json(const CheckResult& result) {
  using Json = nlohmann::ordered_json;
  Json findings = Json::array();
  for (const Finding& finding : result.findings) {
    Json j = {{"case", finding.case_name},
              {"problem", finding.problem},
              {"method", finding.method},
              {"metric", finding.metric},
              {"outcome", to_string(finding.outcome)},
              {"message", finding.message}};
    if (finding.others > 0) j["others"] = finding.others;
    if (finding.line > 0) j["file"] = result.thresholds_name, j["line"] = finding.line;
    findings.push_back(std::move(j));
  }
  const Json j = {{"schema", 1},
                  {"exit_code", exit_code(result)},
                  {"cases",
                   {{"executed", result.executed},
                    {"compared", result.compared},
                    {"not_applicable", result.not_applicable}}},
                  {"counts",
                   {{"pass", count(result, Outcome::pass)},
                    {"note", count(result, Outcome::note)},
                    {"improved", count(result, Outcome::improved)},
                    {"skipped", count(result, Outcome::skipped)},
                    {"missing", count(result, Outcome::missing)},
                    {"no reference", count(result, Outcome::no_reference)},
                    {"fail", count(result, Outcome::fail)}}},
                  {"findings", std::move(findings)}};
  return j.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace odemark
