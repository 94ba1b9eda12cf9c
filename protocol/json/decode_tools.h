// Commands of the grooming kernel from JSON.
#pragma once

#include "protocol/commands/command.h"
#include "protocol/json/reader.h"

namespace pelage::json_parts {

using CommandReader = Command (*)(Object&);

/// The reader of a tool by its name, or null where it is no tool. It leaves Object::finish to its caller.
struct NamedReader {
  std::string_view name;
  CommandReader read;
};
const std::vector<NamedReader>& tool_readers();

}  // namespace pelage::json_parts
