// Reads and writes files and the standard streams.
#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>

#include "base/status.h"

namespace pelage {

/// Returns a file's bytes; "-" is standard input. Fails if it cannot be read (not_found) or is larger than `max_bytes`
/// (too_large).
Result<std::string> read_file(const std::string& path, std::size_t max_bytes);

/// Writes a file under a temporary name in the same folder, then renames it; "-" is standard output.
Status write_file(const std::string& path, const std::string& bytes);

/// Checks that a file can be written, before the work that produces its content. Changes nothing.
Status check_output(const std::string& path);

/// A file that is written in chunks under a temporary name, and removed unless commit() is called.
class NewFile {
 public:
  explicit NewFile(std::string path);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  bool write(std::string_view chunk);
  /// Renames the file to its final name. Fails if it could not be written.
  Status commit();

 private:
  friend Status check_output(const std::string& path);

  std::string path_, temporary_;
  std::ofstream file_;
};

}  // namespace pelage
