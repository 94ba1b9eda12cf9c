// Files as gzip, whose checksum tells what is damaged.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "protocol/base/status.h"

namespace pelage {

/// Fails (internal) where a file cannot be read or written. `between` is called between pieces, and ends it by
/// throwing.
Status compress_file(const std::string& from, const std::string& to, const std::function<void()>& between = {});

/// Refused (invalid) when it is no gzip, damaged, cut off, or over `max_bytes`.
Status decompress_file(const std::string& from, const std::string& to, std::uint64_t max_bytes);

}  // namespace pelage
