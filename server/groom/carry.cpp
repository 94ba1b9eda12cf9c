#include "server/groom/alignment.h"
#include "server/groom/evaluate.h"
#include "server/groom/move_command.h"

namespace pelage {

namespace {

constexpr double same_place = 1e-9;  // sizes

/// From the coordinates of one model to those of another.
class ModelMap : public PlaceMap {
 public:
  ModelMap(const Surface& from, const Surface& to)
      : from_(from), to_(to), laid_(lay_models_over(from.mesh(), to.mesh())) {}

  glm::dvec3 place(glm::dvec3 position) const override { return laid_.place(position); }

  /// What lay on the skin lies on it again, and what was off it is as far off, the same way.
  glm::dvec3 on_skin(glm::dvec3 position) const override {
    const Mesh &mesh = from_.mesh(), &other = to_.mesh();
    const glm::dvec3 skin = mesh.to_model(from_.position(from_.nearest(mesh.to_internal(position))));
    const glm::dvec3 wanted = other.to_internal(laid_.place(skin));
    const glm::dvec3 shift = to_.position(to_.nearest(wanted)) - wanted;
    const glm::dvec3 straight = laid_.place(position);
    return glm::length(shift) < same_place ? straight : straight + other.size * shift;
  }

  SurfaceSample on_skin(const SurfaceSample& place) const override {
    const glm::dvec3 skin = from_.mesh().to_model(from_.position({place.triangle, place.barycentric}));
    const glm::dvec3 wanted = to_.mesh().to_internal(laid_.place(skin));
    const bool numbered = place.triangle < to_.mesh().triangles.size();
    if (numbered && glm::distance(to_.position({place.triangle, place.barycentric}), wanted) < same_place) return place;
    const SurfacePoint there = to_.nearest(wanted);
    return {there.triangle, glm::max(there.barycentric, 0.0)};
  }

  glm::dvec3 direction(glm::dvec3 direction) const override { return laid_.direction(direction); }
  glm::dvec3 normal(glm::dvec3 normal) const override { return laid_.normal(normal); }
  double length(double length) const override { return length * (to_.mesh().size / from_.mesh().size); }
  bool mirrors() const override { return false; }

 private:
  const Surface &from_, &to_;
  Laid laid_;
};

/// What means something on one model only.
Status check_carried(const Command& command) {
  if (const auto* mask = std::get_if<ChangeMask>(&command); mask && std::holds_alternative<MaskVertices>(mask->shape))
    return failure(Code::invalid, "vertices of one model are not those of another", "/vertices",
                   "a box, sphere or part");
  const auto* erase = std::get_if<Erase>(&command);
  const auto* checkpoint = std::get_if<Checkpoint>(&command);
  if ((erase && erase->revision) || (checkpoint && checkpoint->revision))
    return failure(Code::invalid, "a revision is that of one scene", "/revision", "a checkpoint made by this log");
  return {};
}

}  // namespace

Result<Command> carried_command(const Command& resolved, const Surface& from, const Surface& to) {
  if (Status stays = check_carried(resolved); !stays.ok()) return stays;
  Command carried = resolved;
  move_command(carried, ModelMap(from, to), from);
  return carried;
}

}  // namespace pelage
