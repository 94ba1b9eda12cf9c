// JSON Schema of requests and answers, made from the same lists of members that decoding and encoding visit.
#pragma once

#include <nlohmann/json.hpp>

namespace pelage {

/// Every struct on the wire, and the shapes that several of them have, by its name in the contract
/// (`components/schemas`). openapi.yaml adds the rules between members.
nlohmann::ordered_json schemas();

}  // namespace pelage
