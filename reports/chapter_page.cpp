// Lays the chapter page out: the verdicts first, then what they rest on.
#include "reports/chapter_page.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "reports/chapter_words.hpp"

namespace odemark {

namespace chapter_layout {

std::string claim_text(std::size_t claim) {
  static constexpr std::array texts{
      "Instability shows itself in two ways: an oscillation about the exact solution that never settles, or "
      "growing divergence.",
      "A smaller dt tends to remove instability; a larger one makes it worse.",
      "Making dt smaller is not always better: cost rises and round-off accumulates.",
      "The two improved methods are generally more stable than Euler.",
      "On the undamped spring improved Euler and Runge–Kutta are practically identical, so improved Euler "
      "saves time and memory.",
      "Runge–Kutta gives the best accuracy for a given dt, and one pays for it in evaluations per step.",
      "An adaptive step keeps the truncation error within a set limit."};
  return texts.at(claim - 1);
}

namespace {

struct ClaimPart {
  std::string (*verdict)(const ChapterData&);
  std::vector<Block> (*blocks)(const ChapterData&);
  const char *heading, *short_name;
};
constexpr std::array<ClaimPart, claim_count> parts{
    {{verdict_1, claim_1, "Claim 1: two faces of instability", "instability has two faces"},
     {verdict_2, claim_2, "Claim 2: does a smaller dt remove it?", "a smaller dt removes it"},
     {verdict_3, claim_3, "Claim 3: is a smaller dt always better?", "smaller is not always better"},
     {verdict_4, claim_4, "Claim 4: are the improved methods more stable?",
      "the improved methods are more stable"},
     {verdict_5, claim_5, "Claim 5: improved Euler against Runge–Kutta on a spring",
      "on a spring both are identical"},
     {verdict_6, claim_6, "Claim 6: best accuracy for a given dt, and at equal cost",
      "Runge–Kutta is best for a given dt"},
     {verdict_7, claim_7, "Claim 7: does an adaptive step keep the error within a limit?",
      "an adaptive step keeps its limit"}}};

Table verdict_table(const ChapterData& data) {
  Table table{"verdicts",
              "The seven claims and their answers",
              "“True with limits”: it holds in some of the measured cases and not in others. The sentences "
              "below say in "
              "which; the rule of each answer is in bench/chapter_answers.cpp.",
              {{"answer"}, {"the claim, in short"}},
              {}};
  for (std::size_t n = 0; n < claim_count; ++n) {
    const Answer answer = data.answers.at(n);
    Cell claim = words(fmt::format("{}. {}", n + 1, parts.at(n).short_name));
    claim.link = fmt::format("#claim-{}", n + 1);
    table.rows.push_back({words(answer_text(answer), answer_status(answer)), claim});
  }
  return table;
}

// Table cells do not wrap: the sentences stand below their table.
std::vector<Block> verdict_blocks(const ChapterData& data) {
  std::vector<Block> blocks{verdict_table(data)};
  for (std::size_t n = 0; n < claim_count; ++n)
    blocks.push_back(Paragraph{
        fmt::format("{} ({}). {}", n + 1, answer_text(data.answers.at(n)), parts.at(n).verdict(data))});
  return blocks;
}

struct Agreement {
  int agreeing = 0, all = 0;
  void add(const PrintedNumber& number) { agreeing += number.agrees, ++all; }
};

Agreement agreement(const ChapterTable& table) {
  Agreement count;
  for (const TableLine& line : table.lines)
    count.add(line.exact), count.add(line.euler), count.add(line.error);
  for (const MeanError& mean : table.means) count.add(mean.percent);
  return count;
}

}  // namespace
}  // namespace chapter_layout

Page chapter_page(const ChapterData& data) {
  using namespace chapter_layout;
  Page page;
  page.title = "The chapter, reproduced and answered";
  page.subtitle =
      "Every number, figure and claim of “integrating the equations of motion”, beside what the suite's own "
      "methods did when this page was made. Only columns called “book” are copied.";
  const Agreement digits = agreement(data.tables.at(0));
  page.verdict = Verdict{digits.agreeing == digits.all ? Status::ok : Status::fail,
                         fmt::format("{} of the {} printed numbers of the book are reproduced to every digit "
                                     "in double precision.",
                                     digits.agreeing, digits.all),
                         {{"Table 7-1", "#table-section"}}};
  for (std::size_t n = 0; n < claim_count; ++n)
    page.badges.push_back(
        {fmt::format("{}: {}", n + 1, answer_text(data.answers.at(n))), answer_status(data.answers.at(n))});
  page.sections.push_back({"claims", "The seven claims", verdict_blocks(data)});
  page.sections.push_back({"table-section", "Table 7-1", table_blocks(data)});
  page.sections.push_back({"figures", "Figures 7-1 to 7-8", figure_blocks(data)});
  for (std::size_t n = 0; n < claim_count; ++n) {
    const ClaimPart& part = parts.at(n);
    const Answer answer = data.answers.at(n);
    Section section{fmt::format("claim-{}", n + 1), part.heading, {}};
    section.blocks.push_back(Paragraph{"The chapter says: " + claim_text(n + 1)});
    section.blocks.push_back(Paragraph{
        fmt::format("Measured: {}. {}", answer_text(answer), part.verdict(data)), answer_status(answer)});
    for (Block& block : part.blocks(data)) section.blocks.push_back(std::move(block));
    page.sections.push_back(std::move(section));
  }
  page.sections.push_back({"listing", "What the chapter's first listing is", listing_blocks(data)});
  page.footer = "odemark: computed by bench/chapter*.cpp, laid out by reports/chapter*.cpp";
  return page;
}

}  // namespace odemark
