// Light on strands, skin and ground, over lanes: compiles the code of renderer/shaders/shared, which GLSL shares, as
// C++.
#if defined(PELAGE_RASTER_SCENE_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_SCENE_LIGHT_INL_H_
#undef PELAGE_RASTER_SCENE_LIGHT_INL_H_
#else
#define PELAGE_RASTER_SCENE_LIGHT_INL_H_
#endif

#include <algorithm>
#include <cmath>

#include "renderer/optics/light-inl.h"
#include "renderer/raster/raster_scene.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// The light of a scene, under the names that the shared code reads; valid while the scene is.
struct SceneLight : FrameLight, FibreScattering {
  const RasterScene& scene;
  const glm::vec3 &camera_position, &camera_forward;
  float over_view;  // factor from a distance to the length that the picture's longer side spans there
  int shading_model;
  Index light_count;
  bool grid_there, near_there;
  glm::vec3 grid_low{0};
  float grid_cell = 1;
  glm::ivec3 grid_size{2};
  float near_cell = 1, near_mean = 0;
  float ground_height = 0, ground_contact = 0, ground_shadow = 0;
  glm::vec2 sky_low{0};
  float sky_cell = 1;
  glm::ivec2 sky_size{0};

  explicit SceneLight(const RasterScene& of)
      : FrameLight(of.optics),
        FibreScattering{of.optics.scattering, *of.optics.azimuthal},
        scene(of),
        camera_position(of.camera.position),
        camera_forward(of.camera.forward),
        over_view(static_cast<float>(std::max(of.width, of.height)) / of.camera.scale),
        shading_model(of.optics.model),
        light_count(static_cast<Index>(of.optics.lights)),
        grid_there(of.grid),
        near_there(of.near && !of.near->cells().empty()) {
    if (of.grid)
      grid_low = of.grid->layout().low, grid_cell = of.grid->layout().cell, grid_size = of.grid->layout().size;
    if (near_there) near_cell = of.near->cell(), near_mean = of.near->mean();
    if (!of.ground) return;
    ground_height = of.ground->height, ground_contact = of.ground->contact, ground_shadow = of.ground->shadow;
    sky_low = of.sky->low, sky_cell = of.sky->cell, sky_size = of.sky->size;
  }

  HWY_INLINE Crossing crossed_cell(Index light, Real first, int further) const {
    const auto* words = reinterpret_cast<const std::int32_t*>(scene.grid->crossed(light).data());
    const Int word = gather(words + further, to_int(first));
    return {to_real(hn::And(word, splat(0xffff))), to_real(hn::ShiftRight<16>(word))};
  }
  /// Returns how much strands cover of the near cell with these whole coordinates, in steps of 1 / near_one.
  HWY_INLINE Real near_count(Vec3 cell) const {
    const auto* cells = reinterpret_cast<const std::int32_t*>(scene.near->cells().data());
    const auto part = [](Real along, int factor) HWY_ATTR { return hn::Mul(to_int(along), splat(factor)); };
    const Int hashed = hn::Xor3(part(cell.x, near_of_x), part(cell.y, near_of_y), part(cell.z, near_of_z));
    const Int index = hn::And(hashed, splat(near_entries - 1));
    const Int pair = gather(cells, hn::ShiftRight<1>(index));
    return to_real(hn::And(hn::Shr(pair, hn::ShiftLeft<4>(hn::And(index, splat(1)))), splat(0xffff)));
  }
  HWY_INLINE Real sky_hidden_at(Real first, int further) const {
    return gather(scene.sky->hidden.data() + further, to_int(first));
  }
  float light_radius(Index light) const { return scene.light_sizes[light].radius; }
  bool is_directional(Index light) const { return scene.light_sizes[light].far; }
  /// Returns a point of a spiral that covers the unit disc evenly (Vogel 1979).
  static glm::vec2 disc_tap(int tap) {
    const float angle = 2.399963f * static_cast<float>(tap);
    return std::sqrt((static_cast<float>(tap) + 0.5f) / ground_light_taps) *
           glm::vec2(std::cos(angle), std::sin(angle));
  }

// clang-format off: each file uses those before it
#define FUNCTION HWY_INLINE
#include "renderer/shaders/shared/grid_shadow.glsl"
#include "renderer/shaders/shared/ground.glsl"
#include "renderer/shaders/shared/skin_light.glsl"
#include "renderer/shaders/shared/strand_light.glsl"
#undef FUNCTION
  // clang-format on
};

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
