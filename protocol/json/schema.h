// JSON Schema of the requests, made from the same lists of members that decoding and encoding visit.
#pragma once

#include <nlohmann/json.hpp>

namespace pelage {

/// Every struct of the requests and commands by its name in the contract (`components/schemas`). It refers to shapes
/// that openapi.yaml describes: Position, Direction, Colour, Camera, Tier and PictureName.
nlohmann::ordered_json request_schemas();

}  // namespace pelage
