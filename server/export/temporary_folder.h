// A place for files that are needed for a while.
#pragma once

#include <string>

#include "base/status.h"

namespace pelage {

/// A folder of its own below the system's temporary one, which goes with all that lies in it.
class TemporaryFolder {
 public:
  /// Fails (internal) where it cannot be made.
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
