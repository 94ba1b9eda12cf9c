// Encodes any struct that has a list of members as a JSON tree, which read.h decodes.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "protocol/commands/command.h"

namespace pelage::json_parts {

/// Keeps members in the order in which they are written.
using Json = nlohmann::ordered_json;

/// Encodes a struct. Instantiated in write.cpp for the requests and answers of encode.h, and for calibrations.
template <class T>
Json written(const T& value);

template <>
Json written(const Command& command);

/// Returns one line of text; bytes that are not UTF-8 are replaced.
inline std::string line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace pelage::json_parts
