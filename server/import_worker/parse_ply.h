// Reads the header of a PLY file: its elements in order, each with its properties.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace pelage {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Returns the size in bytes of a number in a binary file.
std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { text, little_endian, big_endian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::text;
  std::vector<PlyElement> elements;
};

/// Removes the header from `bytes`, which then begin with the first element. Refuses (invalid) a header that is cut off
/// or malformed, and counts of elements for which the remaining bytes have no room.
Result<PlyHeader> take_ply_header(std::string_view& bytes);

}  // namespace pelage
