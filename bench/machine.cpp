#include "bench/machine.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include <ctime>
#include <fstream>
#include <thread>

#include "reference/contestants.hpp"

namespace odemark {

namespace {

std::string processor_name() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.starts_with("model name")) {
      const std::size_t colon = line.find(':');
      return colon == line.npos ? line : line.substr(std::min(colon + 2, line.size()));
    }
  return "unknown processor";
}

std::string compiler_name() {
#if defined(__clang__)
  return fmt::format("clang++ {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
  return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
  return "unknown compiler";
#endif
}

}  // namespace

RunHeader describe_machine() {
  RunHeader h;
  h.version = ODEMARK_VERSION, h.revision = ODEMARK_REVISION;
  h.compiler = compiler_name(), h.flags = ODEMARK_FLAGS, h.build_type = ODEMARK_BUILD_TYPE;
  h.processor = processor_name();
  h.cores = static_cast<int>(std::thread::hardware_concurrency());
  utsname system{};
  if (uname(&system) == 0) h.system = fmt::format("{} {} {}", system.sysname, system.release, system.machine);
  h.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  for (const auto& provider : contestant_providers())
    h.providers[std::string(provider.name)] = provider.version;
  return h;
}

std::string version_text() { return fmt::format("odemark {} ({})", ODEMARK_VERSION, ODEMARK_REVISION); }

std::string headline(const RunHeader& h) {
  std::string text = fmt::format("odemark {}  {} {} {}", h.version, h.compiler, h.build_type, h.flags);
  for (const auto& [name, version] : h.providers) text += fmt::format("  {} {}", name, version);
  return text + fmt::format("  {} cores", h.cores);
}

}  // namespace odemark
