// A model and its fields as the marcher reads them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/marched/march_scene.h"
#include "renderer/pattern/surface_volume.h"
#include "renderer/visibility/changed_fur.h"

namespace pelage {

class FurMesh {
 public:
  FurMesh(const FurModel& model, const FurFields& fields);

  /// Takes over the dirty ranges, or all where other skin is bare or other fields are painted. Bytes that were written.
  std::size_t update(const FurFields& fields);

  /// Valid until the next update.
  MarchMesh view() const;
  std::uint64_t original() const { return original_; }
  bool has_colours() const { return has_colours_; }
  const BaseImages& images() const { return images_; }
  VolumeSurface surface() const { return {positions_, normals_, triangles_, rest_positions_, rest_normals_}; }
  /// Of render vertices, where patterns and tufts see them.
  std::span<const glm::vec3> rest_places() const { return rest_positions_.empty() ? positions_ : rest_positions_; }
  bool paints_fur() const { return !paint_.empty(); }
  std::size_t bytes() const;
  std::uint64_t changes() const { return changed_.count(); }
  std::optional<ClipBox> changed_box(const Coat& coat, const glm::mat4& to_clip, std::uint64_t since) const {
    return changed_.box({positions_, normals_, tangents_, groom_, triangles_}, coat, to_clip, since);
  }

 private:
  void find_patches(const std::vector<std::uint32_t>& welded);
  void change(const FurFields& fields, std::uint32_t begin, std::uint32_t end);  // of render vertices
  bool set_paint(const FurPaint& paint);                                         // whether other fields are painted

  std::uint64_t original_ = 0;
  bool has_colours_ = false;
  BaseImages images_;
  std::vector<glm::vec3> positions_, normals_, shading_normals_, tangents_, image_uvs_, colours_, groom_;
  std::vector<glm::vec3> rest_positions_, rest_normals_;  // empty where the model stands in its rest pose
  std::vector<glm::vec2> tiles_;
  std::vector<float> weights_, fur_share_, mask_;
  std::vector<std::array<float, 6>> paint_;
  std::vector<std::array<float, 8>> painted_;
  std::vector<glm::uvec3> triangles_;
  std::vector<std::uint32_t> patches_, welded_, first_;
  std::vector<PieceAxes> axes_;
  std::vector<FurSkinRegion> skin_;
  ChangedFur changed_;
};

}  // namespace pelage
