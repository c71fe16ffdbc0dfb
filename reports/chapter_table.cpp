// Table 7-1, the eight figures, and what the first listing is.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/chapter_words.hpp"
#include "reports/format.hpp"

namespace odemark::chapter_layout {

namespace {

Cell compared(const PrintedNumber& number) {
  return {number.ours, number.agrees ? Status::ok : Status::warn, number.value};
}

Table table_7_1(const ChapterTable& data) {
  Table table{"table-7-1-" + data.scalar,
              data.scalar == "double" ? "Table 7-1 in double precision (m/s)"
                                      : "Table 7-1 in single precision, as the listings have it (m/s)",
              "Each cell of ours is printed by the book's rule (seven significant digits, trailing zeros "
              "dropped; two decimals for an error) and marked where it is the same text.",
              {{"t", Align::right, "s"},
               {"exact: book", Align::right},
               {"ours", Align::right},
               {"Euler: book", Align::right},
               {"ours", Align::right},
               {"error: book", Align::right, "%"},
               {"ours", Align::right, "%"}},
              {}};
  for (const TableLine& line : data.lines)
    table.rows.push_back({number_cell(line.t, fmt::format("{:.1f}", line.t)), words(line.exact.book),
                          compared(line.exact), words(line.euler.book), compared(line.euler),
                          words(line.error.book), compared(line.error)});
  return table;
}

Table mean_table(const std::vector<ChapterTable>& tables) {
  Table table{"means",
              "Mean error over the five times of Table 7-1",
              "",
              {{"method"}, {"book", Align::right, "%"}},
              {}};
  for (const ChapterTable& data : tables) {
    table.columns.push_back({data.scalar, Align::right, "%"});
    table.columns.push_back({data.scalar + ", more digits", Align::right, "%"});
  }
  for (std::size_t m = 0; m < tables.at(0).means.size(); ++m) {
    table.rows.push_back(
        {words(method_name(tables[0].means[m].method)), words(tables[0].means[m].percent.book)});
    for (const ChapterTable& data : tables) {
      table.rows.back().push_back(compared(data.means.at(m).percent));
      table.rows.back().push_back(digits(data.means.at(m).percent.value, 5));
    }
  }
  return table;
}

/// Sentences on the cells of the single-precision table that differ from the book.
std::string float_differences(const ChapterData& data) {
  std::string out;
  const auto add = [&](const std::string& where, const PrintedNumber& number) {
    if (!number.agrees)
      out +=
          fmt::format("{}{} {} for the book's {}", out.empty() ? "" : "; ", where, number.ours, number.book);
  };
  for (const TableLine& line : data.tables.at(1).lines) {
    const std::string at = fmt::format(" at {:.1f} s", line.t);
    add("exact" + at, line.exact), add("Euler" + at, line.euler), add("error" + at, line.error);
  }
  for (const MeanError& mean : data.tables.at(1).means)
    add("mean of " + method_name(mean.method), mean.percent);
  return out;
}

struct FigureText {
  const char *number, *title;
};
constexpr std::array figure_texts{FigureText{"7-1", "truncation error of one Euler step"},
                                  FigureText{"7-2", "Euler with dt = 0.5 s over the exact speed"},
                                  FigureText{"7-3", "the same from 6.5 s to 8.5 s"},
                                  FigureText{"7-4", "a later interval"},
                                  FigureText{"7-5", "Euler on the undamped spring"},
                                  FigureText{"7-6", "all three methods over the exact speed"},
                                  FigureText{"7-7", "all three methods from 6.5 s to 8.5 s"},
                                  FigureText{"7-8", "improved Euler and Runge–Kutta on the undamped spring"}};

double last_gap(const ChapterFigure& figure, std::size_t curve) {
  return figure.curves.at(curve).value.back() - figure.curves.at(0).value.back();
}

double first_gap(const ChapterFigure& figure, std::size_t curve) {
  return figure.curves.at(curve).value.front() - figure.curves.at(0).value.front();
}

double largest(const Trajectory& curve) {
  double most = 0;
  for (const double x : curve.value) most = std::max(most, std::abs(x));
  return most;
}

std::string caption_of(const ChapterData& data, const ChapterFigure& figure) {
  const std::string on_spring = fmt::format(
      "k = {} N/m, m = {} kg (the chapter prints neither), dt = {} s, released at 1 m. ",
      compact(data.oscillator_k, 6), compact(data.oscillator_m, 6), compact(data.oscillator_dt, 6));
  if (figure.number == "7-1") {
    const LocalError &large = data.local_errors.at(0), &half = data.local_errors.at(1);
    return fmt::format(
        "One step from rest, for steps of up to {} s: Euler follows the tangent, and the gap to the curve is "
        "the "
        "truncation error of that one step. It is {} m/s for dt = {} s and {} m/s for {} s: about a quarter, "
        "as a local error of order dt² has it.",
        compact(figure.to, 3), significant(large.error, 3), compact(large.dt, 3), significant(half.error, 3),
        compact(half.dt, 3));
  }
  if (figure.number == "7-2")
    return fmt::format("Euler stays above the exact speed; at {} s by {} m/s.", compact(figure.to, 3),
                       significant(last_gap(figure, 1), 3));
  if (figure.number == "7-3")
    return fmt::format("The rows of Table 7-1: Euler is {} m/s too fast at {} s.",
                       significant(last_gap(figure, 1), 3), compact(figure.to, 3));
  if (figure.number == "7-4")
    return fmt::format(
        "The chapter does not say which interval it shows; here {} s to {} s. Euler's lead falls from {} m/s "
        "to "
        "{} m/s: it converges to the exact solution, so it is stable here.",
        compact(figure.from, 3), compact(figure.to, 3), significant(first_gap(figure, 1), 3),
        significant(last_gap(figure, 1), 3));
  if (figure.number == "7-5")
    return on_spring +
           fmt::format(
               "Explicit Euler (both updates with old values) grows to {} m in six periods. The "
               "chapter's own "
               "listing, which moves the position with the new velocity, does not grow: its largest "
               "displacement here is {} m.",
               significant(largest(figure.curves.at(1)), 3), significant(largest(figure.curves.at(2)), 4));
  if (figure.number == "7-6")
    return "Improved Euler and Runge–Kutta lie on the exact curve: they cannot be told from it by eye.";
  if (figure.number == "7-7")
    return fmt::format(
        "In the zoom too: at {} s Euler is {} m/s off, improved Euler {} m/s, Runge–Kutta {} m/s.",
        compact(figure.to, 3), significant(std::abs(last_gap(figure, 1)), 2),
        significant(std::abs(last_gap(figure, 2)), 2), significant(std::abs(last_gap(figure, 3)), 2));
  return on_spring + fmt::format(
                         "Both look like the same regular sine over six periods. Improved Euler's largest "
                         "displacement is {} m, Runge–Kutta's {} m: claim 5 says how long this lasts.",
                         significant(largest(figure.curves.at(1)), 4),
                         significant(largest(figure.curves.at(2)), 4));
}

}  // namespace

std::vector<Block> table_blocks(const ChapterData& data) {
  std::vector<Block> blocks;
  for (const ChapterTable& table : data.tables) blocks.push_back(table_7_1(table));
  blocks.push_back(mean_table(data.tables));
  const std::string differences = float_differences(data);
  blocks.push_back(Paragraph{
      differences.empty()
          ? "Single precision gives the same digits."
          : fmt::format(
                "In single precision, which the listings use, these differ from the book: {}. The printed "
                "digits are those of our double-precision run, not of our float run. A single rounding of "
                "a float is up to 6e-6 %, so it cannot show Runge–Kutta's mean error at this step at all.",
                differences),
      Status::note});
  return blocks;
}

std::vector<Block> figure_blocks(const ChapterData& data) {
  std::vector<Block> blocks;
  for (const FigureText& text : figure_texts)
    for (const ChapterFigure& figure : data.figures) {
      if (figure.number != text.number) continue;
      Chart chart;
      chart.id = "figure-" + figure.number;
      chart.title = fmt::format("Figure {}: {}", figure.number, text.title);
      chart.caption = caption_of(data, figure);
      const bool one_step = figure.number == "7-1";
      chart.x.label = one_step ? "dt of the one step [s]" : "t [s]";
      const Trajectory& first = figure.curves.at(0);
      chart.y.label = fmt::format("{} [{}]", first.component == "v" ? "speed" : "displacement", first.unit);
      for (const Trajectory& curve : figure.curves) chart.series.push_back(series_of(curve));
      blocks.push_back(std::move(chart));
    }
  return blocks;
}

std::vector<Block> listing_blocks(const ChapterData& data) {
  Table table{"listing-hashes",
              "Final states after 120 steps of 0.5 s",
              "A hash is taken over the bits of (position, velocity): equal hashes are equal bits.",
              {{"problem"},
               {"number"},
               {"listing"},
               {"semi-implicit Euler"},
               {"explicit Euler"},
               {"speed apart", Align::right, "m/s"},
               {"position apart", Align::right, "m"},
               {"dt (v_end − v_0)", Align::right, "m"}},
              {}};
  bool all_equal = true;
  for (const ListingHash& line : data.listing) {
    const bool equal = line.listing == line.semi_implicit;
    all_equal = all_equal && equal;
    table.rows.push_back({words(problem_name(line.problem)), words(line.scalar), words(line.listing),
                          words(line.semi_implicit, equal ? Status::ok : Status::fail),
                          words(line.explicit_euler, Status::muted), digits(line.speed_gap, 4),
                          digits(line.position_gap, 6), digits(line.dt_times_change, 6)});
  }
  const ListingHash& ship = data.listing.at(0);
  const ListingOnSpring& spring = data.listing_on_spring;
  const std::string text = fmt::format(
      "The listing computes the new velocity from the old state and moves the position with the new "
      "velocity. "
      "For one body this is {} semi-implicit (symplectic) Euler: the hashes are {}. Explicit Euler moves the "
      "position with the old velocity. On the ship, whose force knows only the speed, both have {} speeds, "
      "so "
      "Table 7-1 is the same for both; the positions differ by dt times the change of speed, after one "
      "minute "
      "{} m. On the undamped spring the difference decides: at ω dt = {} over {} periods the listing's "
      "amplitude never exceeds {} times the start, while explicit Euler's reaches {} times. Figure 7-5 is "
      "drawn "
      "by explicit Euler; the chapter's own listing would not have grown.",
      all_equal ? "bit for bit" : "not", all_equal ? "equal in every row" : "not all equal",
      ship.speed_gap == 0 ? "the same" : "different", significant(ship.position_gap, 5),
      compact(spring.dt, 3), compact(spring.periods, 4), significant(spring.listing_amplitude, 4),
      significant(spring.euler_amplitude, 3));
  return {Paragraph{text, Status::note}, table};
}

}  // namespace odemark::chapter_layout
