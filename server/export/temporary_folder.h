// A folder for temporary files.
#pragma once

#include <string>

#include "base/status.h"

namespace pelage {

/// A new folder in the system's temporary folder. Its destructor removes it with its content.
class TemporaryFolder {
 public:
  /// Fails (internal) if the folder cannot be made.
  static Result<TemporaryFolder> make();
  ~TemporaryFolder();
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  explicit TemporaryFolder(std::string path) : path_(std::move(path)) {}

  std::string path_;
};

}  // namespace pelage
