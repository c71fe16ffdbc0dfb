// A report page: one self-contained HTML file, complete without script, readable on a phone and on paper.
#include "reports/html.hpp"

#include <fmt/format.h>

#include <iterator>
#include <set>
#include <type_traits>

#include "reports/html_figure.hpp"
#include "reports/html_style.hpp"
#include "reports/markup.hpp"
#include "reports/mathml.hpp"

namespace odemark {
namespace {

// Anchors must be unique in the page even if two charts carry the same id or none.
class Anchors {
 public:
  std::string claim(const std::string& wanted, const char* otherwise) {
    const std::string id = safe_id(wanted.empty() ? otherwise : wanted);
    std::string unique = id;
    for (int n = 2; !taken_.insert(unique).second; ++n) unique = fmt::format("{}-{}", id, n);
    return unique;
  }

 private:
  // Ids that the page or a figure's parts use; figures append -plot and -svg to their own.
  std::set<std::string> taken_{"content"};
};

std::string link_html(const Link& link) {
  if (!is_safe_link(link.href)) return escaped(link.text);
  return fmt::format("<a href=\"{}\">{}</a>", escaped(link.href), escaped(link.text));
}

std::string list_html(const std::vector<Link>& links) {
  std::string out = "<ul>";
  for (const Link& link : links) fmt::format_to(std::back_inserter(out), "<li>{}</li>", link_html(link));
  return out + "</ul>\n";
}

std::string header_html(const Page& page) {
  std::string out = fmt::format("<header>\n<h1>{}</h1>\n", escaped(page.title));
  if (!page.subtitle.empty())
    fmt::format_to(std::back_inserter(out), "<p class=\"subtitle\">{}</p>\n", escaped(page.subtitle));
  if (!page.badges.empty()) {
    out += "<ul class=\"badges\">";
    for (const Badge& badge : page.badges)
      fmt::format_to(std::back_inserter(out), "<li class=\"{}\">{}</li>", to_string(badge.status),
                     escaped(badge.text));
    out += "</ul>\n";
  }
  if (page.verdict) {
    fmt::format_to(std::back_inserter(out), "<div class=\"verdict {}\"><p><strong>{}</strong></p>",
                   to_string(page.verdict->status), escaped(page.verdict->text));
    if (!page.verdict->links.empty()) out += list_html(page.verdict->links);
    out += "</div>\n";
  }
  return out + "</header>\n";
}

std::string block_html(const Block& block, Anchors& anchors) {
  return std::visit(
      [&anchors](const auto& content) -> std::string {
        using Content = std::decay_t<decltype(content)>;
        if constexpr (std::is_same_v<Content, Paragraph>) {
          if (content.status == Status::plain) return fmt::format("<p>{}</p>\n", escaped(content.text));
          return fmt::format("<p class=\"callout {}\">{}</p>\n", to_string(content.status),
                             escaped(content.text));
        } else if constexpr (std::is_same_v<Content, Listing>) {
          return fmt::format("<pre tabindex=\"0\">{}</pre>\n", escaped(content.text));
        } else if constexpr (std::is_same_v<Content, Equations>) {
          return fmt::format("{}\n<pre tabindex=\"0\">{}</pre>\n", to_mathml(content.text, content.names),
                             escaped(content.text));
        } else if constexpr (std::is_same_v<Content, Chart>) {
          return figure_html(content, anchors.claim(content.id, "figure"));
        } else {
          Table table = content;
          table.id = anchors.claim(content.id, "table");
          return to_html(table);
        }
      },
      block);
}

}  // namespace

std::string to_html(const Page& page) {
  Anchors anchors;
  std::vector<Link> nav = page.nav;
  std::string body;
  std::vector<std::string> ids;  // sections first: links to them are written by hand elsewhere
  for (const Section& section : page.sections) ids.push_back(anchors.claim(section.id, "section"));
  for (std::size_t i = 0; i < page.sections.size(); ++i) {
    const Section& section = page.sections[i];
    if (page.nav.empty()) nav.push_back({section.heading, "#" + ids[i]});
    fmt::format_to(std::back_inserter(body),
                   "<section id=\"{0}\">\n<h2><a class=\"anchor\" href=\"#{0}\">{1}</a></h2>\n", ids[i],
                   escaped(section.heading));
    for (const Block& block : section.blocks) body += block_html(block, anchors);
    body += "</section>\n";
  }

  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\">\n<title>{}</title>\n<style>{}</style>\n"
      "</head>\n<body>\n<a class=\"skip\" href=\"#content\">Skip to the content</a>\n",
      escaped(page.language), escaped(page.title), page_style());
  out += header_html(page);
  if (!nav.empty()) out += "<nav aria-label=\"Sections\">" + list_html(nav) + "</nav>\n";
  out += "<main id=\"content\">\n" + body + "</main>\n";
  if (!page.footer.empty()) out += fmt::format("<footer><p>{}</p></footer>\n", escaped(page.footer));
  fmt::format_to(std::back_inserter(out), "<script>{}</script>\n</body>\n</html>\n", page_script());
  return out;
}

}  // namespace odemark
