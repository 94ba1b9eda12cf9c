#include <nlohmann/json.hpp>

#include "protocol/json/encode.h"
#include "protocol/json/names.h"

namespace pelage {

using Json = nlohmann::ordered_json;
using json_names::text_of;

std::string encode(const MapAnswer& answer) {
  const Json json = {{"revision", answer.revision},
                     {"field", shape_of(answer.field).name},
                     {"encoding", text_of(json_names::map_encodings, answer.encoding)},
                     {"scale", answer.scale},
                     {"units", text_of(json_names::units, answer.units)},
                     {"covered", answer.covered},
                     {"outside", answer.outside}};
  return json.dump();
}

std::string encode(const PictureAnswer& answer) {
  Json json = {{"picture", answer.picture}, {"width", answer.width}, {"height", answer.height}, {"bits", answer.bits}};
  if (answer.scale) json["scale"] = *answer.scale;
  return json.dump();
}

}  // namespace pelage
