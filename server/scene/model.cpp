#include "server/scene/model.h"

#include "server/surface/prepare.h"

namespace pelage {

namespace {

Result<PatchMap> lay(const Mesh& mesh, FurPatches how) {
  if (how == FurPatches::own_uvs) {
    Result<PatchMap> own = own_uv_patches(mesh);
    if (own) return own;
    return failure(own.status().code, own.status().message, "/fur_patches", "overlapping | hard");
  }
  PatchMap patches = lay_patches(mesh);
  return how == FurPatches::hard ? hard_pieces(patches) : std::move(patches);
}

}  // namespace

Result<std::shared_ptr<const SceneModel>> build_model(const RawModel& raw, const StoredModel& how, std::uint64_t id) {
  Result<Mesh> mesh = prepare(raw, how.up, how.front, how.source_is_32_bit);
  if (!mesh) return mesh.status();
  Result<PatchMap> patches = lay(*mesh, how.fur_patches);
  if (!patches) return patches.status();
  for (const ChosenTriangles& chosen : how.subdivisions) {
    Result<SubdividedSurface> finer = subdivide(*mesh, *patches, chosen);
    if (!finer) return finer.status();
    mesh = std::move(finer->mesh), patches = std::move(finer->patches);
  }
  return std::shared_ptr<const SceneModel>(
      new SceneModel{Surface(std::move(*mesh)), std::move(*patches), id, how.name, how.fur_patches, how.subdivisions});
}

}  // namespace pelage
