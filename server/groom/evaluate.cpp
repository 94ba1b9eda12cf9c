#include "server/groom/evaluate.h"

#include <algorithm>
#include <cstdio>

#include "server/groom/brush.h"
#include "server/groom/tools.h"

namespace pelage {

namespace {

/// Calls the tool of a command. Settings change no field. Every command is a tool or a setting.
struct Run {
  const Surface& surface;
  const FieldSet& fields;
  const ToolExtras& extras;

  template <ToolCommand Tool>
  Evaluation operator()(const Tool& tool) const {
    static_assert(Runnable<Tool>, "a tool of tool_list.h has no run() in server/groom/tools.h");
    extras.cancel.check();
    return run(tool, surface, fields, extras);
  }
  template <SettingCommand Setting>
  Evaluation operator()(const Setting&) const {
    return {};
  }
};

}  // namespace

Evaluation evaluate(const Command& resolved, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  return std::visit(Run{surface, fields, extras}, resolved);
}

namespace {

constexpr std::size_t max_checked_samples = 16;  // maximum number of samples of a stroke to check

double mean_edge(std::uint32_t triangle, const Mesh& mesh) {
  const glm::uvec3 corners = mesh.triangles[triangle];
  double sum = 0;
  for (int k = 0; k < 3; ++k)
    sum += glm::distance(glm::dvec3(mesh.positions[corners[k]]), glm::dvec3(mesh.positions[corners[(k + 1) % 3]]));
  return sum / 3;
}

std::uint32_t triangle_at(const StrokeSample& sample, const Surface& surface) {
  if (const auto* on_skin = std::get_if<SurfaceSample>(&sample.position)) return on_skin->triangle;
  return surface.nearest(surface.mesh().to_internal(std::get<PositionSample>(sample.position).position)).triangle;
}

/// Returns the largest mean edge length of the triangles where the stroke passes, sizes.
double longest_edges(const Stroke& stroke, const Surface& surface) {
  const std::size_t step = stroke.samples.size() / max_checked_samples + 1;
  double longest = 0;
  for (std::size_t i = 0; i < stroke.samples.size(); i += step)
    longest = std::max(longest, mean_edge(triangle_at(stroke.samples[i], surface), surface.mesh()));
  return longest;
}

/// Warns of eyes whose ball does not touch the skin.
std::vector<std::string> warnings_of_eyes(const SetEyes& command, const Surface& surface) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < command.eyes.size(); ++i) {
    const Eye& eye = command.eyes[i];
    const glm::dvec3 centre = surface.mesh().to_internal(eye.position);
    const double away = glm::distance(centre, surface.position(surface.nearest(centre)));
    if (away <= eye.radius) continue;
    char text[160];
    std::snprintf(text, sizeof text,
                  "eye %zu does not touch the skin: its centre is %.3g sizes away from it, and its radius is %.3g",
                  i + 1, away, eye.radius);
    warnings.emplace_back(text);
  }
  return warnings;
}

}  // namespace

std::vector<std::string> warnings_of(const Command& resolved, const Surface& surface) {
  if (const auto* eyes = std::get_if<SetEyes>(&resolved)) return warnings_of_eyes(*eyes, surface);
  const Stroke* stroke = stroke_of(resolved);
  const Brush* brush = brush_of(resolved);
  if (stroke == nullptr || stroke->samples.empty() || brush == nullptr) return {};
  const double radius = BrushStroke(*stroke, *brush, surface).radius();
  const double edges = longest_edges(*stroke, surface);
  if (radius >= edges) return {};
  char text[160];
  std::snprintf(text, sizeof text,
                "the brush is finer than the mesh: its radius is %.3g sizes, and edges are %.3g long where it passes; "
                "it touches few vertices or none",
                radius, edges);
  return {text};
}

std::vector<std::string> warnings_of_no_change(const Command& resolved) {
  if (brush_of(resolved) == nullptr) return {};
  const Stroke* stroke = stroke_of(resolved);
  if (stroke == nullptr)
    return {"it changed nothing: no vertex that the mask lets change is in reach, or all are so already"};
  if (!stroke->id.empty()) return {};
  return {
      "it changed nothing: no vertex that the mask lets change lies under the brush, or all are so already; `pick` "
      "finds positions on the surface"};
}

}  // namespace pelage
