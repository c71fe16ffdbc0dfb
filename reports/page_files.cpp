// A page taken apart into files.
#include "reports/page_files.hpp"

#include <fmt/format.h>

#include <set>

#include "reports/decimate.hpp"
#include "reports/markup.hpp"
#include "reports/svg.hpp"

namespace odemark {
namespace {

constexpr std::size_t longest_table = 60;  // rows in Markdown; the rest is in the CSV

std::string block_markdown(const Paragraph& paragraph, const std::string&) {
  return (paragraph.status == Status::plain ? "" : "> ") + paragraph.text + "\n\n";
}

std::string block_markdown(const Listing& listing, const std::string&) {
  return "```\n" + listing.text + "\n```\n\n";
}

std::string block_markdown(const Equations& equations, const std::string&) {
  return "```\n" + equations.text + "\n```\n\n";
}

std::string block_markdown(const Chart& chart, const std::string& folder) {
  std::string out = fmt::format("![{}]({}/{}.svg)\n\n", chart.title, folder, safe_id(chart.id));
  return chart.caption.empty() ? out : out + chart.caption + "\n\n";
}

std::string block_markdown(const Table& table, const std::string&) {
  if (table.rows.size() <= longest_table) return to_markdown(table) + "\n";
  Table shortened = table;
  shortened.rows.resize(longest_table);
  return to_markdown(shortened) + fmt::format("\nThe first {} of {} lines; all are in {}.csv.\n\n",
                                              longest_table, table.rows.size(), safe_id(table.id));
}

}  // namespace

std::string to_markdown(const Page& page, const std::string& picture_folder) {
  std::string out = fmt::format("# {}\n\n", page.title);
  if (!page.subtitle.empty()) out += page.subtitle + "\n\n";
  if (page.verdict) out += fmt::format("**{}**\n\n", page.verdict->text);
  for (const Badge& badge : page.badges) out += "- " + badge.text + "\n";
  if (!page.badges.empty()) out += '\n';
  for (const Section& section : page.sections) {
    out += fmt::format("## {}\n\n", section.heading);
    for (const Block& block : section.blocks)
      out += std::visit([&](const auto& content) { return block_markdown(content, picture_folder); }, block);
  }
  return page.footer.empty() ? out : out + page.footer + "\n";
}

std::vector<PageFile> page_files(const Page& page, const std::string& picture_folder,
                                 const std::string& table_folder) {
  std::vector<PageFile> files;
  std::set<std::string> taken;
  for (const Section& section : page.sections)
    for (const Block& block : section.blocks) {
      if (const auto* chart = std::get_if<Chart>(&block)) {
        std::string name = fmt::format("{}/{}.svg", picture_folder, safe_id(chart->id));
        if (taken.insert(name).second)
          files.push_back({std::move(name), to_svg(decimated(*chart), safe_id(chart->id))});
      } else if (const auto* table = std::get_if<Table>(&block)) {
        std::string name = fmt::format("{}/{}.csv", table_folder, safe_id(table->id));
        if (taken.insert(name).second) files.push_back({std::move(name), to_csv(*table)});
      }
    }
  return files;
}

}  // namespace odemark
