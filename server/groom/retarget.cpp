#include "server/groom/retarget.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>

#include "server/fields/field_mix.h"
#include "server/fields/field_set.h"
#include "server/fields/field_writer.h"
#include "server/groom/evaluate.h"
#include "server/groom/symmetry.h"
#include "server/groom/tools.h"

namespace pelage {

namespace {

/// Returns the scale from one model's box to the other's along each axis, in internal coordinates.
glm::dvec3 box_scale(const Mesh& from, const Mesh& to) {
  constexpr double flat = 1e-9;  // sizes
  const glm::dvec3 before = (from.report.bounds.max - from.report.bounds.min) / from.size;
  const glm::dvec3 after = (to.report.bounds.max - to.report.bounds.min) / to.size;
  glm::dvec3 scale(1);
  for (int axis = 0; axis < 3; ++axis) {
    if (before[axis] > flat && after[axis] > flat) scale[axis] = after[axis] / before[axis];
  }
  return scale;
}

}  // namespace

AlignmentTransform internal_alignment(const Mesh& from, const Mesh& to, Alignment how) {
  if (how == Alignment::box) return {box_scale(from, to), glm::dvec3(0)};  // both boxes are centred at 0
  return {glm::dvec3(from.size / to.size), (from.centre - to.centre) / to.size};
}

AlignmentTransform model_alignment(const Mesh& from, const Mesh& to, Alignment how) {
  if (how == Alignment::none) return {};
  const glm::dvec3 scale = box_scale(from, to) * (to.size / from.size);
  return {scale, to.centre - scale * from.centre};
}

namespace {

constexpr double same_position = 1e-9;  // sizes

/// A map from the model coordinates of one model to those of another.
class ModelMap : public PositionMap {
 public:
  ModelMap(const Surface& from, const Surface& to, Alignment how)
      : from_(from),
        to_(to),
        alignment_(model_alignment(from.mesh(), to.mesh(), how)),
        length_scale_(how == Alignment::none ? 1 : to.mesh().size / from.mesh().size) {}

  glm::dvec3 mapped(glm::dvec3 position) const override { return alignment_.mapped(position); }

  /// Maps a position on one model's skin to the other model's skin. A position off the skin keeps its offset from it.
  glm::dvec3 on_skin(glm::dvec3 position) const override {
    const Mesh &mesh = from_.mesh(), &other = to_.mesh();
    const glm::dvec3 skin = mesh.to_model(from_.position(from_.nearest(mesh.to_internal(position))));
    const glm::dvec3 wanted = other.to_internal(alignment_.mapped(skin));
    const glm::dvec3 shift = to_.position(to_.nearest(wanted)) - wanted;
    const glm::dvec3 straight = alignment_.mapped(position);
    return glm::length(shift) < same_position ? straight : straight + other.size * shift;
  }

  SurfaceSample on_skin(const SurfaceSample& sample) const override {
    const glm::dvec3 skin = from_.mesh().to_model(from_.position({sample.triangle, sample.barycentric}));
    const glm::dvec3 wanted = to_.mesh().to_internal(alignment_.mapped(skin));
    const bool numbered = sample.triangle < to_.mesh().triangles.size();
    if (numbered && glm::distance(to_.position({sample.triangle, sample.barycentric}), wanted) < same_position)
      return sample;
    const SurfacePoint there = to_.nearest(wanted);
    return {there.triangle, glm::max(there.barycentric, 0.0)};
  }

  glm::dvec3 direction(glm::dvec3 direction) const override { return alignment_.direction(direction); }
  glm::dvec3 normal(glm::dvec3 normal) const override { return alignment_.normal(normal); }
  double length(double length) const override { return length * length_scale_; }
  bool mirrors() const override { return false; }

 private:
  const Surface &from_, &to_;
  AlignmentTransform alignment_;
  double length_scale_;
};

/// Refuses commands that are valid on one model only.
Status check_transferable(const Command& command) {
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

Result<Command> transferred_command(const Command& resolved, const Surface& from, const Surface& to, Alignment how) {
  if (Status stays = check_transferable(resolved); !stays.ok()) return stays;
  Command transferred = resolved;
  move_command(transferred, ModelMap(from, to, how), from);
  return transferred;
}

double length_factor(const Mesh& from, const Mesh& to, Alignment how) {
  return how == Alignment::none ? from.size / to.size : 1;
}

NearestCorners nearest_corners(const Mesh& mesh, const Surface& source, Alignment align) {
  const AlignmentTransform alignment = internal_alignment(mesh, source.mesh(), align);
  std::vector<std::array<MixShare, 3>> corners(mesh.positions.size());
  std::vector<double> distances(corners.size());
  for_each_range_in_parallel(static_cast<std::uint32_t>(corners.size()), [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t v = begin; v < end; ++v) {
      const glm::dvec3 position = alignment.mapped(glm::dvec3(mesh.positions[v]));
      const SurfacePoint point = source.nearest(position);
      distances[v] = glm::distance(source.position(point), position);
      for (std::size_t k = 0; k < 3; ++k) {
        const int corner = static_cast<int>(k);
        corners[v][k] = {source.mesh().triangles[point.triangle][corner], point.barycentric[corner]};
      }
    }
  });
  const auto far = std::count_if(distances.begin(), distances.end(), [](double d) { return d > far_threshold; });
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return {std::move(corners), static_cast<std::size_t>(far), *middle};
}

namespace {

std::string far_warning(std::size_t far, std::size_t vertices) {
  return std::to_string(far) + " of " + std::to_string(vertices) +
         " vertices lie farther than .05 sizes from the model that they take their fur from";
}

/// Returns whether the command takes the field. The mask selects where tools act, so it is taken only if the command
/// names it.
bool takes(const Retarget& command, Field field) {
  if (command.fields.empty()) return field != Field::mask;
  return std::count(command.fields.begin(), command.fields.end(), field) > 0;
}

}  // namespace

// Blends each value V with the source's nearest value S: (1 - w) V + w S, which is exactly S at full strength.
Evaluation run(const Retarget& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  assert(extras.source != nullptr && extras.baseline != nullptr);
  const Surface& source = *extras.source;
  const FieldSet& source_fields = *extras.baseline;
  const Mesh &mesh = surface.mesh(), &other = source.mesh();
  const NearestCorners found = nearest_corners(mesh, source, command.align);
  const double length_scale = length_factor(other, mesh, command.align);
  Evaluation done;
  if (found.far > 0) done.warnings.push_back(far_warning(found.far, found.corners.size()));
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (!takes(command, field) || (fields.at_default(field) && source_fields.at_default(field))) continue;
    const double factor = field == Field::length ? length_scale : 1;
    const auto put = [&](std::uint32_t v, FieldWriter& writer) {
      const double weight = command.strength * double{fields.number(Field::mask, v)};
      if (weight == 0) return false;
      const glm::dvec4 there =
          to_summable(field, factor * mixed(source_fields, field, found.corners[v], other, mesh, v));
      const glm::dvec4 here = to_summable(field, glm::dvec4(fields.value(field, v)));
      return writer.put(v, from_summable(field, (1 - weight) * here + weight * there));
    };
    done.clamped += write_in_parallel(fields, field, static_cast<std::uint32_t>(fields.size()), done.delta, put);
  }
  return done;
}

}  // namespace pelage
