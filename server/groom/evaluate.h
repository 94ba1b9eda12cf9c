// From a command to a change of the fields. Pure: nothing of the scene changes here.
#pragma once

#include "protocol/base/status.h"
#include "protocol/commands/command.h"
#include "server/fields/field_set.h"
#include "server/surface/map_picture.h"
#include "server/surface/surface.h"

namespace pelage {

/// What a tool did: the change, and at how many vertices a value was held at its limit.
struct Evaluation {
  FieldDelta delta;
  std::size_t clamped = 0;
};

/// Replaces pixel samples of the command's stroke by the triangles that they hit (misses are dropped; so the log
/// replays without a camera), and checks what can only be checked against the surface: triangle and vertex numbers
/// (pointer "/stroke/samples/K/triangle") and coordinates beyond 1e6 sizes. The view stays, for the facing test.
Result<Command> resolve(const Command& command, const Surface& surface);

/// What some tools read beside the surface and its fields.
struct ToolExtras {
  Coat coat;                      // trim: how strands lean
  const FieldSet* rest = nullptr;  // erase: what it goes back to; required
  const MapPicture* picture = nullptr;  // map, and a mask by a picture: the one that they name; required
};

/// Evaluates a resolved tool command; scene settings give an empty delta. Deterministic at any thread count.
Evaluation evaluate(const Command& resolved, const Surface& surface, const FieldSet& fields,
                    const ToolExtras& extras = {});

/// The command itself, and its images under the symmetry. Samples on triangles become the nearest places on the surface
/// to their mirrored points, so that a roughly symmetric model will do. Commands without places have no images.
std::vector<Command> images_of(const Command& resolved, const Symmetry& symmetry, const Surface& surface);

/// The view's camera as rays and a facing test. `automatic` cameras are placed around the mesh's box.
struct PlacedCamera {
  glm::dvec3 eye, right, up, forward;  // internal coordinates; forward is where it looks, unit
  double tan_half_fov;                 // vertical
};
PlacedCamera place_camera(const Camera& camera, double aspect, const Mesh& mesh);
/// Direction of the ray through a pixel of a width x height frame.
glm::dvec3 pixel_ray(const PlacedCamera& camera, glm::dvec2 pixel, int width, int height);

}  // namespace pelage
