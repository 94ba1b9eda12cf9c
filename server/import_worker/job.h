// What the worker can do with an upload.
#pragma once

#include <string>
#include <string_view>

#include "protocol/base/status.h"

namespace pelage {

/// From the bytes of a file to the bytes of the answer. `pose` is of models. Refused (invalid) with the reason.
using Job = Result<std::string> (*)(std::string&& bytes, const std::string& pose);

/// The job of that name (server/import/import.h); null when there is none.
Job job_of(std::string_view name);

}  // namespace pelage
