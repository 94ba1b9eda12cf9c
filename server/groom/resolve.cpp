#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>

#include "base/limits.h"
#include "server/groom/brush.h"
#include "server/groom/evaluate.h"
#include "server/groom/reach.h"
#include "server/patches/patches.h"

namespace pelage {

namespace {

std::string sample_pointer(std::size_t sample, const char* field) {
  return "/stroke/samples/" + std::to_string(sample) + "/" + field;
}

/// Checks what can only be checked against the surface, for each sample but pixels.
Status check_position(const StrokeSample& sample, std::size_t number, const Surface& surface) {
  const Mesh& mesh = surface.mesh();
  if (const auto* in_space = std::get_if<PositionSample>(&sample.position)) {
    if (!reachable(mesh.to_internal(in_space->position))) return out_of_reach(sample_pointer(number, "position"));
  }
  if (const auto* on_skin = std::get_if<SurfaceSample>(&sample.position);
      on_skin && on_skin->triangle >= mesh.triangles.size()) {
    return failure(Code::invalid, "the model has no such triangle", sample_pointer(number, "triangle"),
                   "below " + std::to_string(mesh.triangles.size()));
  }
  return {};
}

Status check_view(const Stroke& stroke, const Mesh& mesh) {
  if (!stroke.view || stroke.view->camera.automatic != AutoView::none) return {};
  const Camera& camera = stroke.view->camera;
  if (!reachable(mesh.to_internal(camera.position))) return out_of_reach("/stroke/view/camera/position");
  if (!reachable(mesh.to_internal(camera.target))) return out_of_reach("/stroke/view/camera/target");
  return {};
}

bool shows_pixels(const Stroke& stroke) {
  return std::any_of(stroke.samples.begin(), stroke.samples.end(),
                     [](const StrokeSample& sample) { return std::holds_alternative<ScreenSample>(sample.position); });
}

Stroke seen_from(const View& view) {
  Stroke stroke;
  stroke.view = view;
  return stroke;
}

/// The standing fur of all visible coats.
class VisibleCoats {
 public:
  VisibleCoats(const Surface& surface, const VisibleFur& fur) {
    for (const NamedCoat& coat : fur.coats) {
      if (coat.muted) continue;
      fields_.push_back(fur.fields.of_coat(coat.id));
      standing_.emplace_back(surface, fields_.back(), coat.coat);
    }
  }

  /// Returns the nearest of the coats' hits (StandingFur::first_hit).
  std::optional<glm::dvec3> first_hit(const StandingFur::Ray& ray, double max_gap) const {
    std::optional<glm::dvec3> nearest;
    for (const StandingFur& standing : standing_) {
      const std::optional<glm::dvec3> hit = standing.first_hit(ray, max_gap);
      if (hit && (!nearest || glm::distance(*hit, ray.origin) < glm::distance(*nearest, ray.origin))) nearest = hit;
    }
    return nearest;
  }
  double visits() const {
    double sum = 0;
    for (const StandingFur& standing : standing_) sum += standing.visits();
    return sum;
  }

 private:
  std::deque<FieldSet> fields_;  // a deque, because standing_ refers to its elements
  std::deque<StandingFur> standing_;
};

/// Finds the positions visible under pixels of a stroke's view.
class VisiblePositions {
 public:
  /// A null `fur` finds positions on the skin alone.
  VisiblePositions(const Stroke& stroke, const Brush& brush, const Surface& surface, const VisibleCoats* fur)
      : view_(*stroke.view),
        camera_(place_camera(view_.camera, static_cast<double>(view_.width) / view_.height, surface.mesh())),
        surface_(surface),
        fur_(fur),
        brush_(seen_from(view_), brush, surface) {}

  /// Returns the position under a pixel: on the fur if the fur is in front of all skin, else on the skin; nothing if
  /// neither is hit.
  std::optional<decltype(StrokeSample::position)> at(glm::dvec2 pixel) const {
    const glm::dvec3 direction = glm::normalize(pixel_ray(camera_, pixel, view_.width, view_.height));
    const std::optional<SurfacePoint> skin = surface_.raycast(camera_.position, direction);
    if (const auto hit = fur_ ? fur_at(direction, skin) : std::nullopt)
      return PositionSample{surface_.mesh().to_model(*hit)};
    if (skin) return SurfaceSample{skin->triangle, glm::max(skin->barycentric, 0.0)};
    return std::nullopt;
  }

 private:
  /// Returns the hit on the fur. In front of skin the fur must cover the pixel; beyond the silhouette it may lie up to
  /// the brush's radius to the side.
  std::optional<glm::dvec3> fur_at(glm::dvec3 direction, const std::optional<SurfacePoint>& skin) const {
    const glm::dvec3 end = skin ? surface_.position(*skin) : glm::dvec3(0);
    const double length = skin ? glm::distance(end, camera_.position) : std::numeric_limits<double>::infinity();
    return fur_->first_hit({camera_.position, direction, length}, skin ? 0 : brush_.radius_at(end));
  }

  const View& view_;
  PlacedCamera camera_;
  const Surface& surface_;
  const VisibleCoats* fur_;
  BrushStroke brush_;
};

/// Checks for cancellation, and the cost including the stroke's visits so far.
Status check_visits(const VisibleFur& fur, double visits) {
  if (fur.cancel.asked()) return nobody_waits();
  if (fur.visits + visits <= limits::evaluation_visits) return {};
  return failure(Code::invalid, "the pixels of the stroke are too much work over so much fur", "/stroke/samples",
                 fmt::format("at most {:.0f} visits of vertices in a request", limits::evaluation_visits));
}

Status resolve_stroke(Stroke& stroke, Brush& brush, const Surface& surface, const VisibleFur* fur) {
  if (Status bad = check_view(stroke, surface.mesh()); !bad.ok()) return bad;
  const bool pixels = shows_pixels(stroke);
  if (pixels && !stroke.view)
    return failure(Code::invalid, "pixel samples need the view they were drawn on", "/stroke/view");
  if (!brush.reach && pixels && brush.falloff_shape == FalloffShape::volume) brush.reach = Reach::fur;
  std::optional<VisibleCoats> standing;
  if (pixels && fur && brush.reach == Reach::fur) standing.emplace(surface, *fur);
  std::optional<VisiblePositions> seen;
  if (pixels) seen.emplace(stroke, brush, surface, standing ? &*standing : nullptr);
  std::vector<StrokeSample> resolved;
  for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
    StrokeSample sample = stroke.samples[i];
    if (Status bad = check_position(sample, i, surface); !bad.ok()) return bad;
    if (const auto* pixel = std::get_if<ScreenSample>(&sample.position)) {
      const auto position = seen->at(pixel->screen);
      if (Status bad = standing ? check_visits(*fur, standing->visits()) : Status{}; !bad.ok()) return bad;
      if (!position) continue;
      sample.position = *position;
    }
    resolved.push_back(sample);
  }
  stroke.samples = std::move(resolved);
  if (standing) fur->visits += standing->visits();
  return {};
}

Status check_brush(const Stroke& stroke, const Brush& brush, const Surface& surface) {
  const BrushStroke painted(stroke, brush, surface);
  if (!reachable_length(painted.radius())) return out_of_reach("/brush/radius");
  if (painted.dab_count() <= limits::dabs_per_stroke) return {};
  return failure(Code::invalid, "the stroke is too long for so small a brush and spacing", "/brush/spacing",
                 "at most 100000 dabs of spacing x radius in a stroke");
}

/// Checks the positions and lengths of a command, apart from its stroke.
struct CheckTool {
  const Mesh& mesh;

  Status check_reach(glm::dvec3 position, std::string pointer) const {
    return reachable(mesh.to_internal(position)) ? Status{} : out_of_reach(std::move(pointer));
  }
  Status length(double value, Units units, std::string pointer) const {
    return reachable_length(std::abs(internal_length(value, units, mesh))) ? Status{}
                                                                           : out_of_reach(std::move(pointer));
  }
  Status symmetry(const Symmetry& symmetry) const {
    for (std::size_t k = 0; k < symmetry.planes.size(); ++k) {
      Status far = check_reach(symmetry.planes[k].point, "/symmetry/planes/" + std::to_string(k) + "/point");
      if (!far.ok()) return far;
    }
    return check_reach(symmetry.axis_point, "/symmetry/axis_point");
  }
  /// Checks the width of Gaussians.
  Status sigma(double value, Units units) const {
    if (internal_length(value, units, mesh) >= limits::min_sigma) return length(value, units, "/sigma");
    return failure(Code::invalid, "the width is too small for the model", "/sigma", "at least 1e-6 sizes");
  }
  /// Checks the width and reach of keys or curves.
  template <class Guides>
  Status width_and_reach(const Guides& command) const {
    if (Status bad = sigma(command.sigma, command.units); !bad.ok() || !command.reach) return bad;
    return length(*command.reach, command.units, "/reach");
  }
  Status fur_length(double value, Units units, std::string pointer) const {
    if (internal_length(value, units, mesh) <= limits::fur_length) return {};
    return failure(Code::invalid, "fur cannot be so long", std::move(pointer), "at most 10 sizes of the model");
  }

  Status operator()(const Comb&) const { return {}; }  // a direction is valid anywhere
  Status operator()(const Blow& blow) const {
    if (Status far = check_reach(blow.source, "/source"); !far.ok()) return far;
    return length(blow.fall, blow.units, "/fall");
  }
  Status operator()(const Interpolate& command) const {
    for (std::size_t k = 0; k < command.keys.size(); ++k) {
      const std::string pointer = "/keys/" + std::to_string(k);
      if (Status far = check_reach(command.keys[k].position, pointer + "/position"); !far.ok()) return far;
      if (!command.keys[k].length) continue;
      if (Status far = fur_length(*command.keys[k].length, command.units, pointer + "/length"); !far.ok()) return far;
    }
    return width_and_reach(command);
  }
  Status operator()(const Flow& command) const {
    for (std::size_t c = 0; c < command.curves.size(); ++c) {
      for (std::size_t p = 0; p < command.curves[c].size(); ++p) {
        Status far = check_reach(command.curves[c][p], "/curves/" + std::to_string(c) + "/" + std::to_string(p));
        if (!far.ok()) return far;
      }
    }
    return width_and_reach(command);
  }
  Status operator()(const Noise& command) const { return length(command.feature_size, command.units, "/feature_size"); }
  Status operator()(const Unify& command) const {
    return command.length ? fur_length(*command.length, command.units, "/length") : Status{};
  }
  Status operator()(const Length& command) const {
    if (command.mode == LengthMode::scale || command.mode == LengthMode::jitter) {
      constexpr double max = 1e6;
      return command.value <= max ? Status{} : failure(Code::invalid, "no fur grows so much", "/value", "at most 1e6");
    }
    return fur_length(std::abs(command.value), command.units, "/value");
  }
  Status operator()(const Trim& command) const {
    if (const auto* plane = std::get_if<TrimPlane>(&command.shape)) return check_reach(plane->point, "/plane/point");
    if (const auto* sphere = std::get_if<TrimSphere>(&command.shape)) {
      if (Status far = check_reach(sphere->centre, "/sphere/centre"); !far.ok()) return far;
      return length(sphere->radius, command.units, "/sphere/radius");
    }
    return length(std::get<double>(command.shape), command.units, "/height");
  }
  Status operator()(const ChangeMask& command) const {
    if (std::holds_alternative<MaskPicture>(command.shape)) {
      if (Status none = has_uvs("/picture/name"); !none.ok()) return none;
    }
    if (const auto* material = std::get_if<MaskMaterial>(&command.shape)) return has_material(material->name);
    if (const auto* list = std::get_if<MaskVertices>(&command.shape)) {
      for (std::size_t k = 0; k < list->vertices.size(); ++k) {
        if (list->vertices[k] < mesh.positions.size()) continue;
        return failure(Code::invalid, "the model has no such vertex", "/vertices/" + std::to_string(k),
                       "below " + std::to_string(mesh.positions.size()));
      }
    }
    if (const auto* sphere = std::get_if<MaskSphere>(&command.shape)) {
      if (Status far = check_reach(sphere->centre, "/sphere/centre"); !far.ok()) return far;
      if (Status far = length(sphere->radius, command.units, "/sphere/radius"); !far.ok()) return far;
    }
    if (const auto* part = std::get_if<MaskPart>(&command.shape)) {
      if (Status far = check_reach(part->position, "/part/position"); !far.ok()) return far;
    }
    return length(command.distance, command.units, "/distance");
  }
  Status operator()(const SetBlowers& command) const {
    for (std::size_t k = 0; k < command.blowers.size(); ++k) {
      if (Status far = (*this)(command.blowers[k].blow); !far.ok()) return below("/blowers/", k, std::move(far));
    }
    return {};
  }
  Status operator()(const SetAttractors& command) const {
    for (std::size_t k = 0; k < command.attractors.size(); ++k) {
      if (Status far = (*this)(command.attractors[k].attract); !far.ok())
        return below("/attractors/", k, std::move(far));
    }
    return {};
  }
  Status operator()(const SetSymmetry& command) const { return symmetry(command.symmetry); }
  static Status below(const char* list, std::size_t member, Status status) {
    status.pointer.insert(0, list + std::to_string(member));
    return status;
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
  Status operator()(const SetSkinTexture& command) const {
    if (command.picture.empty() || has_own_uvs(mesh)) return {};
    return failure(Code::invalid, "the model has no texture coordinates to lay a picture by", "/picture",
                   "a model with texture coordinates; or own, which takes a picture off");
  }
  Status operator()(const ApplyMap& command) const {
    return command.encoding == MapEncoding::vertices ? Status{} : has_uvs("/picture");
  }
  Status has_uvs(std::string pointer) const {
    if (has_own_uvs(mesh)) return {};
    return failure(Code::invalid, "the model has no texture coordinates to read a picture by", std::move(pointer),
                   "a model with texture coordinates; docs/models.md says which have some");
  }
  Status has_material(const std::string& name) const {
    const std::vector<MaterialReport>& materials = mesh.report.materials;
    const auto has_name = [&](const MaterialReport& material) { return material.name == name; };
    if (std::any_of(materials.begin(), materials.end(), has_name)) return {};
    std::string known;
    for (std::size_t k = 0; k < std::min(materials.size(), named_losses); ++k)
      known += (known.empty() ? "" : " | ") + materials[k].name;
    if (materials.size() > named_losses) known += " | ...";
    return failure(Code::invalid, "The model has no material of that name.", "/material/name",
                   known.empty() ? "a model whose file names materials" : known);
  }
  template <Unplaced Other>
  Status operator()(const Other&) const {
    return {};
  }
};

}  // namespace

Result<Command> resolve(const Command& command, const Surface& surface, const VisibleFur* fur) {
  if (Status bad = std::visit(CheckTool{surface.mesh()}, command); !bad.ok()) return bad;
  Command resolved = command;
  Stroke* stroke = stroke_of(resolved);
  if (const Brush* brush = brush_of(resolved); brush != nullptr && brush->symmetry) {
    Status far = CheckTool{surface.mesh()}.symmetry(*brush->symmetry);
    if (!far.ok()) return far.pointer.insert(0, "/brush"), far;
  }
  if (stroke == nullptr) return resolved;
  Brush& brush = *brush_of(resolved);
  if (Status bad = resolve_stroke(*stroke, brush, surface, fur); !bad.ok()) return bad;
  if (Status bad = check_brush(*stroke, brush, surface); !bad.ok()) return bad;
  return resolved;
}

}  // namespace pelage
