// A report page: one self-contained HTML file, complete without script, readable on a phone and on paper.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "reports/chart.hpp"
#include "reports/table.hpp"

namespace odemark {

struct Link {
  std::string text;
  std::string href;  // script URLs are printed as text
};

struct Paragraph {
  std::string text;
  Status status = Status::plain;  // other than plain: a call-out
};

struct Listing {
  std::string text;  // printed as it is: commands, raw output
};

struct Equations {
  std::string text;                // as the catalogue writes them
  std::vector<std::string> names;  // what in it is a name and no word
};

// A chart becomes a figure with its caption, notes and a folded table of its data; its series are decimated
// first.
using Block = std::variant<Paragraph, Listing, Chart, Table, Equations>;

struct Section {
  std::string id;
  std::string heading;
  std::vector<Block> blocks;
};

struct Badge {
  std::string text;
  Status status = Status::plain;
};

struct Verdict {
  Status status = Status::plain;
  std::string text;
  std::vector<Link> links{};  // such as the failed cases
};

struct Page {
  std::string title;
  std::string subtitle{};  // suite, commit, date, machine: the caller's words, nothing is added
  std::optional<Verdict> verdict{};
  std::vector<Badge> badges{};
  std::vector<Link> nav{};  // empty: one link per section
  std::vector<Section> sections{};
  std::string footer{};
  std::string language = "en";
};

std::string to_html(const Page& page);

}  // namespace odemark
