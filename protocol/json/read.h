// A JSON tree to any struct that has a list of members.
#pragma once

#include "protocol/commands/command.h"
#include "protocol/commands/frame.h"
#include "protocol/json/reader.h"

namespace pelage::json_parts {

/// Refuses what the list of members and the rules do not allow. Instantiated in read.cpp for the documents of
/// decode.h, decode_answers.h and calibration.h.
template <class T>
T read(const Value& value);

template <>
Command read(const Value& value);

}  // namespace pelage::json_parts
