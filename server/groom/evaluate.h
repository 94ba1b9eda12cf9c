// Evaluates a command to a change of the fields. Pure: the scene does not change.
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

/// The result of a tool: the change, the number of vertices at which a value was clamped to its limit, and warnings.
struct Evaluation {
  FieldDelta delta;
  std::size_t clamped = 0;
  std::vector<std::string> warnings = {};
};

/// Inputs that some tools read in addition to the surface and its fields.
struct ToolExtras {
  Coat coat;                            // how strands lean; read by trim and by brushes that reach for fur
  const FieldSet* baseline = nullptr;   // required by erase (the fields to restore) and retarget (the fields to take)
  const Surface* source = nullptr;      // required by retarget: the surface of `baseline`
  const MapPicture* picture = nullptr;  // required by map, and by mask with a picture: the picture that they name
  const MapPicture* alpha = nullptr;    // required by a brush with an alpha picture
  Cancel cancel = {};                   // polled between dabs, passes and symmetry images
};

/// The fur that may be visible under the pixels of a stroke.
struct VisibleFur {
  const FieldSet& fields;
  const std::vector<NamedCoat>& coats;  // muted ones are invisible
  double& visits;                       // visits of vertices by the request's commands so far; each pixel adds to it
  const Cancel& cancel;                 // polled between pixels
};

/// Replaces pixel samples of the command's stroke by positions: on the fur, if the brush reaches for fur and `fur` is
/// given, else on the triangle that the pixel's ray hits. Misses are dropped, and the log replays without a camera.
/// Fills in the brush's reach if the command does not state it. Checks what can only be checked against the surface:
/// triangle numbers (pointer "/stroke/samples/K/triangle"), vertex numbers, and coordinates beyond 1e6 sizes. The view
/// stays, for the front-facing test. Refuses (invalid, "/stroke/samples") pixels that visit more than
/// limits::evaluation_visits vertices; fails (unavailable) if cancelled.
Result<Command> resolve(const Command& command, const Surface& surface, const VisibleFur* fur = nullptr);

/// Evaluates a resolved tool command; commands that change settings give an empty delta. Deterministic at any thread
/// count. Throws Cancelled.
Evaluation evaluate(const Command& resolved, const Surface& surface, const FieldSet& fields,
                    const ToolExtras& extras = {});

/// Removes what the command's edit layer adds, weighted by the brush at each vertex; exactly all of it at weight 1.
Evaluation erase_edit_layer(const Erase& resolved, const Surface& surface, const FieldSet& fields,
                            const std::vector<EditLayer>& layers, const ToolExtras& extras = {});

/// Returns the symmetry that applies to a command: its brush's, or the scene's.
const Symmetry& symmetry_of(const Command& command, const Symmetry& scene);

/// Returns the command itself and its symmetry images. Samples on triangles move to the surface positions nearest to
/// their images, so that a roughly symmetric model suffices. Commands without positions have no images.
std::vector<Command> symmetry_images(const Command& resolved, const Symmetry& scene, const Surface& surface);

/// Returns the command for another model. Positions follow the alignment and keep their distance from the surface;
/// positions on triangles move to the nearest surface positions. Directions follow the scale of the boxes; lengths in
/// the model's unit follow its size. Strokes lose their views, as in symmetry images. A position shared by both models
/// stays the same to the bit. Refuses (invalid, with a pointer) commands that name vertices or revisions of the model.
Result<Command> transferred_command(const Command& resolved, const Surface& from, const Surface& to,
                                    Alignment how = Alignment::box);

/// A camera placed in internal coordinates, for pixel rays and the front-facing test. `automatic` cameras are placed so
/// that they frame the mesh's box.
struct PlacedCamera {
  glm::dvec3 position, right, up, forward;  // internal coordinates; the directions are unit vectors
  double tan_half_fov;                      // tangent of half the vertical field of view
};
PlacedCamera place_camera(const Camera& camera, double aspect, const Mesh& mesh);
/// Returns the direction of the ray through a pixel of a width x height frame; not normalized.
glm::dvec3 pixel_ray(const PlacedCamera& camera, glm::dvec2 pixel, int width, int height);

// Warnings about commands that are valid but probably not what the user meant.

/// Returns warnings in plain words for the answer: about a brush that is finer than the mesh under its stroke, so that
/// it touches few or no vertices, and about an eye that does not touch the skin. The command is resolved.
std::vector<std::string> warnings_of(const Command& resolved, const Surface& surface);

/// Returns warnings for a command that changed nothing. Only tools with a brush give one; parts of a stroke that
/// arrives in parts do not.
std::vector<std::string> warnings_of_no_change(const Command& resolved);

}  // namespace pelage
