// All strands of a scene, as the tracer grows them, for files.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/status.h"
#include "protocol/commands/export.h"
#include "renderer/strands/strand_set.h"
#include "server/groom/cancel.h"
#include "server/scene/scene.h"

namespace pelage {

/// Places are internal: (model - centre) / size.
struct ExportedStrands {
  std::vector<StrandSet> sets;      // of the fur, in an order that depends on nothing but the scene; then the curves
  std::size_t curve_sets = 0;       // the last ones: whiskers, lashes and brows
  std::vector<glm::vec2> root_uvs;  // of each strand the texture coordinates of its root, v up; empty: none
  glm::dvec3 centre{0};             // model coordinates
  double size = 1;                  // model's unit

  std::uint64_t count() const;
  std::uint64_t points() const;
  glm::vec3 model_offset(const StrandPoint& point) const { return glm::vec3(glm::dvec3(point.place) * size); }
  float model_width(const StrandPoint& point) const { return static_cast<float>(2 * double{point.radius} * size); }
};

/// Refused as export_scene says. Deterministic at any thread count. Throws Cancelled.
Result<ExportedStrands> gather_strands(const SceneView& scene, const ExportRequest& request, const Cancel& cancel = {});

}  // namespace pelage
