#include "server/export/export_file.h"

#include <algorithm>
#include <memory>
#include <numeric>

#include "base/parallel.h"
#include "server/export/cards.h"
#include "server/export/mesh_fields.h"
#include "server/export/shells.h"
#include "server/export/strand_files.h"
#include "server/fields/coats.h"

namespace pelage {

bool ExportFile::write(const Sink& sink) const {
  return std::all_of(parts.begin(), parts.end(), [&](const FilePart& part) { return part(sink); });
}

std::uint64_t size_of(const std::vector<FilePart>& parts, const Cancel& cancel) {
  std::vector<std::uint64_t> bytes(parts.size());
  for_each_in_parallel(static_cast<std::uint32_t>(parts.size()), [&](std::uint32_t i) {
    parts[i]([&](std::string_view chunk) {
      cancel.check();
      bytes[i] += chunk.size();
      return true;
    });
  });
  return std::accumulate(bytes.begin(), bytes.end(), std::uint64_t{0});
}

namespace {

/// Makes a file of strands. Its bytes are generated while it is sent.
ExportFile strand_file(const std::shared_ptr<const ExportedStrands>& strands, const ExportRequest& request,
                       ExportFile file) {
  file.about.strands = strands->count(), file.about.points = strands->points();
  if (request.format == ExportFormat::hair) {
    file.content_type = "application/octet-stream", file.ending = ".hair";
    file.parts = {[strands](const Sink& sink) { return write_hair(*strands, sink); }};
    return file;
  }
  file.content_type = "model/vnd.usda", file.ending = ".usda";
  file.parts = usda_parts(strands, {file.about.revision, request.every > 1 && !request.widen, request.basis});
  return file;
}

ExportFile glb_file(std::string glb, std::uint64_t triangles, ExportFile file) {
  file.content_type = "model/gltf-binary", file.ending = ".glb";
  file.about.triangles = triangles;
  file.parts = {
      [whole = std::make_shared<const std::string>(std::move(glb))](const Sink& sink) { return sink(*whole); }};
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

/// Returns the settings with all coats muted except those that the file is to hold.
Result<SceneSettings> with_asked_coats(SceneSettings settings, const ExportRequest& request) {
  std::vector<NamedCoat>& coats = settings.coats;
  const auto seen = coats.size() - static_cast<std::size_t>(std::ranges::count(coats, true, &NamedCoat::muted));
  if (request.coat.empty()) {
    if (seen == 1 || request.format != ExportFormat::fields) return settings;
    return failure(Code::invalid, "The file holds the fields of one coat.", "/coat", "the name of a coat");
  }
  if (!find_coat(coats, request.coat)) return failure(Code::invalid, "The scene has no coat of this name.", "/coat");
  for (NamedCoat& coat : coats) coat.muted = coat.name != request.coat;
  return settings;
}

}  // namespace

Result<ExportFile> export_scene(const SceneSnapshot& scene, const ExportRequest& request, const Cancel& cancel) try {
  const SceneView whole = scene.view();
  const Result<SceneSettings> settings = with_asked_coats(whole.settings, request);
  if (!settings) return settings.status();
  const FieldSet fields = whole.fields.of_coat(first_unmuted(settings->coats).id);
  const SceneView view{whole.model, fields, *settings, whole.revision, whole.skin_texture, whole.copy_id, whole.swing};
  Result<ExportedStrands> strands = gather_strands(view, request, cancel);
  if (!strands) return strands.status();
  Result<ExportFile> file = file_of(view, std::move(*strands), request);
  if (!file) return file;
  file->about.bytes = size_of(file->parts, cancel);
  return file;
} catch (const Cancelled&) {
  return nobody_waits();
}

Result<ExportFile> export_file(const SceneStore& store, const Scene& scene, const ExportRequest& request,
                               const Cancel& cancel) {
  if (request.format == ExportFormat::pelage) return export_saved(store, scene, cancel);
  return export_scene(*scene.snapshot(), request, cancel);
}

}  // namespace pelage
