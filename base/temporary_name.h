// Names of temporary files, which are written beside their target and then renamed to it; and the host's name.
#pragma once

#include <string>

namespace pelage {

/// This machine's name; "" where it has none.
std::string host_name();

/// Returns ".NAME.HOST-RANDOM.tmp" in the folder of the path: a name of its own, whatever machines and processes share
/// the folder.
std::string temporary_beside(const std::string& path);

}  // namespace pelage
