#include "server/calibration/measured_scene.h"

#include "server/surface/patches.h"

namespace pelage {

namespace {

Coat coat_of(double width, float lightness, double clump) {
  Coat coat;
  coat.width_root *= width, coat.width_tip *= width;
  coat.clump = clump;
  for (RampStop& stop : coat.ramp) stop.colour = glm::min(stop.colour * lightness, glm::vec3(0.95f));
  return coat;
}

Coat striped(Coat coat) {
  coat.pattern.kind = PatternKind::stripes;
  coat.tufts.gather = 0.5;
  return coat;
}

}  // namespace

MeasuredScene make_measured_scene(Mesh mesh, const FirstGroom& fur, std::uint64_t id) {
  PatchMap patches = lay_patches(mesh);
  FieldSet fields = first_groom(mesh, fur);
  return {{Surface(std::move(mesh)), std::move(patches), id, "measured"}, std::move(fields), {}};
}

FurredSkin furred_skin(const SceneView& scene) {
  const Mesh& mesh = scene.model.surface.mesh();
  FurredSkin skin{mesh.positions, mesh.normals, mesh.triangles, scene.fields.length()};
  if (!mesh.triangles.empty())
    skin.pieces = static_cast<double>(scene.model.patches.pieces.size()) / static_cast<double>(mesh.triangles.size());
  for (std::size_t field = first_painted; field < field_count; ++field)
    skin.painted = skin.painted || !scene.fields.at_rest(field_at(field));
  return skin;
}

std::vector<CalibrationScene> calibration_scenes() {
  using enum AutoView;
  const Coat brown, white = coat_of(0.8, 2.6f, 0.2), dark = coat_of(1.4, 0.25f, 0.5), fine = coat_of(0.5, 1.0f, 0.6);
  const auto kajiya = ShadingModel::kajiya;
  return {
      {{Builtin::creature, 5000}, {.length = 0.03}, brown, kajiya, {{three_quarter, 1, 384}, {back, 1.6f, 256}}},
      {{Builtin::torus, 3000}, {.length = 0.03}, brown, kajiya, {{three_quarter, 1, 256}, {front, 0.6f, 256}}},
      {{Builtin::sphere, 2000}, {.length = 0.05}, white, kajiya, {{front, 1, 256}, {three_quarter, 2, 256}}},
      {{Builtin::knot, 4000}, {.length = 0.02}, dark, kajiya, {{three_quarter, 1, 256}, {left, 0.7f, 192}}},
      {{Builtin::plane, 800}, {.length = 0.04}, brown, kajiya, {{three_quarter, 1, 256}, {front, 0.8f, 256}}},
      {{Builtin::creature, 12000}, {.length = 0.015}, white, kajiya, {{left, 1, 256}, {front, 0.5f, 256}}},
      {{Builtin::torus, 1000}, {.length = 0.08}, fine, kajiya, {{front, 1, 256}, {three_quarter, 1.6f, 192}}},
      {{Builtin::knot, 8000}, {.length = 0.05}, white, kajiya, {{front, 1, 256}, {back, 1.5f, 256}}},
      {{Builtin::sphere, 6000}, {.length = 0.015}, dark, kajiya, {{three_quarter, 0.6f, 256}, {front, 1.3f, 192}}},
      {{Builtin::creature, 3000}, {.length = 0.05}, striped(brown), kajiya, {{three_quarter, 1, 256}}},
      {{Builtin::torus, 5000}, {.length = 0.02}, dark, ShadingModel::energy_conserving, {{three_quarter, 1, 256}}},
      {{Builtin::plane, 2000}, {.length = 0.02}, striped(white), kajiya, {{three_quarter, 0.7f, 256}}},
  };
}

}  // namespace pelage
