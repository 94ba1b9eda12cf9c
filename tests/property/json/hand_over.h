// Passes random documents on for validation against the schemas of the contract:
// tests/end_to_end/service/test_contract.py names a file for them.
#pragma once

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace pelage::testing {

/// Appends a line with the schema's name and the document to that file, if there is one.
inline void hand_over(const char* schema, const std::string& document) {
  const char* file = std::getenv("PELAGE_DOCUMENTS");
  if (file == nullptr) return;
  std::ofstream(file, std::ios::app) << schema << ' ' << nlohmann::json::parse(document).dump() << '\n';
}

}  // namespace pelage::testing
