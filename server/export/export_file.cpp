#include "server/export/export_file.h"

#include <memory>

#include "server/export/cards.h"
#include "server/export/mesh_fields.h"
#include "server/export/shells.h"
#include "server/export/strand_files.h"

namespace pelage {

std::uint64_t size_of(const std::function<bool(const Sink&)>& write) {
  std::uint64_t bytes = 0;
  write([&](std::string_view piece) {
    bytes += piece.size();
    return true;
  });
  return bytes;
}

namespace {

/// Files of strands, which are made as they are sent.
ExportFile strand_file(const std::shared_ptr<const ExportedStrands>& strands, const ExportRequest& request,
                       ExportFile file) {
  file.about.strands = strands->count(), file.about.points = strands->points();
  if (request.format == ExportFormat::hair) {
    file.content_type = "application/octet-stream", file.ending = ".hair";
    file.write = [strands](const Sink& sink) { return write_hair(*strands, sink); };
    return file;
  }
  file.content_type = "model/vnd.usda", file.ending = ".usda";
  file.write = [strands, about = file.about, guides = request.every > 1 && !request.widen](const Sink& sink) {
    return write_usda(*strands, about, guides, sink);
  };
  return file;
}

ExportFile glb_file(std::string glb, std::uint64_t triangles, ExportFile file) {
  file.content_type = "model/gltf-binary", file.ending = ".glb";
  file.about.triangles = triangles;
  file.write = [whole = std::make_shared<const std::string>(std::move(glb))](const Sink& sink) { return sink(*whole); };
  return file;
}

Result<ExportFile> file_of(const SceneView& scene, ExportedStrands gathered, const ExportRequest& request) {
  ExportFile file;
  file.about.revision = scene.revision, file.about.format = request.format;
  if (request.format == ExportFormat::shells) {
    Result<BakedShells> baked = bake_shells(scene, gathered, request);
    if (!baked) return baked.status();
    return glb_file(std::move(baked->glb), baked->triangles, std::move(file));
  }
  if (request.format == ExportFormat::cards) {
    Result<CardFile> cards = bake_cards(scene, gathered, request);
    if (!cards) return cards.status();
    file.about.cards = cards->cards;
    return glb_file(std::move(cards->glb), cards->triangles, std::move(file));
  }
  if (request.format == ExportFormat::fields) {
    Result<MeshFile> mesh = export_mesh(scene, gathered);
    if (!mesh) return mesh.status();
    return glb_file(std::move(mesh->glb), mesh->triangles, std::move(file));
  }
  return strand_file(std::make_shared<const ExportedStrands>(std::move(gathered)), request, std::move(file));
}

}  // namespace

Result<ExportFile> export_scene(const SceneCopy& scene, const ExportRequest& request, const Cancel& cancel) try {
  Result<ExportedStrands> strands = gather_strands(scene.view(), request, cancel);
  if (!strands) return strands.status();
  Result<ExportFile> file = file_of(scene.view(), std::move(*strands), request);
  if (!file) return file;
  file->about.bytes = size_of([&](const Sink& sink) {
    return file->write([&](std::string_view piece) { return cancel.check(), sink(piece); });
  });
  return file;
} catch (const Cancelled&) {
  return nobody_waits();
}

}  // namespace pelage
