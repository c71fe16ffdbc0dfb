#include "reports/settling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reports/format.hpp"

namespace odemark {
namespace {

std::vector<std::string> in_order(const std::vector<Settling>& all, std::string Settling::*what) {
  std::vector<std::string> seen;
  for (const Settling& s : all)
    if (std::find(seen.begin(), seen.end(), s.*what) == seen.end()) seen.push_back(s.*what);
  return seen;
}

double rejected_share(const Settling& s) {
  const long tried = s.accepted + s.rejected;
  return tried > 0 ? double(s.rejected) / double(tried) : 0;
}

void add_cells(std::vector<Cell>& cells, const Settling& s) {
  if (s.status != "reached_end") {
    cells.push_back({s.status, Status::fail});
    cells.insert(cells.end(), 2, {std::string(no_value), Status::muted});
    return;
  }
  const Status status = settles(s) ? Status::ok : Status::plain;
  cells.push_back({fmt::format("{:.4f}", s.mean / s.limit), status, s.mean / s.limit});
  cells.push_back(number_cell(s.scatter, scientific(s.scatter, 1)));
  cells.push_back({fmt::format("{:.1f} %", 100 * rejected_share(s)), Status::plain, rejected_share(s)});
}

}  // namespace

bool settles(const Settling& s) {
  return s.status == "reached_end" && s.scatter < 1e-3 && rejected_share(s) < 0.01;
}

std::string settling_answer(const std::vector<Settling>& all) {
  std::string resting;
  std::size_t runs = 0;
  for (const auto& filter : in_order(all, &Settling::filter)) {
    const auto count_if = [&](auto&& what) {
      return static_cast<std::size_t>(std::count_if(
          all.begin(), all.end(), [&](const Settling& s) { return s.filter == filter && what(s); }));
    };
    runs = std::max(runs, count_if([](const Settling&) { return true; }));
    resting += fmt::format("{}{} under {}", resting.empty() ? "" : ", ", count_if(settles), filter);
  }
  if (runs == 0) return "";
  return fmt::format(
      "Of {} explicit methods whose step stability holds down, so many come to rest there: {}.", runs,
      resting);
}

Table settling_table(const std::vector<Settling>& all) {
  Table table{
      "settling",
      "Steps that stability holds down",
      "y' = -2000 (y - cos t) at tolerance 10⁻³. Mean of h |λ| over the second half as a share of the "
      "limit that follows from the coefficients; scatter of these steps; rejected attempts. ✓: at rest, "
      "scatter below 10⁻³ and fewer than one attempt in a hundred rejected. A mean far from 1: something "
      "else than stability sets the step.",
      {{"method"}, {"limit", Align::right}},
      {}};
  const auto filters = in_order(all, &Settling::filter);
  for (const auto& filter : filters) {
    table.columns.push_back({filter, Align::right});
    table.columns.push_back({"scatter", Align::right});
    table.columns.push_back({"rejected", Align::right});
  }
  for (const auto& method : in_order(all, &Settling::method)) {
    std::vector<Cell> cells{{method}};
    for (const Settling& s : all) {
      if (s.method != method) continue;
      if (cells.size() == 1) cells.push_back({compact(s.limit, 5), Status::plain, s.limit});
      add_cells(cells, s);
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace odemark
