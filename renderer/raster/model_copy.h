// A copy of a model and its fields, from which fur is grown and drawn.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/input/fur_scene.h"

namespace pelage {

class ModelCopy {
 public:
  ModelCopy(const FurModel& model, EachCoat<FurFields> fields);
  ModelCopy(const ModelCopy&) = delete;  // model_ has views of its arrays
  ModelCopy& operator=(const ModelCopy&) = delete;

  /// Copies the dirty ranges of the fields, or whole fields of new coats and of fields that were added or removed; and
  /// the regions of bare skin. Returns the bytes of fields that were written.
  std::size_t update(EachCoat<FurFields> fields);

  /// Valid until the next update.
  const FurModel& model() const { return model_; }
  std::vector<FurFields> fields() const;  // of each coat
  /// Returns how many updates changed anything.
  std::uint64_t changes() const { return changes_; }
  std::uint64_t original() const { return model_.original ? model_.original : model_.id; }
  std::size_t bytes() const;

 private:
  struct CoatCopy {
    CoatId id = 0;
    std::vector<glm::vec2> direction, still;
    std::vector<float> length;
    std::vector<float> density, width, curl, clump, wetness, bare, mask;
    std::vector<glm::vec4> root_colour, tip_colour;

    std::size_t update(const FurFields& fields, std::span<const DirtyRange> dirty);
    std::size_t bytes() const;
  };

  std::vector<glm::vec3> positions_, normals_, tangents_, rest_positions_, rest_normals_;
  std::vector<glm::uvec3> triangles_;
  std::vector<std::array<FurCorner, 3>> corners_;
  std::vector<std::vector<std::uint8_t>> pixels_;
  std::vector<ImageView> images_;
  FurModel model_;
  std::vector<FurSkinRegion> skin_;
  std::vector<CoatCopy> coats_;
  std::uint64_t changes_ = 0;
};

}  // namespace pelage
