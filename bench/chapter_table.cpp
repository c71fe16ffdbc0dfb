// Table 7-1 and the mean errors of the chapter, computed and printed by the book's rule beside the book.
#include <fmt/format.h>

#include <array>

#include "bench/chapter_lab.hpp"
#include "bench/measure.hpp"

namespace odemark::chapter {

namespace {

struct BookLine {
  double t;
  const char *exact, *euler, *error;
};
constexpr std::array book{
    BookLine{6.5, "9.559084", "9.733158", "1.82"}, BookLine{7.0, "10.06829", "10.2465", "1.77"},
    BookLine{7.5, "10.55267", "10.73418", "1.72"}, BookLine{8.0, "11.01342", "11.19747", "1.67"},
    BookLine{8.5, "11.4517", "11.63759", "1.62"}};
struct BookMean {
  const char *method, *percent;
};
constexpr std::array book_means{BookMean{"explicit_euler", "1.72"}, BookMean{"heun", "0.03"},
                                BookMean{"rk4", "3.6e-6"}};

/// Seven significant digits without trailing zeros, as the book prints speeds: "10.2465" says 10.24650.
std::string speed_text(double v) { return fmt::format("{:.7g}", v); }

/// Two decimals, or mantissa and exponent where the book has them.
std::string percent_text(double percent, std::string_view like) {
  if (like.find('e') == like.npos) return fmt::format("{:.2f}", percent);
  const std::string text = fmt::format("{:.1e}", percent);  // "3.6e-06"
  const std::size_t sign = text.find('e') + 1;
  return text.substr(0, sign) + (text[sign] == '-' ? "-" : "") +
         std::to_string(std::stoi(text.substr(sign + 1)));
}

PrintedNumber compared(const char* theirs, std::string ours, double value) {
  PrintedNumber number{theirs, std::move(ours), value, false};
  number.agrees = number.book == number.ours;
  return number;
}

/// The speeds of one method at the five times of the table, in the number type itself.
template <class T>
std::vector<T> speeds(std::string_view method, const AnyProblem& ship) {
  std::vector<T> v;
  std::size_t next = 0;
  const long count = std::lround(book.back().t / table_dt);
  long n = 0;
  step<T>(method_called(method), ship, table_dt, count, [&](T, const T* y) {
    ++n;
    if (next < book.size() && n == std::lround(book[next].t / table_dt)) v.push_back(y[1]), ++next;
    return true;
  });
  return v;
}

template <class T>
ChapterTable table_in(std::string_view scalar) {
  const AnyProblem ship = problem_called("drag_ship");
  ChapterTable table{std::string(scalar), {}, {}};
  std::vector<T> exact;
  for (const BookLine& line : book)
    exact.push_back(exact_flow<T>(ship, T(line.t), initial_state<T>(ship))[1]);
  const auto relative = [&](T v, std::size_t i) { return 100 * double(std::abs(v - exact[i]) / exact[i]); };

  // the speed of the listing is that of explicit Euler: they differ in the position only
  const auto euler = speeds<T>("chapter_euler", ship);
  for (std::size_t i = 0; i < book.size(); ++i) {
    const double error = relative(euler[i], i);
    table.lines.push_back({book[i].t, compared(book[i].exact, speed_text(double(exact[i])), double(exact[i])),
                           compared(book[i].euler, speed_text(double(euler[i])), double(euler[i])),
                           compared(book[i].error, percent_text(error, book[i].error), error)});
  }
  for (const BookMean& mean : book_means) {
    const auto v = speeds<T>(mean.method, ship);
    double sum = 0;
    for (std::size_t i = 0; i < book.size(); ++i) sum += relative(v[i], i);
    const double percent = sum / double(book.size());
    table.means.push_back(
        {mean.method, compared(mean.percent, percent_text(percent, mean.percent), percent)});
  }
  return table;
}

template <class T>
ListingHash listing_hash(std::string_view problem_id, std::string_view scalar) {
  const AnyProblem problem = problem_called(problem_id);
  constexpr double dt = 0.5;
  constexpr long count = 120;
  const auto end = [&](std::string_view method) {
    return step<T>(method_called(method), problem, dt, count).y;
  };
  const auto listing = end("chapter_euler"), semi = end("semi_implicit_euler"), euler = end("explicit_euler");
  ListingHash hash{std::string(problem_id), std::string(scalar), hash_bits(listing), hash_bits(semi),
                   hash_bits(euler)};
  hash.speed_gap = std::abs(double(listing[1] - euler[1]));
  hash.position_gap = double(listing[0] - euler[0]);
  hash.dt_times_change = dt * (double(listing[1]) - problem.initial[1]);
  return hash;
}

}  // namespace

std::vector<ChapterTable> table_7_1() { return {table_in<double>("double"), table_in<float>("float")}; }

std::vector<LocalError> local_errors() {
  const AnyProblem ship = problem_called("drag_ship");
  const auto start = initial_state<double>(ship);
  std::vector<LocalError> lines;
  for (double dt = 5; dt > 0.3; dt /= 2) {
    const double v = step<double>(method_called("explicit_euler"), ship, dt, 1).y[1];
    lines.push_back({dt, v - exact_flow<double>(ship, dt, start)[1]});
  }
  return lines;
}

std::vector<ListingHash> listing_hashes() {
  return {listing_hash<double>("drag_ship", "double"), listing_hash<float>("drag_ship", "float"),
          listing_hash<double>("oscillator", "double"), listing_hash<float>("oscillator", "float")};
}

}  // namespace odemark::chapter
