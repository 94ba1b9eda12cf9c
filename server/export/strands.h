// Gathers all strands of a scene, as the tracer grows them, for files.
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

/// The transform of exported geometry into the file.
struct FileTransform {
  glm::dvec3 centre{0};  // of the model's box, in the file's axes
  glm::dmat3 turn{1};    // rotation from Pelage's axes to the file's
  double metres = 1;     // metres per unit
  Axis up = Axis::plus_y;
};
FileTransform file_transform(const Mesh& mesh, const ExportRequest& request);

/// The model's mesh, in its unit and in the file's axes, relative to the transform's centre.
struct ExportedSkin {
  std::vector<glm::vec3> points, normals;
  std::vector<glm::uvec3> triangles;
  std::vector<std::array<glm::vec2, 3>> uvs;  // for each triangle, v up; empty if there are none
};

/// The id and name that files give to the strands of one coat, or to the curves.
struct StrandGroup {
  int id = 0;  // NamedCoat::id; limits::coats for the curves
  std::string name;
};

/// The strands of a scene. Positions are internal: (model - centre) / size.
struct ExportedStrands {
  std::vector<StrandSet> sets;        // of the fur, in a deterministic order; then the curves
  std::vector<std::size_t> group_of;  // for each set: index in `groups`
  std::vector<StrandGroup> groups;
  std::size_t curve_sets = 0;       // number of sets at the end with whiskers, lashes and brows
  std::vector<glm::vec2> root_uvs;  // texture coordinates of each strand's root, v up; empty if there are none
  FileTransform transform;
  double size = 1;                   // model units per internal unit
  std::optional<ExportedSkin> skin;  // if requested

  /// Returns the number of coats, whose groups come first.
  std::size_t coats() const { return groups.size() - (curve_sets > 0 ? 1 : 0); }
  std::uint64_t count() const;
  std::uint64_t points() const;
  /// Returns the offset from the transform's centre, in the model's unit and the file's axes.
  glm::vec3 file_offset(const StrandPoint& point) const {
    return glm::vec3(transform.turn * glm::dvec3(point.position) * size);
  }
  float model_width(const StrandPoint& point) const { return static_cast<float>(2 * double{point.radius} * size); }
};

/// Grows the strands. Refused as export_scene says. Deterministic at any thread count. Throws Cancelled.
Result<ExportedStrands> gather_strands(const SceneView& scene, const ExportRequest& request, const Cancel& cancel = {});

}  // namespace pelage
