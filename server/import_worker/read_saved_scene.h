// Exported scenes, which anybody may have written. Runs in the confined worker only.
#pragma once

#include <cstddef>
#include <string>

#include "base/limits.h"
#include "base/status.h"

namespace pelage {

/// The rows (server/history/plain_rows.h) of a .pelage file. Refused (invalid), with the reason: what is no gzip file,
/// damaged, cut off, over `max` bytes unpacked, or refused by foreign_rows.
Result<std::string> read_saved_scene(std::string&& file, std::size_t max = limits::saved_bytes);

}  // namespace pelage
