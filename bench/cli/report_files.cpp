// Renders the pages and writes every file of a report.
#include "bench/cli/report_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "bench/cli/files.hpp"
#include "reports/chapter_page.hpp"
#include "reports/csv_rows.hpp"
#include "reports/html.hpp"
#include "reports/method_page.hpp"
#include "reports/page_files.hpp"
#include "reports/problem_sheet_page.hpp"
#include "reports/report_page.hpp"

namespace odemark {

namespace {

const std::vector<Link>& beside() {
  static const std::vector<Link> links{
      {"the textbook chapter, claim by claim", "chapter.html"},
      {"every method: facts, computed and measured", "methods.html"},
      {"every problem: equations, truth and its digits, stiffness", "problems.html"},
      {"every run, all fields", "csv/rows.csv"},
      {"every stability limit", "csv/stability.csv"},
      {"this page as Markdown", "report.md"},
      {"the results themselves, one JSON object a line", "results.jsonl"}};
  return links;
}

std::string size_text(std::size_t bytes) {
  return bytes < 1'000'000 ? fmt::format("{:.0f} kB", static_cast<double>(bytes) / 1e3)
                           : fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

}  // namespace

std::string write_report(Results results, Pictures pictures, const ChapterData& chapter,
                         const std::vector<FactSheet>& methods, const std::vector<ProblemSheet>& problems,
                         const std::string& folder_name, const std::string& title) {
  ReportInput input;
  input.pictures = std::move(pictures);
  input.header = std::move(results.header);
  input.rows = std::move(results.rows);
  input.stability = std::move(results.stability);
  input.title = title, input.beside = beside(), input.cut = results.cut;
  const Page page = report_page(input), claims = chapter_page(chapter);

  const std::filesystem::path folder = folder_name;
  for (const char* part : {"svg", "csv", "problems", "methods", "families"})
    require_writable_folder((folder / part).string());
  const auto write = [&](const std::string& name, const std::string& content) {
    write_file((folder / name).string(), content);
    return content.size();
  };
  auto files = page_files(page, "svg", "csv");
  for (const NamedPage& one : problem_pages(input)) {
    for (auto& file : page_files(one.page, "svg", "csv")) files.push_back(std::move(file));
    files.push_back({one.name, to_html(one.page)});
  }
  for (const NamedPage& one : method_pages(methods)) files.push_back({one.name, to_html(one.page)});
  for (const NamedPage& one : family_pages(problems)) files.push_back({one.name, to_html(one.page)});
  const Page overview = methods_page(methods), catalogue = families_page(problems);
  for (auto& file : page_files(catalogue, "svg", "csv")) files.push_back(std::move(file));
  for (auto& file : page_files(overview, "svg", "csv")) files.push_back(std::move(file));
  for (auto& file : page_files(claims, "svg", "csv")) files.push_back(std::move(file));
  files.push_back({"csv/rows.csv", to_csv(rows_table(input.rows))});
  files.push_back({"csv/stability.csv", to_csv(stability_table(input.stability))});
  std::map<std::string, std::string> by_name;  // sections that two pages share are written once
  for (auto& file : files) by_name.emplace(std::move(file.name), std::move(file.content));
  std::map<std::string, std::size_t> written;
  for (const auto& [name, content] : by_name) {
    write(name, content);
    ++written[name.substr(0, name.find('/'))];
  }
  write("report.md", to_markdown(page, "svg"));
  write("chapter.html", to_html(claims));
  write("methods.html", to_html(overview));
  write("problems.html", to_html(catalogue));
  const std::size_t size = write("report.html", to_html(page));
  return fmt::format(
      "wrote {} ({}), chapter.html, methods.html, problems.html, report.md; {} pages in problems/, {} in "
      "methods/, {} in families/, {} pictures in svg/, {} tables in csv/",
      (folder / "report.html").string(), size_text(size), written["problems"], written["methods"],
      written["families"], written["svg"], written["csv"]);
}

}  // namespace odemark
