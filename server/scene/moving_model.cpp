#include "server/scene/moving_model.h"

#include <cmath>
#include <string>
#include <utility>

#include "server/import/import.h"
#include "server/scene/eye_view.h"
#include "server/surface/turns.h"

namespace pelage {

namespace {

/// The rigid motion of a position on the rest surface.
struct RigidMotion {
  glm::dvec3 from{0}, to{0};  // internal
  glm::dmat3 rotation{1};

  glm::dvec3 mapped(glm::dvec3 internal) const { return to + rotation * (internal - from); }
};

/// Makes a mean of nearly equal rotations a rotation again, by orthogonalizing its columns.
glm::dmat3 orthogonal(const glm::dmat3& mean) {
  const glm::dvec3 z = glm::normalize(mean[2]);
  const glm::dvec3 x = glm::normalize(mean[0] - glm::dot(mean[0], z) * z);
  return {x, glm::cross(z, x), z};
}

class SettingsMover {
 public:
  SettingsMover(const Surface& rest, const Mesh& moved, std::span<const glm::dmat3> rotations)
      : rest_(rest), moved_(moved), rotations_(rotations) {}

  void move(Eye& eye) const {
    const RigidMotion motion = motion_at(eye.position);
    eye.position = moved(motion, eye.position);
    eye.gaze = motion.rotation * eye.gaze;
    if (eye.lids && eye.lids->facing) eye.lids->facing = motion.rotation * *eye.lids->facing;
  }

  void move(SkinRegion& region) const {
    const RigidMotion motion = motion_at(region.centre);
    region.centre = moved(motion, region.centre);
    const glm::dmat3 frame = motion.rotation * tilted(upright_frame(region.axis), glm::radians(region.turn_degrees));
    region.axis = frame[2];
    const glm::dmat3 upright = upright_frame(region.axis);
    region.turn_degrees = glm::degrees(std::atan2(glm::dot(frame[0], upright[1]), glm::dot(frame[0], upright[0])));
    if (region.facing) region.facing->direction = motion.rotation * region.facing->direction;
  }

  void move(GuideCurve& curve) const {
    const RigidMotion motion = motion_at(curve.front());
    for (glm::dvec3& point : curve) point = moved(motion, point);
  }

 private:
  RigidMotion motion_at(glm::dvec3 model) const {
    const Mesh& mesh = rest_.mesh();
    const SurfacePoint point = rest_.nearest(mesh.to_internal(model));
    const glm::uvec3 corners = mesh.triangles[point.triangle];
    RigidMotion motion{.from = rest_.position(point), .rotation = glm::dmat3(0)};
    for (int k = 0; k < 3; ++k) {
      motion.to += point.barycentric[k] * glm::dvec3(moved_.positions[corners[k]]);
      motion.rotation += point.barycentric[k] * rotations_[corners[k]];
    }
    motion.rotation = orthogonal(motion.rotation);
    return motion;
  }

  glm::dvec3 moved(const RigidMotion& motion, glm::dvec3 model) const {
    return moved_.to_model(motion.mapped(rest_.mesh().to_internal(model)));
  }

  const Surface& rest_;
  const Mesh& moved_;
  std::span<const glm::dmat3> rotations_;
};

/// Returns only the shape, which is compared with other files, without materials and pictures.
RawModel shape_of(RawModel raw) {
  RawModel shape;
  shape.positions = std::move(raw.positions);
  shape.face_sizes = std::move(raw.face_sizes);
  shape.corners = std::move(raw.corners);
  return shape;
}

}  // namespace

SceneSettings moved_with_surface(SceneSettings settings, const Surface& rest, const Mesh& moved,
                                 std::span<const glm::dmat3> rotations) {
  const SettingsMover mover(rest, moved, rotations);
  for (Eye& eye : settings.eyes) mover.move(eye);
  for (SkinRegion& region : settings.skin) mover.move(region);
  for (CurveGroup& group : settings.curves) {
    for (GuideCurve& curve : group.curves) mover.move(curve);
  }
  return settings;
}

MovingModel::MovingModel(RawModel raw, StoredModel how, UnsubdividedModel patched,
                         std::shared_ptr<const SceneModel> rest)
    : raw_(std::move(raw)), how_(std::move(how)), unsubdivided_(std::move(patched)), rest_(std::move(rest)) {}

Result<MovingModel> MovingModel::create(const StoredModel& stored, std::shared_ptr<const SceneModel> rest) {
  Result<RawModel> raw = decode_raw_model(std::as_bytes(std::span(stored.raw)));
  if (!raw) return raw.status();
  Result<UnsubdividedModel> patched = prepare_model(*raw, stored);
  if (!patched) return patched.status();
  StoredModel how = stored;
  how.raw.clear();
  return MovingModel(shape_of(std::move(*raw)), std::move(how), std::move(*patched), std::move(rest));
}

Status MovingModel::check(const RawModel& raw) const {
  const auto refused = [](const std::string& problem, const std::string& limit) {
    return failure(Code::invalid, "It is not the scene's model in another pose: " + problem + ".", "", limit);
  };
  if (raw.positions.size() != raw_.positions.size())
    return refused("it has " + std::to_string(raw.positions.size()) + " vertices",
                   std::to_string(raw_.positions.size()));
  if (raw.face_sizes.size() != raw_.face_sizes.size())
    return refused("it has " + std::to_string(raw.face_sizes.size()) + " faces",
                   std::to_string(raw_.face_sizes.size()));
  if (raw.face_sizes != raw_.face_sizes || raw.corners != raw_.corners)
    return refused("its faces are of other vertices", "the same faces");
  constexpr double furthest = 1000;  // sizes
  for (const std::uint32_t source : unsubdivided_.prepared.sources) {
    const glm::dvec3 position = unsubdivided_.prepared.to_internal(raw.positions[source]);
    if (!is_finite(position) || glm::length(position) > furthest)
      return refused("vertex " + std::to_string(source + 1) + " lies too far away",
                     "1,000 sizes from the model at rest");
  }
  return {};
}

Result<PatchedMesh> MovingModel::patched(const RawModel& raw) const {
  if (Status same = check(raw); !same.ok()) return same;
  const PreparedMesh& prepared = unsubdivided_.prepared;
  const Mesh& own = prepared.mesh;
  std::vector<glm::vec3> positions;
  positions.reserve(own.positions.size());
  for (const std::uint32_t source : prepared.sources)
    positions.emplace_back(prepared.to_internal(raw.positions[source]));
  const std::vector<glm::dmat3> rotations = surface_rotations(own, positions);
  for (std::size_t v = 0; v < positions.size(); ++v) {  // back sides are offset from the vertices they copy
    const glm::vec3 source(prepared.to_internal(raw_.positions[prepared.sources[v]]));
    positions[v] += glm::vec3(rotations[v] * glm::dvec3(own.positions[v] - source));
  }
  PatchMap patches = unsubdivided_.patches;
  for (PatchPoint& point : patches.points) point.axis = glm::vec3(rotations[point.vertex] * glm::dvec3(point.axis));
  Result<PatchedMesh> split =
      apply_subdivisions({moved(own, std::move(positions), rotations), std::move(patches)}, how_);
  if (!split) return split.status();
  if (split->mesh.positions.size() != rest().positions.size() || split->mesh.triangles != rest().triangles)
    return failure(Code::invalid, "Its triangles are split differently than at rest.", "", "the same triangles");
  return split;
}

Result<Mesh> MovingModel::mesh(const RawModel& raw) const {
  Result<PatchedMesh> made = patched(raw);
  if (!made) return made.status();
  return std::move(made->mesh);
}

Result<ScenePose> MovingModel::pose(const RawModel& raw, SceneSettings settings, std::uint64_t id) const {
  Result<PatchedMesh> made = patched(raw);
  if (!made) return made.status();
  const std::vector<glm::dmat3> rotations = surface_rotations(rest(), made->mesh.positions);
  settings = moved_with_surface(std::move(settings), rest_->surface, made->mesh, rotations);
  return ScenePose{.model = finish_model(std::move(*made), how_, id, rest_), .settings = std::move(settings)};
}

}  // namespace pelage
