// Looking into the JSON of a glTF file that may hold anything.
#pragma once

#include <cstdint>
#include <string>

#include "protocol/json/parse.h"

namespace pelage::gltf {

using nlohmann::json;

/// The member when it is an array, else an empty one.
const json& list(const json& object, const char* name);
/// The member when it is an object, else an empty one.
const json& member(const json& object, const char* name);
/// The member when it is text, else "".
std::string text(const json& object, const char* name);
/// The member as an index, -1 when it is none.
std::int64_t index(const json& object, const char* name);
/// The item of an array; null where it has none of that number.
const json* item(const json& array, std::int64_t number);

/// At most 200 bytes, without control characters.
std::string printable(std::string word);
/// What a file calls an item: its name, or the kind and number.
std::string name_of(const json& items, std::int64_t number, const char* kind);

}  // namespace pelage::gltf
