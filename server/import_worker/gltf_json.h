// Reads the JSON of a glTF file that may be malformed in any way.
#pragma once

#include <cstdint>
#include <string>

#include "protocol/json/parse.h"

namespace pelage::gltf {

using nlohmann::json;

/// Returns the member if it is an array, else an empty array.
const json& list(const json& object, const char* name);
/// Returns the member if it is an object, else an empty object.
const json& member(const json& object, const char* name);
/// Returns the member if it is text, else "".
std::string text(const json& object, const char* name);
/// Returns the member if it is an index, else -1.
std::int64_t index(const json& object, const char* name);
/// Returns an item of an array; null if it is out of range.
const json* item(const json& array, std::int64_t number);

/// Returns at most 200 bytes of the word as valid UTF-8, without control characters.
std::string printable(std::string word);
/// Returns the name of an item; without one its kind and number.
std::string name_of(const json& items, std::int64_t number, const char* kind);

}  // namespace pelage::gltf
