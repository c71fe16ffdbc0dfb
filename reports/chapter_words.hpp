// Pieces that all parts of the chapter page share: names, looks, cells, and finding a measurement.
#pragma once

#include <string>
#include <string_view>

#include "bench/data/chapter.hpp"
#include "reports/html.hpp"

namespace odemark::chapter_layout {

std::string method_name(std::string_view id);   // "improved Euler"
std::string problem_name(std::string_view id);  // "ship", "undamped spring"
std::string answer_text(Answer answer);         // "true with limits"
Status answer_status(Answer answer);
std::string behaviour_text(Behaviour behaviour);
Style look(std::string_view method);  // the same in every chart of the page

/// A curve of a figure; few points get markers, many get a line only.
Series series_of(const Trajectory& curve);

std::string long_time(double seconds);  // 2.12 s, 13.7 h, 41.2 days, 3.1 years

Cell words(std::string text, Status status = Status::plain);
Cell digits(double x, int significant_digits);
Cell digits_or(const std::optional<double>& x, int significant_digits, std::string_view otherwise);

/// Throws std::invalid_argument where the data lack what the page is about.
const LimitLine& limit_of(const ChapterData&, std::string_view problem, std::string_view method);
const GrowthPoint& growth_of(const ChapterData&, std::string_view method, double per_second);
const ErrorCurve& error_of(const ChapterData&, std::string_view problem, std::string_view method,
                           std::string_view scalar);
const DoublingLine& doubling_of(const ChapterData&, double z);
const AdaptiveRun& adaptive_of(const ChapterData&, std::string_view problem, std::string_view method,
                               double tolerance);
const Crossover& crossover_of(const ChapterData&, std::string_view problem, std::string_view cheap,
                              std::string_view dear);

inline constexpr std::size_t claim_count = 7;
std::string claim_text(std::size_t claim);  // 1 to 7: what the chapter says
/// One sentence with the numbers that answer the claim.
std::string verdict_1(const ChapterData&);
std::string verdict_2(const ChapterData&);
std::string verdict_3(const ChapterData&);
std::string verdict_4(const ChapterData&);
std::string verdict_5(const ChapterData&);
std::string verdict_6(const ChapterData&);
std::string verdict_7(const ChapterData&);

std::vector<Block> table_blocks(const ChapterData&);
std::vector<Block> figure_blocks(const ChapterData&);
std::vector<Block> listing_blocks(const ChapterData&);
std::vector<Block> claim_1(const ChapterData&);
std::vector<Block> claim_2(const ChapterData&);
std::vector<Block> claim_3(const ChapterData&);
std::vector<Block> claim_4(const ChapterData&);
std::vector<Block> claim_5(const ChapterData&);
std::vector<Block> claim_6(const ChapterData&);
std::vector<Block> claim_7(const ChapterData&);

}  // namespace odemark::chapter_layout
