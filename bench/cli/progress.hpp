// Progress of long work on stderr: one redrawn line on a terminal, a line per tenth elsewhere. Never on
// stdout.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "bench/cli/commands.hpp"

namespace odemark {

class Progress {
 public:
  Progress(std::string_view title, const CommonOptions& options);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::size_t done, std::size_t total, const std::string& what);

 private:
  using Clock = std::chrono::steady_clock;
  std::string title_;
  bool bar_ = false, lines_ = false, drawn_ = false;
  Clock::time_point begin_ = Clock::now(), last_{};
  std::size_t first_ = 0, last_tenth_ = 0;
  bool started_ = false;
};

}  // namespace odemark
