// Any struct that has a list of members to a JSON tree; read.h reads it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "protocol/commands/command.h"

namespace pelage::json_parts {

/// Keeps members in the order in which they are written.
using Json = nlohmann::ordered_json;

/// Instantiated in write.cpp for the requests and answers of encode.h, and for calibrations.
template <class T>
Json written(const T& value);

template <>
Json written(const Command& command);

/// In one line; bytes that are no UTF-8 are replaced.
inline std::string line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace pelage::json_parts
