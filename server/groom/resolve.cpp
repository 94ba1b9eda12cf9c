#include <algorithm>
#include <cmath>
#include <string>

#include "protocol/base/limits.h"
#include "server/groom/brush.h"
#include "server/groom/evaluate.h"
#include "server/surface/patches.h"

namespace pelage {

namespace {

Status out_of_reach(std::string pointer) {
  return failure(Code::invalid, "too far from the model", std::move(pointer), "at most 1e6 sizes of the model");
}

bool reachable(glm::dvec3 internal) {
  const glm::dvec3 distance = glm::abs(internal);
  return distance.x <= limits::command_coordinate_sizes && distance.y <= limits::command_coordinate_sizes &&
         distance.z <= limits::command_coordinate_sizes;  // false for NaN
}

bool reachable_length(double internal) { return internal <= limits::command_coordinate_sizes; }

std::string sample_pointer(std::size_t sample, const char* field) {
  return "/stroke/samples/" + std::to_string(sample) + "/" + field;
}

/// What can only be checked against the surface, for each place but pixels.
Status check_place(const StrokeSample& sample, std::size_t number, const Surface& surface) {
  const Mesh& mesh = surface.mesh();
  if (const auto* place = std::get_if<PositionPlace>(&sample.place)) {
    if (!reachable(mesh.to_internal(place->position))) return out_of_reach(sample_pointer(number, "position"));
  }
  if (const auto* place = std::get_if<SurfacePlace>(&sample.place); place && place->triangle >= mesh.triangles.size()) {
    return failure(Code::invalid, "the model has no such triangle", sample_pointer(number, "triangle"),
                   "below " + std::to_string(mesh.triangles.size()));
  }
  return {};
}

Status check_view(const Stroke& stroke, const Mesh& mesh) {
  if (!stroke.view || stroke.view->camera.automatic != AutoView::none) return {};
  const Camera& camera = stroke.view->camera;
  if (!reachable(mesh.to_internal(camera.eye))) return out_of_reach("/stroke/view/camera/eye");
  if (!reachable(mesh.to_internal(camera.target))) return out_of_reach("/stroke/view/camera/target");
  return {};
}

/// Turns a pixel into the place on the surface that its ray hits.
std::optional<SurfacePlace> hit(const ScreenPlace& place, const View& view, const Surface& surface) {
  const double aspect = static_cast<double>(view.width) / view.height;
  const PlacedCamera camera = place_camera(view.camera, aspect, surface.mesh());
  const auto point = surface.raycast(camera.eye, pixel_ray(camera, place.screen, view.width, view.height));
  if (!point) return std::nullopt;
  return SurfacePlace{point->triangle, glm::max(point->barycentric, 0.0)};
}

Status resolve_stroke(Stroke& stroke, const Surface& surface) {
  if (Status bad = check_view(stroke, surface.mesh()); !bad.ok()) return bad;
  std::vector<StrokeSample> resolved;
  for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
    StrokeSample sample = stroke.samples[i];
    if (Status bad = check_place(sample, i, surface); !bad.ok()) return bad;
    if (const auto* pixel = std::get_if<ScreenPlace>(&sample.place)) {
      if (!stroke.view) return failure(Code::invalid, "pixel samples need the view they were drawn on", "/stroke/view");
      const auto place = hit(*pixel, *stroke.view, surface);
      if (!place) continue;
      sample.place = *place;
    }
    resolved.push_back(sample);
  }
  stroke.samples = std::move(resolved);
  return {};
}

Status check_brush(const Stroke& stroke, const Brush& brush, const Surface& surface) {
  if (!reachable_length(internal_length(brush.radius, brush.units, surface.mesh())))
    return out_of_reach("/brush/radius");
  const FieldSet no_fields(0);  // counting needs none
  if (BrushStroke(stroke, brush, surface, no_fields).dab_count() <= limits::dabs_per_stroke) return {};
  return failure(Code::invalid, "the stroke is too long for so small a brush and spacing", "/brush/spacing",
                 "at most 100000 dabs of spacing x radius in a stroke");
}

/// Positions and lengths that a tool has beside its stroke.
struct CheckTool {
  const Mesh& mesh;

  Status operator()(const Blow& blow) const {
    return reachable(mesh.to_internal(blow.source)) ? Status{} : out_of_reach("/source");
  }
  Status operator()(const Attract& attract) const {
    if (!reachable(mesh.to_internal(attract.point))) return out_of_reach("/point");
    return reachable_length(internal_length(attract.radius, attract.units, mesh)) ? Status{} : out_of_reach("/radius");
  }
  Status operator()(const SetEyes& command) const {
    for (std::size_t k = 0; k < command.eyes.size(); ++k) {
      const Eye& eye = command.eyes[k];
      const std::string pointer = "/eyes/" + std::to_string(k);
      if (!reachable(mesh.to_internal(eye.position))) return out_of_reach(pointer + "/position");
      if (eye.look_at && !reachable(mesh.to_internal(*eye.look_at))) return out_of_reach(pointer + "/look_at");
    }
    return {};
  }
  Status operator()(const SetCurves& command) const {
    for (std::size_t g = 0; g < command.groups.size(); ++g) {
      const std::vector<GuideCurve>& curves = command.groups[g].curves;
      for (std::size_t c = 0; c < curves.size(); ++c) {
        const auto far = std::find_if(curves[c].begin(), curves[c].end(),
                                      [&](glm::dvec3 point) { return !reachable(mesh.to_internal(point)); });
        if (far == curves[c].end()) continue;
        return out_of_reach("/groups/" + std::to_string(g) + "/curves/" + std::to_string(c) + "/" +
                            std::to_string(far - curves[c].begin()));
      }
    }
    return {};
  }
  Status operator()(const SetSkin& command) const {
    for (std::size_t k = 0; k < command.regions.size(); ++k) {
      if (!reachable(mesh.to_internal(command.regions[k].centre)))
        return out_of_reach("/regions/" + std::to_string(k) + "/centre");
    }
    return {};
  }
  Status operator()(const SetBasePicture& command) const {
    if (command.picture.empty() || has_own_uvs(mesh)) return {};
    return failure(Code::invalid, "the model has no texture coordinates to lay a picture by", "/picture", "own");
  }
  template <class Other>
  Status operator()(const Other&) const {
    return {};
  }
};

const Brush* brush_of(const Command& command) {
  if (const auto* comb = std::get_if<Comb>(&command)) return &comb->brush;
  if (const auto* blow = std::get_if<Blow>(&command)) return &blow->brush;
  if (const auto* attract = std::get_if<Attract>(&command)) return &attract->brush;
  return nullptr;
}

}  // namespace

Result<Command> resolve(const Command& command, const Surface& surface) {
  if (Status bad = std::visit(CheckTool{surface.mesh()}, command); !bad.ok()) return bad;
  Command resolved = command;
  Stroke* stroke = stroke_of(resolved);
  if (stroke == nullptr) return resolved;
  if (Status bad = resolve_stroke(*stroke, surface); !bad.ok()) return bad;
  if (Status bad = check_brush(*stroke, *brush_of(resolved), surface); !bad.ok()) return bad;
  return resolved;
}

}  // namespace pelage
