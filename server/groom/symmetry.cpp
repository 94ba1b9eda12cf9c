#include <glm/gtc/matrix_transform.hpp>

#include "server/groom/evaluate.h"
#include "server/groom/move_command.h"
#include "server/groom/vertex_frame.h"

namespace pelage {

namespace {

/// A rigid motion or a mirror image of the model's space.
struct Motion {
  glm::dmat3 turn{1};
  glm::dvec3 shift{0};

  glm::dvec3 place(glm::dvec3 p) const { return turn * p + shift; }
  glm::dvec3 direction(glm::dvec3 d) const { return turn * d; }
};

Motion after(const Motion& first, const Motion& second) {
  return {second.turn * first.turn, second.turn * first.shift + second.shift};
}

Motion mirror(const Plane& plane) {
  const glm::dvec3 n = safe_unit(plane.normal);
  return {glm::dmat3(1) - 2.0 * glm::outerProduct(n, n), 2 * glm::dot(plane.point, n) * n};
}

Motion rotation(const Symmetry& symmetry, int step) {
  const double angle = glm::radians(360.0 * step / symmetry.count);
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1), angle, safe_unit(symmetry.axis)));
  return {turn, symmetry.axis_point - turn * symmetry.axis_point};
}

/// Every motion of the symmetry but the one that moves nothing.
std::vector<Motion> motions_of(const Symmetry& symmetry) {
  std::vector<Motion> all{Motion{}};
  for (int step = 1; step < symmetry.count; ++step) all.push_back(rotation(symmetry, step));
  for (const Plane& plane : symmetry.planes) {
    const std::size_t before = all.size();
    for (std::size_t k = 0; k < before; ++k) all.push_back(after(all[k], mirror(plane)));
  }
  all.erase(all.begin());
  return all;
}

/// A motion of places on a surface: those on triangles go to the nearest ones.
class MotionMap : public PlaceMap {
 public:
  MotionMap(const Motion& motion, const Surface& surface) : motion_(motion), surface_(surface) {}

  glm::dvec3 place(glm::dvec3 position) const override { return motion_.place(position); }
  glm::dvec3 on_skin(glm::dvec3 position) const override { return motion_.place(position); }
  SurfaceSample on_skin(const SurfaceSample& place) const override {
    const Mesh& mesh = surface_.mesh();
    const glm::dvec3 position = mesh.to_model(surface_.position({place.triangle, place.barycentric}));
    const SurfacePoint there = surface_.nearest(mesh.to_internal(motion_.place(position)));
    return {there.triangle, glm::max(there.barycentric, 0.0)};
  }
  glm::dvec3 direction(glm::dvec3 direction) const override { return motion_.direction(direction); }
  glm::dvec3 normal(glm::dvec3 normal) const override { return motion_.direction(normal); }
  double length(double length) const override { return length; }
  bool mirrors() const override { return glm::determinant(motion_.turn) < 0; }

 private:
  const Motion& motion_;
  const Surface& surface_;
};

/// Keys and curves of all images together say what a body is like; one after the other they would overwrite it.
bool joins_images(Command& whole, const Command& image) {
  if (auto* keys = std::get_if<Interpolate>(&whole); keys && !keys->stroke) {
    const auto& more = std::get<Interpolate>(image).keys;
    keys->keys.insert(keys->keys.end(), more.begin(), more.end());
    return true;
  }
  if (auto* flow = std::get_if<Flow>(&whole); flow && !flow->stroke) {
    const auto& more = std::get<Flow>(image).curves;
    flow->curves.insert(flow->curves.end(), more.begin(), more.end());
    return true;
  }
  return false;
}

bool is_flood(const Command& command) {
  return std::visit(
      [](const auto& tool) {
        if constexpr (requires { tool.flood; })
          return tool.flood;
        else
          return false;
      },
      command);
}

}  // namespace

std::vector<Command> images_of(const Command& resolved, const Symmetry& symmetry, const Surface& surface) {
  std::vector<Command> images{resolved};
  if (is_flood(resolved)) return images;
  for (const Motion& motion : motions_of(symmetry)) {
    Command image = resolved;
    if (!move_command(image, MotionMap(motion, surface), surface)) break;  // no place that could be moved
    if (!joins_images(images.front(), image)) images.push_back(std::move(image));
  }
  return images;
}

}  // namespace pelage
