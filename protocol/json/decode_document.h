// JSON text to any struct that has a list of members.
#pragma once

#include "protocol/json/parse.h"
#include "protocol/json/read.h"

namespace pelage::json_parts {

/// The first refusal, where there is one.
template <class T>
Result<T> decode_document(std::string_view text, Reading reading = Reading::strict) {
  const auto tree = parse_json(text);
  if (!tree) return tree.status();
  Status first_failure;
  T result = read<T>(Value(*tree, "", first_failure, reading));
  if (!first_failure.ok()) return first_failure;
  return result;
}

}  // namespace pelage::json_parts
