// The sentences that every text of a check shares.
#pragma once

#include <string>
#include <vector>

#include "reports/check.hpp"

namespace odemark {

std::string headline(const CheckResult& result);         // "compared 188 of 190 cases against ..."
std::string counts_in_words(const CheckResult& result);  // "2 failed, 186 passed, 1 improved"
std::string where_of(const CheckResult& result, const Finding& finding);  // "thresholds.toml:14" or empty
std::string full_message(const Finding& finding);
std::vector<const Finding*> findings_of(const CheckResult& result, Outcome outcome);

}  // namespace odemark
