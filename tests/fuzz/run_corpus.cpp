// Runs a fuzz target over a folder of inputs, whole, cut short and with bytes changed: the same on every run,
// and without libFuzzer.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::vector<std::uint8_t> read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void run(const std::vector<std::uint8_t>& bytes) {
  // a copy of the exact size: reading past its end is seen by a sanitizer
  const std::vector<std::uint8_t> exact(bytes.begin(), bytes.end());
  LLVMFuzzerTestOneInput(exact.data(), exact.size());
}

int run_variants(const std::vector<std::uint8_t>& bytes) {
  constexpr std::uint8_t planted[] = {0, '\n', '"', '[', '{', '}', '=', '9', 0x80, 0xFF};
  int runs = 1;
  run(bytes);
  const std::size_t stride = bytes.size() / 40 + 1;
  for (std::size_t at = 0; at < bytes.size(); at += stride) {
    run({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at)});
    auto changed = bytes;
    changed[at] = planted[at / stride % std::size(planted)];
    run(changed);
    changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(at), bytes.begin(), bytes.end());
    run(changed);
    runs += 3;
  }
  return runs;
}

}  // namespace

int main(int argc, char** argv) {
  int runs = 0, files = 0;
  for (int i = 1; i < argc; ++i)
    for (const auto& entry : std::filesystem::directory_iterator(argv[i]))
      if (entry.is_regular_file()) runs += run_variants(read(entry.path())), ++files;
  std::printf("%d inputs from %d files\n", runs, files);
  return files > 0 ? 0 : 1;
}
