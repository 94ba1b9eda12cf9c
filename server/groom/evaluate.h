// From a command to a change of the fields. Pure: nothing of the scene changes here.
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/command.h"
#include "server/fields/field_set.h"
#include "server/groom/cancel.h"
#include "server/import/map_picture.h"
#include "server/surface/surface.h"

namespace pelage {

/// What a tool did: the change, the number of vertices at which a value was clamped to its limit, and warnings.
struct Evaluation {
  FieldDelta delta;
  std::size_t clamped = 0;
  std::vector<std::string> warnings = {};
};

/// What some tools read beside the surface and its fields.
struct ToolExtras {
  Coat coat;                            // how strands lean: trim, and brushes that reach fur
  const FieldSet* baseline = nullptr;   // erase: what it goes back to, retarget: what it takes; required
  const Surface* source = nullptr;      // retarget: the surface of `baseline`; required
  const MapPicture* picture = nullptr;  // map, and a mask by a picture: the one that they name; required
  const MapPicture* alpha = nullptr;    // of a brush that has one: required
  Cancel cancel = {};                   // asked between dabs, passes and images
};

/// The fur that pixels of a stroke may show.
struct SeenFur {
  const FieldSet& fields;
  const std::vector<NamedCoat>& coats;  // muted ones show nothing
  double& visits;                       // of vertices, by the commands of a request so far: each pixel adds to it
  const Cancel& cancel;                 // asked between pixels
};

/// Replaces pixel samples of the command's stroke by what they show: positions on the fur, if the brush reaches fur and
/// some is given, else the triangles that they hit (misses are dropped; so the log replays without a camera). Fills in
/// what the brush reaches, where the command does not say it. Checks what can only be checked against the surface:
/// triangle and vertex numbers (pointer "/stroke/samples/K/triangle") and coordinates beyond 1e6 sizes. The view stays,
/// for the facing test. Refused (invalid, "/stroke/samples") where pixels look at more than limits::evaluation_visits
/// vertices; ends early (unavailable) once nobody waits.
Result<Command> resolve(const Command& command, const Surface& surface, const SeenFur* fur = nullptr);

/// Evaluates a resolved tool command; scene settings give an empty delta. Deterministic at any thread count. Throws
/// Cancelled once nobody waits.
Evaluation evaluate(const Command& resolved, const Surface& surface, const FieldSet& fields,
                    const ToolExtras& extras = {});

/// Takes away what the command's edit layer adds, by the brush's weight at each vertex; exactly all of it where that
/// is 1.
Evaluation erase_edit_layer(const Erase& resolved, const Surface& surface, const FieldSet& fields,
                            const std::vector<EditLayer>& layers, const ToolExtras& extras = {});

/// Returns the symmetry that a command works under: its brush's, or the scene's.
const Symmetry& symmetry_of(const Command& command, const Symmetry& scene);

/// The command itself, and its images under its symmetry. Samples on triangles become the nearest places on the surface
/// to their mirrored points, so that a roughly symmetric model will do. Commands without places have no images.
std::vector<Command> images_of(const Command& resolved, const Symmetry& scene, const Surface& surface);

/// Returns the command for another model. Positions move as the alignment takes them, and keep their
/// distance from the surface; positions on triangles become the nearest ones. Directions follow the boxes, and lengths
/// in the model's unit its size. Strokes lose their views, as images of a symmetry do. A position that both models have
/// stays the same to the bit. Refused (invalid, with a pointer): what names vertices or revisions of the model.
Result<Command> carried_command(const Command& resolved, const Surface& from, const Surface& to,
                                Alignment how = Alignment::box);

/// The view's camera as rays and a facing test. `automatic` cameras are placed around the mesh's box.
struct PlacedCamera {
  glm::dvec3 position, right, up, forward;  // internal coordinates; forward is where it looks, unit
  double tan_half_fov;                      // vertical
};
PlacedCamera place_camera(const Camera& camera, double aspect, const Mesh& mesh);
/// Direction of the ray through a pixel of a width x height frame.
glm::dvec3 pixel_ray(const PlacedCamera& camera, glm::dvec2 pixel, int width, int height);

// Warnings about commands that do what was asked, but hardly what was meant.

/// In plain words, for the answer: a brush that is finer than the mesh where its stroke passes, so that it touches few
/// vertices or none; an eye that stands off the skin or lies deep in it. The command is resolved.
std::vector<std::string> warnings_of(const Command& resolved, const Surface& surface);

/// Returns warnings for a command that changed nothing: for tools with a brush, but not for parts of a stroke that
/// continues.
std::vector<std::string> warnings_of_no_change(const Command& resolved);

}  // namespace pelage
