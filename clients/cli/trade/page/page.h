// The report as one HTML page.
#pragma once

#include <string>
#include <vector>

#include "clients/cli/trade/page/row.h"

namespace pelage::trade {

/// A small picture with its error map, where there is one.
struct Picture {
  std::string scene;
  std::string name;     // "R1", "draft", ...
  std::string caption;  // its figures
  std::string jpeg;     // bytes
  std::string map;      // bytes of a JPEG; "" for none
};

struct Report {
  std::string renderer;  // what drew: the GL's name of itself
  int size = 0;          // pixels of a side
  int repeats = 1;       // of which the least time counts
  int truth = 512;       // shells of R1
  std::vector<Row> rows;
  std::vector<Picture> pictures = {};
};

/// Bytes as base64 (RFC 4648).
std::string base64(const std::string& bytes);

/// The whole page; it needs nothing beside itself.
std::string page(const Report& report);

}  // namespace pelage::trade
