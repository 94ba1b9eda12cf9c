#include "server/surface/weld.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "protocol/base/limits.h"
#include "protocol/base/random.h"

namespace pelage {

namespace {

struct PositionHash {
  std::size_t operator()(const glm::dvec3& p) const {
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i) hash = mix_bits(hash ^ std::bit_cast<std::uint64_t>(p[i]));
    return hash;
  }
};

bool is_finite(glm::dvec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

double largest_coordinate(glm::dvec3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

bool is_face(const RawModel& raw, const Polygons::Face& face) {
  if (face.size < 3) return false;
  for (std::uint32_t i = face.begin; i < face.begin + face.size; ++i) {
    if (raw.corners[i] >= raw.positions.size() || !is_finite(raw.positions[raw.corners[i]])) return false;
  }
  return true;
}

/// The welded vertices, made as the faces name them.
class Welder {
 public:
  Welder(const RawModel& raw, const glm::dmat3& turn, Polygons& out) : raw_(raw), turn_(turn), out_(out) {
    out_.vertex.assign(raw.positions.size(), no_position);
  }

  /// False when a coordinate is over the limit.
  bool add(std::uint32_t source) {
    if (out_.vertex[source] != no_position) return true;
    if (largest_coordinate(raw_.positions[source]) > limits::model_coordinate) return false;
    const glm::dvec3 position = turn_ * raw_.positions[source] + 0.0;  // -0 + 0 is 0
    const auto [entry, is_new] = known_.try_emplace(position, static_cast<std::uint32_t>(out_.positions.size()));
    if (is_new) {
      out_.positions.push_back(position);
      out_.sources.push_back(source);
    }
    out_.vertex[source] = entry->second;
    ++out_.used;
    return true;
  }

 private:
  const RawModel& raw_;
  const glm::dmat3& turn_;
  Polygons& out_;
  std::unordered_map<glm::dvec3, std::uint32_t, PositionHash> known_;
};

}  // namespace

Result<Polygons> weld(const RawModel& raw, const glm::dmat3& turn) {
  Polygons polygons;
  Welder welder(raw, turn, polygons);
  std::uint32_t begin = 0;
  for (std::uint32_t f = 0; f < raw.face_sizes.size(); ++f) {
    const Polygons::Face face{f, begin, raw.face_sizes[f]};
    begin += face.size;
    if (!is_face(raw, face)) {
      ++polygons.invalid_faces;
      continue;
    }
    for (std::uint32_t i = face.begin; i < begin; ++i) {
      if (!welder.add(raw.corners[i])) {
        return failure(Code::invalid, "The model has coordinates over 1e20.", "", "at most 1e20");
      }
    }
    polygons.faces.push_back(face);
  }
  return polygons;
}

}  // namespace pelage
