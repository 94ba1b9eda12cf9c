// Converts a scene to the renderer's input: curves, bare skin, model, fields and frame.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "protocol/commands/creature.h"
#include "protocol/commands/frame.h"
#include "renderer/frame/renderer.h"
#include "renderer/input/fur_scene.h"
#include "renderer/quality/view_features.h"
#include "server/frames/moved_fur.h"
#include "server/scene/scene.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Makes curves in internal coordinates; each guide has the normal of the skin nearest to its root. Curves on hidden
/// skin are left out.
FurCurves make_curves(const CurveGroup& group, const SceneView& scene);

// Bare skin.

/// Makes skin regions in internal coordinates, in the same order.
std::vector<FurSkinRegion> make_skin(const std::vector<SkinRegion>& regions, const Mesh& mesh);

// Models and fields. This is the only code that fills a FurModel.

/// Updates the renderer's copy of the scene. Uploads everything if the renderer does not have the model with its
/// present colours and hidden triangles, else the dirty vertex ranges. If `moved` is not null, fur leans as it says,
/// and `dirty` covers the changes of the scene and of `moved`. With `shells`, also uploads the data that shells need.
UploadCount sync_scene(Renderer& renderer, const SceneView& scene, const std::vector<VertexRange>& dirty,
                       const MovedFur* moved = nullptr, bool shells = false);

/// Returns the visible coats of a scene, in its order.
std::vector<NamedCoat> visible_coats(const SceneSettings& settings);

/// Returns the key by which the renderer caches the model. It depends on the skin texture and on the hidden triangles.
std::uint64_t copy_id(const SceneView& scene);

/// The triangles to draw, one for each patch that covers a triangle of the model. Each corner has its position on the
/// sample tile, the patch's weight there and the model's own appearance.
struct FurTriangles {
  std::vector<glm::uvec3> triangles;
  std::vector<std::array<FurCorner, 3>> corners;
};
/// Makes the triangles to draw. With `has_picture`, corners have the model's texture coordinates and image 0 in place
/// of the model's own appearance. `hidden`, one for each triangle of the mesh, leaves out triangles; empty for none.
FurTriangles make_fur_triangles(const Mesh& mesh, const PatchMap& patches, bool has_picture = false,
                                const std::vector<bool>& hidden = {});

/// Data that a FurModel refers to, in addition to the scene's mesh and picture.
struct ModelArrays {
  FurTriangles patch_triangles;
  std::vector<ImageView> images;
};
ModelArrays make_arrays(const SceneView& scene);

/// Returns a model that refers to the scene and to the arrays.
FurModel make_model(const SceneView& scene, const ModelArrays& arrays);
/// Returns the fields of each visible coat; they refer to the arguments. If `moved` is not null, fur leans as it says.
std::vector<FurFields> make_fields(const SceneView& scene, std::span<const FurSkinRegion> skin,
                                   std::span<const DirtyRange> dirty, const MovedFur* moved = nullptr);

/// Returns the skin and the lengths of the first visible coat's fur, from which cost and error are estimated. It refers
/// to the scene.
FurredSkin furred_skin(const SceneView& scene);

/// Returns a frame in internal coordinates, with the scene's coats, look, lights, eyes and curves.
FurFrame make_frame(const SceneView& scene, const FrameRequest& request);

}  // namespace pelage
