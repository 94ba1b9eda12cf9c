// Files that a job names, read whole.
#pragma once

#include <string>

#include "base/status.h"
#include "protocol/commands/scene.h"

namespace pelage {

/// By the ending of a model's file; refused (invalid, `pointer`) for others.
Result<ModelFormat> format_of_file(const std::string& path, const std::string& pointer);

/// All bytes of a file; not_found, with what the system says. A folder is none, and neither is a pipe or a device, of
/// which a task would wait for bytes that nobody sends.
Result<std::string> read_file(const std::string& path);

/// The refusal of what is in a file, by its name.
Status in_file(const std::string& path, Status status);

}  // namespace pelage
