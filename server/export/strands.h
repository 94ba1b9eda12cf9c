// All strands of a scene, as the tracer grows them, for files.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "base/status.h"
#include "protocol/commands/export.h"
#include "renderer/strands/strand_set.h"
#include "server/groom/cancel.h"
#include "server/scene/scene.h"

namespace pelage {

/// Where what is exported stands in the file.
struct FilePlace {
  glm::dvec3 centre{0};  // of the model's box
  glm::dmat3 turn{1};    // of what stands about it in Pelage's axes
  double metres = 1;     // that a unit is
  Axis up = Axis::plus_y;
};
FilePlace file_place(const Mesh& mesh, const ExportRequest& request);

/// The model's mesh, in its unit and in the file's axes, from the place's centre.
struct ExportedSkin {
  std::vector<glm::vec3> points, normals;
  std::vector<glm::uvec3> triangles;
  std::vector<std::array<glm::vec2, 3>> uvs;  // of each triangle, v up; empty: none
};

/// What files call strands of one coat, or the curves.
struct StrandGroup {
  int id = 0;  // NamedCoat::id; of curves limits::coats
  std::string name;
};

/// Places are internal: (model - centre) / size.
struct ExportedStrands {
  std::vector<StrandSet> sets;        // of the fur, in an order that depends on nothing but the scene; then the curves
  std::vector<std::size_t> group_of;  // of each set, in `groups`
  std::vector<StrandGroup> groups;
  std::size_t curve_sets = 0;       // the last ones: whiskers, lashes and brows
  std::vector<glm::vec2> root_uvs;  // of each strand the texture coordinates of its root, v up; empty: none
  FilePlace place;
  double size = 1;                   // model's unit
  std::optional<ExportedSkin> skin;  // where it was asked for

  std::uint64_t count() const;
  std::uint64_t points() const;
  /// From the place's centre, in the file's axes.
  glm::vec3 file_offset(const StrandPoint& point) const {
    return glm::vec3(place.turn * glm::dvec3(point.place) * size);
  }
  float model_width(const StrandPoint& point) const { return static_cast<float>(2 * double{point.radius} * size); }
};

/// Refused as export_scene says. Deterministic at any thread count. Throws Cancelled.
Result<ExportedStrands> gather_strands(const SceneView& scene, const ExportRequest& request, const Cancel& cancel = {});

}  // namespace pelage
