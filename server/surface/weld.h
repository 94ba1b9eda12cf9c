// The good faces of a file with welded vertices.
#pragma once

#include "protocol/base/status.h"
#include "server/surface/raw_model.h"

namespace pelage {

/// Faces that can be faces: three corners or more, all of them finite vertices of the file.
struct Polygons {
  struct Face {
    std::uint32_t source;  // in RawModel::face_sizes
    std::uint32_t begin;   // in RawModel::corners
    std::uint32_t size;
  };
  std::vector<Face> faces;
  std::vector<glm::dvec3> positions;   // welded, used ones only, turned; in order of first use
  std::vector<std::uint32_t> sources;  // of each position: the first of the file
  std::vector<std::uint32_t> vertex;   // of each position of the file: its welded one, no_position when unused
  std::size_t invalid_faces = 0;
  std::size_t used = 0;  // positions of the file that are used
};

/// Welds vertices on equal positions (bit for bit; -0 equals 0) after `turn`. Refuses (invalid) coordinates over the
/// limit.
Result<Polygons> weld(const RawModel& raw, const glm::dmat3& turn);

}  // namespace pelage
