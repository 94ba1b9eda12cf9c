// The rows of science.md 7: values at the ends of their ranges, each drawn or refused.
#pragma once

#include <string>
#include <vector>

#include "protocol/commands/scene.h"

namespace pelage::testing {

/// A model file as it is uploaded; none if `bytes` is empty.
struct RowModel {
  std::string bytes;
  ModelFormat format = ModelFormat::obj;
};

/// One row of the matrix. Commands, frame and scene are JSON as a client sends it. `refused` is the JSON pointer of the
/// expected refusal, "model" for a refused file, and empty if the row is drawn.
struct Row {
  std::string area, value;
  std::vector<std::string> commands = {};
  std::string frame = R"({"width": 16, "height": 12})";
  std::string scene = R"({"model": {"builtin": "sphere", "triangles": 300}, "fur": {"length": 0.05}})";
  RowModel model = {};
  std::string refused = {};
};

/// All rows of an area, in the order of the table.
using Rows = std::vector<Row>;

Rows mesh_rows();
Rows fur_rows();
Rows scattering_rows();
Rows light_rows();
Rows camera_rows();
Rows brush_rows();
Rows eye_rows();

inline Rows rows_of(const std::string& area) {
  if (area == "mesh") return mesh_rows();
  if (area == "fur") return fur_rows();
  if (area == "scattering") return scattering_rows();
  if (area == "light") return light_rows();
  if (area == "camera") return camera_rows();
  if (area == "brush") return brush_rows();
  return eye_rows();
}

inline const std::vector<std::string>& areas() {
  static const std::vector<std::string> names{"mesh", "fur", "scattering", "light", "camera", "brush", "eye"};
  return names;
}

}  // namespace pelage::testing
