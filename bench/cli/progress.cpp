#include "bench/cli/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace odemark {

namespace {

std::string clock_text(double seconds) {
  const long s = static_cast<long>(seconds + 0.5);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

std::size_t terminal_width() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 20) return size.ws_col;
  return 80;
}

}  // namespace

Progress::Progress(std::string_view title, const CommonOptions& options) : title_(title) {
  const bool terminal = isatty(STDERR_FILENO) != 0 && std::getenv("CI") == nullptr;
  if (options.quiet || options.progress == ProgressStyle::none) return;
  bar_ = options.progress == ProgressStyle::bar || (options.progress == ProgressStyle::automatic && terminal);
  lines_ = !bar_;
}

Progress::~Progress() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
}

void Progress::update(std::size_t done, std::size_t total, const std::string& what) {
  const auto now = Clock::now();
  if (!started_) started_ = true, first_ = done - 1;  // a resumed run begins further on: its ETA must not
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  const double eta = elapsed / static_cast<double>(done - first_) * static_cast<double>(total - done);
  if (bar_ && (now - last_ > std::chrono::milliseconds(100) || done == total)) {
    last_ = now;
    std::string line =
        fmt::format("{} {}/{}  {:3.0f} %  ETA {}  {}", title_, done, total,
                    100.0 * static_cast<double>(done) / static_cast<double>(total), clock_text(eta), what);
    line.resize(std::min(line.size(), terminal_width() - 1));
    fmt::print(stderr, "\r\033[K{}", line);
    std::fflush(stderr);
    drawn_ = true;
  } else if (lines_) {
    const std::size_t tenth = total > 0 ? 10 * done / total : 10;
    if (tenth == last_tenth_ && now - last_ < std::chrono::seconds(30)) return;
    if (last_ == Clock::time_point{} && tenth == 0 && elapsed < 5) {
      last_ = now;
      return;
    }
    last_ = now, last_tenth_ = tenth;
    fmt::print(stderr, "{} {}/{}  {:.0f} %  ETA {}\n", title_, done, total,
               100.0 * static_cast<double>(done) / static_cast<double>(total), clock_text(eta));
  }
}

}  // namespace odemark
