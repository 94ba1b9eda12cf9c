#include "server/scene/fur_view.h"

#include "server/groom/evaluate.h"
#include "server/scene/eye_view.h"

namespace pelage {

namespace {

FurLight make_light(const Light& light, const Mesh& mesh) {
  const double length = glm::length(light.direction);
  const glm::dvec3 direction = length > 0 ? light.direction / length : glm::dvec3(0, -1, 0);
  return {light.kind, glm::vec3(direction), glm::vec3(mesh.to_internal(light.position)),
          light.colour * static_cast<float>(light.intensity)};
}

}  // namespace

std::vector<std::array<FurCorner, 3>> make_corners(const SceneModel& model) {
  const Mesh& mesh = model.surface.mesh();
  std::vector<std::array<FurCorner, 3>> corners(mesh.triangles.size());
  for (std::size_t t = 0; t < corners.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      FurCorner& corner = corners[t][k];
      corner.tile_uv = model.tile_map.corner_uv[t][k];
      corner.tile_axis = model.tile_map.axis[model.tile_map.chart[t]];
      if (mesh.corners.empty()) continue;
      const LookCorner& look = mesh.corners[t][k];
      corner.image_uv = look.uv, corner.colour = look.colour, corner.image = look.image;
    }
  }
  return corners;
}

UploadCount sync_scene(Renderer& renderer, const SceneView& scene, const std::vector<VertexRange>& dirty) {
  std::vector<DirtyRange> ranges;
  for (const VertexRange& range : dirty) ranges.push_back({range.begin, range.end});
  const FurFields fields{scene.fields.direction(), scene.fields.length(), ranges};
  if (renderer.has(scene.model.id)) return renderer.update(scene.model.id, fields);
  const Mesh& mesh = scene.model.surface.mesh();
  const std::vector<std::array<FurCorner, 3>> corners = make_corners(scene.model);
  std::vector<ImageView> images;
  for (const RawImage& image : mesh.images) images.push_back({image.width, image.height, image.rgba});
  return renderer.add({scene.model.id, mesh.positions, mesh.normals, mesh.tangents, mesh.triangles, corners, images,
                       !mesh.corners.empty()}, fields);
}

FurFrame make_frame(const SceneView& scene, const FrameRequest& request) {
  const Mesh& mesh = scene.model.surface.mesh();
  FurFrame frame;
  frame.model = scene.model.id;
  frame.coat = scene.settings.coat;
  frame.look = request.look.value_or(scene.settings.look);
  for (const Light& light : scene.settings.lights) frame.lights.push_back(make_light(light, mesh));
  for (const Eye& eye : scene.settings.eyes) frame.eyes.push_back(make_eye(eye, mesh));
  const PlacedCamera camera = place_camera(request.camera, static_cast<double>(request.width) / request.height, mesh);
  frame.camera = {glm::vec3(camera.eye), glm::vec3(camera.right), glm::vec3(camera.up), glm::vec3(camera.forward),
                  static_cast<float>(camera.tan_half_fov)};
  frame.width = request.width, frame.height = request.height;
  frame.knobs = request.knobs;
  frame.background = request.background, frame.background_colour = request.background_colour;
  frame.exposure = request.exposure, frame.tone_map = request.tone_map;
  return frame;
}

}  // namespace pelage
