#include "bench/doctor.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <thread>

#include "reference/library_checks.hpp"

namespace odemark {

namespace {

Diagnosis load_of_machine() {
  double load[1] = {0};
  const bool known = getloadavg(load, 1) == 1;
  const double cores = std::max(1.0, static_cast<double>(std::thread::hardware_concurrency()));
  return {"load",
          known && load[0] > 0.5 * cores,
          known ? fmt::format("load {:.1f} on {:.0f} cores", load[0], cores) : "load unknown",
          "other work shares the machine: times carry its noise; errors, work counts and hashes do not",
          {}};
}

Diagnosis governor() {
  std::ifstream file("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  std::string name;
  if (!(file >> name))
    return {"governor", false, "frequency governor not visible (a virtual machine, or not Linux)", "", {}};
  return {"governor",
          name != "performance",
          fmt::format("frequency governor {}", name),
          "the clock frequency may change during a run: compare times only within one run",
          {}};
}

Diagnosis clock_resolution() {
  using Clock = std::chrono::steady_clock;
  double smallest = 1;
  for (int i = 0; i < 1000; ++i) {
    const auto begin = Clock::now();
    auto end = Clock::now();
    while (end == begin) end = Clock::now();
    smallest = std::min(smallest, std::chrono::duration<double>(end - begin).count());
  }
  return {"clock",
          smallest > 1e-6,
          fmt::format("the clock ticks every {:.0f} ns", 1e9 * smallest),
          "short runs are timed in batches of at least 20 us; a clock this coarse makes them noisy",
          {}};
}

Diagnosis denormals() {
  volatile double tiny = std::numeric_limits<double>::min();
  const double half = tiny / 2;
  return {"denormals",
          half == 0,
          half == 0 ? "denormal numbers are flushed to zero" : "denormal numbers are kept",
          "results differ from a standard build near underflow",
          {}};
}

Diagnosis contraction() {
  volatile double a = 1 + 0x1p-30, b = 1 - 0x1p-30, c = -1;
  const double product = a * b;
  const double contracted = a * b + c, separate = product + c;
  const bool fused = contracted != separate;
  return {"contraction",
          fused,
          fused ? "multiply-add is contracted (a native build)" : "multiply-add is not contracted",
          "bits differ from the portable build: never compare hashes of the two",
          {}};
}

}  // namespace

std::vector<Diagnosis> diagnose() {
  std::vector<Diagnosis> all{load_of_machine(), governor(), clock_resolution(), denormals(), contraction()};
  for (const auto& check : library_checks())
    all.push_back({std::string(check.id),
                   check.applies,
                   check.measured,
                   std::string(check.footnote),
                   {check.affects.begin(), check.affects.end()}});
  return all;
}

std::vector<std::string> footnotes() {
  std::vector<std::string> notes;
  for (const auto& d : diagnose())
    if (d.applies && !d.affects.empty())
      notes.push_back(fmt::format("{}: {}", fmt::join(d.affects, ", "), d.advice));
  return notes;
}

}  // namespace odemark
