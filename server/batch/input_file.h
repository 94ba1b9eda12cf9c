// Files that a job names, read whole.
#pragma once

#include <string>

#include "base/status.h"
#include "protocol/commands/scene.h"

namespace pelage {

/// By the ending of a model's file; refused (invalid, `pointer`) for others.
Result<ModelFormat> format_of_file(const std::string& path, const std::string& pointer);

/// Returns all bytes of a file; not_found, with the system's reason, where it cannot be read. Folders, pipes and
/// devices are refused, because a task would wait for bytes that nobody sends.
Result<std::string> read_file(const std::string& path);

/// Adds the name of the file to a refusal of its content.
Status in_file(const std::string& path, Status status);

}  // namespace pelage
