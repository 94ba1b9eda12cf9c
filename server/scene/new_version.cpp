#include "server/scene/new_version.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "server/fields/field_mix.h"
#include "server/groom/evaluate.h"
#include "server/groom/retarget.h"
#include "server/surface/materials.h"

namespace pelage {

namespace {

struct Aligned {
  Alignment how;
  NearestCorners nearest;
};

constexpr double as_good = 0.001;  // difference of medians that counts as equal, in sizes of the source

/// Chooses between aligning the bounding boxes and leaving coordinates as they are, by the median distance to the
/// source: a single part that moved changes the box a lot, but the median little.
Aligned align(const SceneModel& from, const SceneModel& to) {
  const Mesh& mesh = to.surface.mesh();
  Aligned as_they_are{Alignment::none, nearest_corners(mesh, from.surface, Alignment::none)};
  if (as_they_are.nearest.median <= as_good) return as_they_are;
  Aligned by_box{Alignment::box, nearest_corners(mesh, from.surface, Alignment::box)};
  const bool box_is_better = by_box.nearest.median + as_good < as_they_are.nearest.median;
  return box_is_better ? std::move(by_box) : std::move(as_they_are);
}

/// Transfers what the settings place on or around the model by converting the commands that set it.
class SettingsTransfer {
 public:
  SettingsTransfer(const Surface& from, const Surface& to, Alignment how) : from_(from), to_(to), how_(how) {}

  SceneSettings transferred(SceneSettings settings) const {
    settings.eyes = moved(SetEyes{std::move(settings.eyes)}).eyes;
    settings.curves = moved(SetCurves{std::move(settings.curves)}).groups;
    settings.skin = moved(SetSkin{std::move(settings.skin)}).regions;
    settings.blowers = moved(SetBlowers{std::move(settings.blowers)}).blowers;
    settings.attractors = moved(SetAttractors{std::move(settings.attractors)}).attractors;
    settings.symmetry = moved(SetSymmetry{std::move(settings.symmetry)}).symmetry;
    return settings;
  }

 private:
  template <class Tool>
  Tool moved(Tool tool) const {
    Result<Command> transferred = transferred_command(tool, from_, to_, how_);
    assert(transferred);  // transferred_command refuses only commands that name vertices or revisions
    return std::get<Tool>(std::move(*transferred));
  }

  const Surface &from_, &to_;
  Alignment how_;
};

/// Multiplies a size by a factor and clamps it to its range.
void scale(double& size, double factor, double min, double max) { size = std::clamp(factor * size, min, max); }

void scale(Coat& coat, double factor) {
  scale(coat.tile, factor, 0.01, 1);
  scale(coat.width_root, factor, 0, 0.05), scale(coat.width_tip, factor, 0, 0.05);
  scale(coat.clump_size, factor, 0.001, 0.5), scale(coat.fine_clump_size, factor, 0.001, 0.5);
  scale(coat.lodge_size, factor, 0.001, 0.5), scale(coat.tufts.size, factor, 0.01, 1);
  scale(coat.pattern.scale, factor, 0.005, 2), scale(coat.variation.size, factor, 0.005, 2);
}

/// Rescales sizes that are relative to the model's size, so that they keep their length in its unit.
SceneSettings scaled(SceneSettings settings, double factor) {
  if (factor == 1) return settings;
  for (NamedCoat& coat : settings.coats) scale(coat.coat, factor);
  for (Eye& eye : settings.eyes) scale(eye.radius, factor, 1e-6, 1e6);
  for (SkinRegion& region : settings.skin) {
    for (int axis = 0; axis < 3; ++axis) scale(region.radii[axis], factor, 1e-6, 1e6);
    scale(region.bumps.height, factor, 0, 0.1), scale(region.bumps.size, factor, 1e-4, 1);
  }
  for (CurveGroup& group : settings.curves)
    scale(group.width_root, factor, 0, 0.1), scale(group.width_tip, factor, 0, 0.1);
  return settings;
}

}  // namespace

namespace {

/// Makes new parts bare if their material's name says that they have no fur, as on a new model.
void bare_new_parts(FieldSet& fields, const Mesh& before, const Mesh& after) {
  const std::vector<bool> bare = bare_vertices(after, before.report.materials);
  for (std::uint32_t v = 0; v < bare.size(); ++v)
    if (bare[v]) fields.set(Field::bare, v, glm::vec4(1, 0, 0, 0));
}

}  // namespace

TransferredGroom transferred_groom(const SceneSnapshot& now, const SceneModel& model) {
  const Surface &before = now.model->surface, &after = model.surface;
  const Aligned aligned = align(*now.model, model);
  const double factor = length_factor(before.mesh(), after.mesh(), aligned.how);
  SceneSettings settings = SettingsTransfer(before, after, aligned.how).transferred(*now.settings);
  settings.checkpoints.clear();  // their revisions are gone
  if (after.mesh().texture_uv.empty()) settings.skin_texture.clear();
  FieldSet fields =
      transferred(*now.fields, before.mesh(), after.mesh(), aligned.nearest.corners, factor, now.settings->layers);
  bare_new_parts(fields, before.mesh(), after.mesh());
  const TransferReport report{aligned.how, aligned.nearest.corners.size(), aligned.nearest.far, {}};
  return {std::move(fields), scaled(std::move(settings), factor), report};
}

}  // namespace pelage
