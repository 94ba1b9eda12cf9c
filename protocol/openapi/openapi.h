// The contract of the service.
#pragma once

#include <string_view>

namespace pelage {

/// openapi.yaml with the schemas of requests and answers, as one line of JSON (OpenAPI 3.1).
std::string_view openapi_json();

}  // namespace pelage
