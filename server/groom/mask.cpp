#include <algorithm>
#include <cassert>
#include <queue>

#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/maps/draw_map.h"

namespace pelage {

namespace {

using Values = std::vector<double>;

/// Evaluates how far a shape selects each vertex, in [0, 1].
struct Chosen {
  const Surface& surface;
  Units units;
  const MapPicture* picture;

  Values none() const { return Values(surface.mesh().positions.size(), 0.0); }

  Values operator()(const MaskAll&) const { return Values(surface.mesh().positions.size(), 1.0); }
  Values operator()(const MaskVertices& list) const {
    Values chosen = none();
    for (const std::uint32_t v : list.vertices) chosen[v] = 1;
    return chosen;
  }
  Values operator()(const MaskBox& box) const {
    const Mesh& mesh = surface.mesh();
    const glm::dvec3 low = mesh.to_internal(box.min), high = mesh.to_internal(box.max);
    Values chosen = none();
    for (std::size_t v = 0; v < chosen.size(); ++v) {
      const glm::dvec3 p(mesh.positions[v]);
      chosen[v] = glm::all(glm::greaterThanEqual(p, low)) && glm::all(glm::lessThanEqual(p, high));
    }
    return chosen;
  }
  Values operator()(const MaskSphere& sphere) const {
    const Mesh& mesh = surface.mesh();
    const glm::dvec3 centre = mesh.to_internal(sphere.centre);
    const double radius = internal_length(sphere.radius, units, mesh), inner = radius * (1 - sphere.softness);
    Values chosen = none();
    for (std::size_t v = 0; v < chosen.size(); ++v) {
      const double distance = glm::distance(glm::dvec3(mesh.positions[v]), centre);
      if (distance > radius) continue;
      chosen[v] = distance <= inner ? 1 : (radius - distance) / (radius - inner);
    }
    return chosen;
  }
  Values operator()(const MaskPart& part) const {
    const Mesh& mesh = surface.mesh();
    Values chosen = none();
    std::vector<std::uint32_t> front{mesh.triangles[surface.nearest(mesh.to_internal(part.position)).triangle].x};
    chosen[front.front()] = 1;
    while (!front.empty()) {
      const std::uint32_t v = front.back();
      front.pop_back();
      for (const std::uint32_t next : surface.neighbours(v)) {
        if (chosen[next] == 0) chosen[next] = 1, front.push_back(next);
      }
    }
    return chosen;
  }
  Values operator()(const MaskMaterial& named) const {
    const Mesh& mesh = surface.mesh();
    Values chosen = none();
    for (std::size_t t = 0; t < mesh.materials.size(); ++t) {
      const std::uint16_t material = mesh.materials[t];
      if (material == no_material || mesh.report.materials[material].name != named.name) continue;
      for (int k = 0; k < 3; ++k) chosen[mesh.triangles[t][k]] = 1;
    }
    return chosen;
  }
  Values operator()(const MaskPicture& named) const {
    assert(picture != nullptr);
    return read_channel(surface.mesh(), *picture, named.channel);
  }
};

double combined(const ChangeMask& command, double now, double chosen) {
  const double value = chosen * command.value;
  switch (command.combine) {
    case MaskCombine::replace: return value + (1 - chosen) * (1 - command.value);
    case MaskCombine::add: return std::min(now + value, 1.0);
    case MaskCombine::subtract: return std::max(now - value, 0.0);
    case MaskCombine::intersect: return now * value;
  }
  assert(false);
  return now;
}

/// Returns for each vertex the largest value within a distance along edges. The search visits larger values first, and
/// of equal values the paths with most distance left; a path that reaches a vertex with no more distance left than an
/// earlier path cannot improve anything.
Values grown(const Surface& surface, const Values& mask, double distance) {
  struct PathEnd {
    double value, left;
    std::uint32_t vertex;
    bool operator<(const PathEnd& other) const {
      return value != other.value ? value < other.value
             : left != other.left ? left < other.left
                                  : vertex > other.vertex;
    }
  };
  const Mesh& mesh = surface.mesh();
  std::priority_queue<PathEnd> paths;
  for (std::uint32_t v = 0; v < mask.size(); ++v) {
    if (mask[v] > 0) paths.push({mask[v], distance, v});
  }
  Values max(mask.size(), 0.0), left(mask.size(), -1.0);
  while (!paths.empty()) {
    const PathEnd path = paths.top();
    paths.pop();
    if (path.left <= left[path.vertex]) continue;
    left[path.vertex] = path.left;
    max[path.vertex] = std::max(max[path.vertex], path.value);
    const glm::dvec3 here(mesh.positions[path.vertex]);
    for (const std::uint32_t next : surface.neighbours(path.vertex)) {
      const double remaining = path.left - glm::distance(here, glm::dvec3(mesh.positions[next]));
      if (remaining >= 0 && remaining > left[next]) paths.push({path.value, remaining, next});
    }
  }
  return max;
}

Values inverted(Values mask) {
  for (double& value : mask) value = 1 - value;
  return mask;
}

Values smoothed(const Surface& surface, Values mask, int passes, const Cancel& cancel) {
  Values next(mask.size());
  for (int pass = 0; pass < passes; ++pass) {
    cancel.check();
    for (std::uint32_t v = 0; v < mask.size(); ++v) {
      double sum = 0;
      const auto others = surface.neighbours(v);
      for (const std::uint32_t other : others) sum += mask[other];
      next[v] = others.empty() ? mask[v] : 0.5 * mask[v] + 0.5 * sum / static_cast<double>(others.size());
    }
    mask.swap(next);
  }
  return mask;
}

Values selected(const ChangeMask& command, const Surface& surface, const MapPicture* picture, Values mask) {
  const Values chosen = std::visit(Chosen{surface, command.units, picture}, command.shape);
  for (std::size_t v = 0; v < mask.size(); ++v) mask[v] = combined(command, mask[v], chosen[v]);
  return mask;
}

Values changed(const ChangeMask& command, const Surface& surface, const ToolExtras& extras, Values mask) {
  const double distance = internal_length(command.distance, command.units, surface.mesh());
  switch (command.action) {
    case MaskAction::select: return selected(command, surface, extras.picture, std::move(mask));
    case MaskAction::grow: return grown(surface, mask, distance);
    case MaskAction::shrink: return inverted(grown(surface, inverted(std::move(mask)), distance));
    case MaskAction::smooth: return smoothed(surface, std::move(mask), command.passes, extras.cancel);
    case MaskAction::invert: return inverted(std::move(mask));
  }
  assert(false);
  return mask;
}

}  // namespace

Evaluation run(const ChangeMask& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  Values now(fields.size());
  for (std::uint32_t v = 0; v < now.size(); ++v) now[v] = fields.number(Field::mask, v);
  const Values after = changed(command, surface, extras, std::move(now));
  FieldWriter writer(fields, Field::mask);
  for (std::uint32_t v = 0; v < after.size(); ++v) writer.put(v, after[v]);
  Evaluation done;
  writer.finish(done.delta);
  return done;
}

}  // namespace pelage
