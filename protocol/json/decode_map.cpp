// Pictures by their names, and what maps may hold.
#include "protocol/json/decode_parts.h"

namespace pelage::json_parts {

std::string picture_name(const Value& value, const char* limit) {
  const std::string name = value.text(1, 32);
  if (name.size() != 32 || name.find_first_not_of("0123456789abcdef") != std::string::npos)
    value.refuse("This names no picture.", limit);
  return name;
}

void refuse_encoding(const Value& value, Field field) {
  const bool direction = field == Field::direction;
  value.refuse_below("encoding", "The encoding cannot hold this field.",
                     direction ? "uv_tangent | fast_fur | vector for direction" : "value for all fields but direction");
}

}  // namespace pelage::json_parts
