// Reading and writing whole files, with sentences for what can go wrong.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace odemark {

/// A file that cannot be written, or a disk that is full: exit code 4, because work was under way.
struct CannotWrite : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws BadInput if it cannot be read.
std::string read_file(const std::string& path);
/// Writes beside and renames over, so that a failure leaves the old file whole. Throws CannotWrite.
void write_file(const std::string& path, std::string_view content);
/// Makes sure, before there is work to lose, that write_file() can write it; throws BadInput otherwise.
void require_writable_file(const std::string& path);
/// Creates the folder if need be and makes sure that it can be written into; throws BadInput otherwise.
void require_writable_folder(const std::string& path);

}  // namespace odemark
