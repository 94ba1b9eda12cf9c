// Where on a picture fur has changed since it was drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "renderer/visibility/picture_cells.h"

namespace pelage {

struct Coat;

/// The skin that fur grows on: of each vertex its place, frame (unit) and groom (direction in tangent and bitangent,
/// length in sizes).
struct GroomedMesh {
  std::span<const glm::vec3> positions, normals, tangents, groom;
  std::span<const glm::uvec3> triangles;
};

class ChangedFur {
 public:
  /// To be told of each vertex that changes, with its groom before and after.
  void note(std::uint32_t vertex, glm::vec3 groom);
  /// How often it was told so far.
  std::uint64_t count() const { return forgotten_ + noted_.size(); }

  std::size_t bytes() const { return noted_.capacity() * sizeof(Noted); }

  /// What the fur of vertices that changed since `count` was so much, and of the triangles around them, reaches or
  /// reached; none where none has changed, everything where that is too long ago to be known.
  std::optional<ClipBox> box(const GroomedMesh& mesh, const Coat& coat, const glm::mat4& to_clip,
                             std::uint64_t since) const;

 private:
  struct Noted {
    std::uint32_t vertex;
    glm::vec3 groom;
  };
  std::vector<Noted> noted_;
  std::uint64_t forgotten_ = 0;  // before the first that is noted
};

}  // namespace pelage
