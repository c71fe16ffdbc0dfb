// odemark doctor: what affects the numbers on this machine.
#include "bench/doctor.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/cli/commands.hpp"
#include "bench/machine.hpp"

namespace odemark {

int doctor_command(const DoctorOptions& options) {
  const RunHeader header = describe_machine();
  const auto findings = diagnose();
  if (options.format == "json") {
    nlohmann::ordered_json j{{"version", header.version},
                             {"compiler", header.compiler},
                             {"flags", header.flags},
                             {"build_type", header.build_type},
                             {"processor", header.processor},
                             {"cores", header.cores},
                             {"system", header.system},
                             {"providers", header.providers},
                             {"findings", nlohmann::ordered_json::array()}};
    for (const auto& f : findings)
      j["findings"].push_back({{"id", f.id},
                               {"applies", f.applies},
                               {"measured", f.measured},
                               {"affects", f.affects},
                               {"advice", f.advice}});
    fmt::print("{}\n", j.dump(2));
    return exit_ok;
  }
  fmt::print("{}\n{}\n{}\n\n", headline(header), header.processor, header.system);
  for (const auto& f : findings) {
    fmt::print("{} {}: {}\n", f.applies ? "!" : " ", f.id, f.measured);
    if (!f.applies) continue;
    fmt::print("    {}\n", f.advice);
    if (!f.affects.empty()) fmt::print("    affects {}\n", fmt::join(f.affects, ", "));
  }
  return exit_ok;
}

}  // namespace odemark
