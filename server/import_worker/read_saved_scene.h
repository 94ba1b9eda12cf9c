// Reads exported scenes, which are untrusted files. Runs in the confined worker only.
#pragma once

#include <cstddef>
#include <string>

#include "base/limits.h"
#include "base/status.h"

namespace pelage {

/// Returns the rows (server/history/plain_rows.h) of a .pelage file. Refused (invalid), with the reason, if it is not a
/// gzip file, is damaged or cut off, has over `max` bytes unpacked, or is refused by foreign_rows.
Result<std::string> read_saved_scene(std::string&& file, std::size_t max = limits::saved_bytes);

}  // namespace pelage
