// JSON Schema of requests and answers, made from the lists of members that decoding and encoding visit.
#pragma once

#include <nlohmann/json.hpp>

namespace pelage {

/// Returns the schemas of all structs on the wire, and of shapes that several of them share, by their names in the
/// contract (`components/schemas`). openapi.yaml adds the rules between members.
nlohmann::ordered_json schemas();

}  // namespace pelage
