// Reads the files that a job names.
#pragma once

#include <string>

#include "base/status.h"
#include "protocol/commands/scene.h"

namespace pelage {

/// Returns the format by the ending of a model's file; refused (invalid, `pointer`) for other endings.
Result<ModelFormat> format_of_file(const std::string& path, const std::string& pointer);

/// Returns all bytes of a file. Fails (not_found), with the system's reason, if it cannot be read. Folders, pipes and
/// devices are refused, because a task could wait forever for their bytes.
Result<std::string> read_file(const std::string& path);

/// Adds the name of the file to a refusal of its content.
Status in_file(const std::string& path, Status status);

}  // namespace pelage
