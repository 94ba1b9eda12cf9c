// Decodes JSON to any struct that has a list of members.
#pragma once

#include "protocol/commands/command.h"
#include "protocol/commands/frame.h"
#include "protocol/json/parse.h"
#include "protocol/json/reader.h"

namespace pelage::json_parts {

/// Reads a struct. Refuses what the list of members and the rules do not allow. Instantiated in read.cpp for the
/// documents of decode.h and calibration.h.
template <class T>
T read(const Value& value);

template <>
Command read(const Value& value);

// Decoding of whole documents.

/// Returns the struct, or the first refusal.
template <class T>
Result<T> decode_tree(const nlohmann::json& tree, Reading reading = Reading::strict) {
  Status first_failure;
  T result = read<T>(Value(tree, "", first_failure, reading));
  if (!first_failure.ok()) return first_failure;
  return result;
}
template <class T>
Result<T> decode_document(std::string_view text, Reading reading = Reading::strict) {
  const auto tree = parse_json(text);
  if (!tree) return tree.status();
  return decode_tree<T>(*tree, reading);
}

}  // namespace pelage::json_parts
