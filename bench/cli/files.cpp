#include "bench/cli/files.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "reference/bad_input.hpp"

namespace odemark {

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream all;
  if (file) all << file.rdbuf();
  if (!file) throw BadInput(fmt::format("cannot read {}: {}", path, std::strerror(errno)));
  return all.str();
}

void write_file(const std::string& path, std::string_view content) {
  const std::string beside = path + ".part";
  {
    std::ofstream file(beside, std::ios::binary | std::ios::trunc);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.flush();
    if (!file) {
      const int error = errno;
      std::error_code ignored;
      std::filesystem::remove(beside, ignored);
      throw CannotWrite(fmt::format("cannot write {}: {}", path, std::strerror(error)));
    }
  }
  std::error_code failure;
  std::filesystem::rename(beside, path, failure);
  if (failure) throw CannotWrite(fmt::format("cannot write {}: {}", path, failure.message()));
}

void require_writable_folder(const std::string& path) {
  std::error_code failure;
  std::filesystem::create_directories(path, failure);
  const std::string probe = (std::filesystem::path(path) / ".odemark-write-test").string();
  std::ofstream file(probe);
  file << "x" << std::flush;
  const bool good = static_cast<bool>(file);
  file.close();
  std::filesystem::remove(probe, failure);
  if (!good) throw BadInput(fmt::format("cannot write into {}: choose another folder with -o", path));
}

void require_writable_file(const std::string& path) {
  const std::string beside = path + ".part";
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(path, ignored);
  bool good = false;
  if (!is_folder) {
    std::ofstream file(beside, std::ios::binary | std::ios::trunc);
    good = static_cast<bool>(file);
  }
  const int error = is_folder ? EISDIR : errno;
  if (!good) throw BadInput(fmt::format("cannot write {}: {}", path, std::strerror(error)));
  std::filesystem::remove(beside, ignored);
}

}  // namespace odemark
