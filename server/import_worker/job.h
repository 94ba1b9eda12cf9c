// The jobs that the worker can run on an upload.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/status.h"

namespace pelage {

struct Job {
  /// Turns the bytes of a file into the bytes of the answer; `pose` is for models. Refused (invalid) with the reason.
  Result<std::string> (*run)(std::string&& bytes, const std::string& pose) = nullptr;
  /// True if reading these bytes may need a reader of pictures, which takes as long to load as a small model to read.
  /// Looks at bytes from anywhere, before confine(): it searches, and parses nothing.
  bool (*may_read_pictures)(std::string_view bytes) = nullptr;
};

/// Returns the job of that name (server/import/import.h); none if there is no such job.
std::optional<Job> job_of(std::string_view name);

}  // namespace pelage
