#include "protocol/recipes/places.h"

#include "protocol/json/parse.h"

namespace pelage::json_parts {

using nlohmann::json;

bool is_triple(const json& value) {
  return value.is_array() && value.size() == 3 && value[0].is_number() && value[1].is_number() && value[2].is_number();
}

Status check_places(const json& places, const std::string& pointer) {
  if (!places.is_object()) return failure(Code::invalid, "Places are an object of names.", pointer, "object");
  for (const auto& [name, place] : places.items())
    if (!is_triple(place) && !place.is_number())
      return failure(Code::invalid, "A place is three shares of the model's box, a size a number.",
                     pointer + pointer_step(name), "[x, y, z] or a number");
  return {};
}

}  // namespace pelage::json_parts
