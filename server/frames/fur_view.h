// A scene in the form that the renderer takes: curves, bare skin, model, fields and frame.
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

/// Makes curves in internal coordinates; each guide knows the skin nearest to its root and the fur that stands there
/// now.
FurCurves make_curves(const CurveGroup& group, const SceneView& scene);

// Bare skin as the renderer wants it.

/// Makes skin regions in internal coordinates, in the same order.
std::vector<FurSkinRegion> make_skin(const std::vector<SkinRegion>& regions, const Mesh& mesh);

// The renderer's view of a scene: the only place that fills a FurModel.

/// Brings the renderer's copy of the scene up to date: uploads everything for a model that the renderer does not have
/// in these colours, else the dirty vertex ranges. If `moved` is not null, the fur leans as it says, and `dirty` covers
/// the changes of the scene and of `moved`. With `shells`, also uploads what shells need.
UploadCount sync_scene(Renderer& renderer, const SceneView& scene, const std::vector<VertexRange>& dirty,
                       const MovedFur* moved = nullptr, bool shells = false);

/// The coats of a scene that are seen, in its order.
std::vector<NamedCoat> seen_coats(const SceneSettings& settings);

/// Returns the id by which the renderer caches the model in its present colours, without what is hidden.
std::uint64_t copy_id(const SceneView& scene);

/// What is drawn of a model: its triangles as patches have them, with the place of each corner on the sample tile, the
/// patch's share there and the model's own look.
struct FurPieces {
  std::vector<glm::uvec3> triangles;
  std::vector<std::array<FurCorner, 3>> corners;
};
/// With `has_picture`, corners carry the model's texture coordinates and name image 0 in place of the model's own look.
/// `hidden`, of each triangle of the mesh, leaves out its pieces; empty for none.
FurPieces make_pieces(const Mesh& mesh, const PatchMap& patches, bool has_picture = false,
                      const std::vector<bool>& hidden = {});

/// What a FurModel points into beside the scene's mesh and picture.
struct ModelArrays {
  FurPieces pieces;
  std::vector<ImageView> images;
};
ModelArrays make_arrays(const SceneView& scene);

/// Views of the scene and of the arrays.
FurModel make_model(const SceneView& scene, const ModelArrays& arrays);
/// The fields of each coat that is seen: views of the scene and of the others; the fur leans as `moved` says, where it
/// is not null.
std::vector<FurFields> make_fields(const SceneView& scene, std::span<const FurSkinRegion> skin,
                                   std::span<const DirtyRange> dirty, const MovedFur* moved = nullptr);

/// The skin and the length of its fur, of the first coat that is seen, which cost and error follow from: views of the
/// scene.
FurredSkin furred_skin(const SceneView& scene);

/// A frame in internal coordinates, with the scene's coats, look and lights.
FurFrame make_frame(const SceneView& scene, const FrameRequest& request);

}  // namespace pelage
