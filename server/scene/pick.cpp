#include "server/scene/pick.h"

#include <algorithm>

#include "server/groom/evaluate.h"
#include "server/groom/reach.h"
#include "server/groom/vertex_frame.h"
#include "server/scene/farthest_point.h"

namespace pelage {

namespace {

/// Interpolates the fields at the picked point. The lean of the fur is projected into the plane across the normal.
void read_fields(const Mesh& mesh, const FieldSet& fields, PickAnswer& answer) {
  glm::dvec3 lean(0);
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t v = mesh.triangles[answer.triangle][k];
    const VertexFrame frame = frame_at(mesh, v);
    const Groom groom = fields.at(v);
    const double share = answer.barycentric[k];
    lean += share * (double{groom.direction.x} * frame.tangent + double{groom.direction.y} * frame.bitangent);
    answer.length += share * double{groom.length};
    answer.stretch += share * double{groom.stretch};
  }
  lean -= glm::dot(lean, answer.normal) * answer.normal;
  answer.inclination = std::min(1.0, glm::length(lean));
  answer.direction = safe_unit(lean);
}

/// Interpolates painted fields; colours are premultiplied by their coverage.
void read_paint(const Mesh& mesh, const FieldSet& fields, PickAnswer& answer) {
  for (std::size_t i = 0; i < answer.painted.size(); ++i) {
    const Field field = field_at(first_painted + i);
    const bool colour = shape_of(field).channels == 4;
    glm::dvec4 sum(0);
    for (int k = 0; k < 3; ++k) {
      const glm::dvec4 value(fields.value(field, mesh.triangles[answer.triangle][k]));
      sum += answer.barycentric[k] * (colour ? glm::dvec4(glm::dvec3(value) * value.w, value.w) : value);
    }
    answer.painted[i] = colour && sum.w > 0 ? glm::dvec4(glm::dvec3(sum) / sum.w, sum.w) : sum;
  }
}

std::optional<SurfacePoint> under_pixel(const Surface& surface, const View& view, glm::dvec2 pixel) {
  const double aspect = static_cast<double>(view.width) / view.height;
  const PlacedCamera camera = place_camera(view.camera, aspect, surface.mesh());
  return surface.raycast(camera.position, pixel_ray(camera, pixel, view.width, view.height));
}

std::optional<SurfacePoint> picked_point(const Surface& surface, const PickRequest& wanted) {
  const Mesh& mesh = surface.mesh();
  if (wanted.ray) return surface.raycast(mesh.to_internal(wanted.ray->origin), wanted.ray->direction);
  if (wanted.farthest) return farthest_point(surface, *wanted.farthest);
  if (wanted.nearest) return surface.nearest(mesh.to_internal(*wanted.nearest));
  return under_pixel(surface, wanted.view, wanted.pixel);
}

Status check_reach(const Mesh& mesh, const PickRequest& wanted) {
  const auto check = [&](glm::dvec3 position, const char* pointer) {
    return reachable(mesh.to_internal(position)) ? Status{} : out_of_reach(pointer);
  };
  if (wanted.ray) return check(wanted.ray->origin, "/ray/origin");
  if (wanted.nearest) return check(*wanted.nearest, "/nearest");
  const Camera& camera = wanted.view.camera;
  if (wanted.farthest || camera.automatic != AutoView::none) return {};
  if (Status far = check(camera.position, "/view/camera/position"); !far.ok()) return far;
  return check(camera.target, "/view/camera/target");
}

}  // namespace

Result<PickAnswer> pick(const Surface& surface, const FieldSet& fields, const PickRequest& wanted) {
  const Mesh& mesh = surface.mesh();
  if (Status far = check_reach(mesh, wanted); !far.ok()) return far;
  const std::optional<SurfacePoint> point = picked_point(surface, wanted);
  PickAnswer answer;
  if (!point) return answer;
  answer.hit = true;
  answer.triangle = point->triangle;
  answer.barycentric = point->barycentric;
  answer.position = mesh.to_model(surface.position(*point));
  answer.normal = surface.normal(*point);
  read_fields(mesh, fields, answer);
  read_paint(mesh, fields, answer);
  return answer;
}

}  // namespace pelage
