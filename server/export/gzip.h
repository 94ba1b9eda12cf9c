// Files as gzip, whose checksum tells what is damaged.
#pragma once

#include <functional>
#include <string>

#include "protocol/base/status.h"

namespace pelage {

/// Fails (internal) where a file cannot be read or written. `between` is called between pieces, and ends it by
/// throwing.
Status compress_file(const std::string& from, const std::string& to, const std::function<void()>& between = {});

}  // namespace pelage
