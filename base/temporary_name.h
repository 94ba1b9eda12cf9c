// Names of temporary files, which are written next to their target and then renamed to it; and the host name.
#pragma once

#include <string>

namespace pelage {

/// Returns the host name; "" if it is unknown.
std::string host_name();

/// Returns ".NAME.HOST-RANDOM.tmp" in the folder of the path: a name that stays unique when several machines and
/// processes share the folder.
std::string temporary_beside(const std::string& path);

}  // namespace pelage
