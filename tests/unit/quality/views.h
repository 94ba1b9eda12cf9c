// Views of simple skin, and a calibration made by hand.
#pragma once

#include <vector>

#include "renderer/quality/planner.h"

namespace pelage::testing {

/// A square of 2 x `cells` x `cells` triangles across the view, `half` sizes to each side of the origin.
struct Patch {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::uvec3> triangles;
  std::vector<float> length;

  explicit Patch(int cells = 8, float half = 0.25f, float fur = 0.03f) {
    for (int j = 0; j <= cells; ++j) {
      for (int i = 0; i <= cells; ++i) {
        const float step = 2 * half / static_cast<float>(cells);
        positions.emplace_back(-half + step * static_cast<float>(i), -half + step * static_cast<float>(j), 0);
        normals.emplace_back(0, 0, 1), length.push_back(fur);
      }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
    for (int j = 0; j < cells; ++j) {
      for (int i = 0; i < cells; ++i) {
        triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  FurredSkin skin() const { return {positions, normals, triangles, length, 1, false}; }
};

/// Looks along -z from `distance`, one size across the picture's height at distance 1.
inline FurFrame frame_of(int width, int height, float distance = 1) {
  FurFrame frame;
  frame.width = width, frame.height = height;
  frame.camera.position = {0, 0, distance}, frame.camera.tan_half_fov = 0.5f;
  frame.lights.resize(3);
  return frame;
}

/// More shells cost more and err less, and sorted ones do both.
inline Calibration plain_calibration() {
  Calibration calibration;
  calibration.name = "by hand";
  calibration.cost.fill(1);
  calibration.cost_safety = 1.2;
  calibration.high.fill(10);
  for (const FragmentOrder order : {FragmentOrder::shells, FragmentOrder::sorted}) {
    for (const int shells : {4, 8, 16, 32, 64}) {
      CalibratedKnobs row;
      row.knobs.shells = shells, row.knobs.order = order, row.knobs.shell_policy = ShellPolicy::uniform;
      row.log_error = -1 - 0.02 * shells - (order == FragmentOrder::sorted ? 0.7 : 0);
      row.slopes = {0.1, -0.1, 0.05, 0.5, 0.2, 0.1};
      row.error_safety = order == FragmentOrder::sorted ? 1.2 : 1.6;
      calibration.ladder.push_back(row);
    }
  }
  return calibration;
}

}  // namespace pelage::testing
