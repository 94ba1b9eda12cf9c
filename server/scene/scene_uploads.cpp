// Imports uploaded files into scenes: models, environment maps, skin textures, guide curves and maps.
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/limits.h"
#include "renderer/picture_files/picture_files.h"
#include "server/import/import.h"
#include "server/scene/follow_guides.h"
#include "server/scene/imported_model.h"
#include "server/scene/map_pictures.h"
#include "server/scene/scene_store_impl.h"

namespace pelage {

namespace {

/// Returns the name of the scene that keeps the old state when this one gets a new version of its model.
std::string name_before(const SceneSummary& scene) {
  const std::string ending = " before " + std::to_string(scene.revision + 1);
  return scene.name.size() + ending.size() <= limits::name_bytes ? scene.name + ending : scene.name;
}

}  // namespace

Result<SceneSummary> SceneStore::load_model(Scene& scene, const ImportOptions& options,
                                            std::span<const std::byte> bytes, const ExecuteOptions& execute) try {
  Result<ImportedModel> model = import_for_scene(impl_->worker, ++impl_->last_model, options, bytes, execute.cancel);
  if (!model) return model.status();
  return scene.replace_model(model->model, options.fur, std::move(model->stored), options.ground, execute);
} catch (const Cancelled&) {
  return nobody_waits();
}

Result<SceneSummary> SceneStore::load_version(Scene& scene, const ImportOptions& options,
                                              std::span<const std::byte> bytes, ExecuteOptions execute) try {
  const std::vector<ChosenTriangles> groom_before_log(1);  // StoredModel::subdivisions
  const Result<ImportedModel> model =
      import_for_scene(impl_->worker, ++impl_->last_model, with_axes_of(*scene.model(), options), bytes, execute.cancel,
                       groom_before_log);
  if (!model) return model.status();
  const bool any_revision = !execute.if_match;
  for (int tries = 3;; --tries) {
    const SceneSummary now = scene.summary();
    if (any_revision) execute.if_match = now.revision;
    const auto before = branch(scene, {name_before(now), now.revision});
    if (!before) return before.status();
    Result<SceneSummary> summary = scene.transfer_groom_to(model->model, model->stored, execute);
    if (summary) summary->transfer->before = (*before)->id();
    if (summary) return summary;
    if (Status removed = remove((*before)->id()); !removed.ok()) return removed;
    const bool changed_meanwhile = any_revision && summary.status().code == Code::precondition;
    if (!changed_meanwhile || tries == 0) return summary;
  }
} catch (const Cancelled&) {
  return nobody_waits();
}

Result<CommandAnswer> SceneStore::load_environment(Scene& scene, EnvironmentUpload how,
                                                   std::span<const std::byte> bytes, const ExecuteOptions& execute) {
  Result<glm::mat3> to_linear = glm::mat3(1);
  if (!how.colour_space.empty()) to_linear = picture_files().linear_from_space(how.colour_space);
  if (!to_linear) return to_linear.status();
  Result<SphericalHarmonics> harmonics = import_environment(impl_->worker, bytes, cancellable_limits(execute.cancel));
  if (!harmonics) return harmonics.status();
  for (glm::dvec3& one : *harmonics) one = glm::dmat3(*to_linear) * one;  // valid: they are linear in the light
  how.environment.harmonics = *harmonics;
  return scene.execute({SetEnvironment{how.environment}}, execute);
}

Result<CommandAnswer> SceneStore::load_skin_texture(Scene& scene, std::span<const std::byte> bytes,
                                                    const ExecuteOptions& execute) {
  const Result<RawImage> picture = import_picture(impl_->worker, bytes, cancellable_limits(execute.cancel));
  if (!picture) return picture.status();
  return store_skin_texture(scene, *picture, execute);
}

Result<CommandAnswer> SceneStore::load_guides(Scene& scene, const GuideUpload& upload, std::span<const std::byte> bytes,
                                              const ExecuteOptions& execute) {
  const Result<GuideFile> file = import_guides(impl_->worker, upload.format, bytes, cancellable_limits(execute.cancel));
  if (!file) return file.status();
  return follow_guides(scene, upload, *file, execute);
}

Result<CommandAnswer> SceneStore::store_skin_texture(Scene& scene, const RawImage& picture,
                                                     const ExecuteOptions& execute) {
  const std::string bytes = encode_raw_image(picture);
  const std::string name = name_of_picture(bytes);
  if (Status kept = impl_->journal->add_picture(name, bytes); !kept.ok()) return kept;
  return scene.execute({SetSkinTexture{name}}, execute);
}

Result<PictureAnswer> SceneStore::store_picture(std::span<const std::byte> bytes, const Cancel& cancel) {
  const Result<MapPicture> picture = import_map(impl_->worker, bytes, cancellable_limits(cancel));
  if (!picture) return picture.status();
  const std::string kept = encode_map_picture(*picture);
  PictureAnswer answer{name_of_picture(kept), picture->width, picture->height, picture->bits, picture->scale};
  if (Status written = impl_->journal->add_picture(answer.picture, kept); !written.ok()) return written;
  return answer;
}

Result<CommandAnswer> SceneStore::load_map(Scene& scene, const MapUpload& upload, std::span<const std::byte> bytes,
                                           const ExecuteOptions& execute) {
  const Result<PictureAnswer> picture = store_picture(bytes, execute.cancel);
  if (!picture) return picture.status();
  ApplyMap command{picture->picture, upload.field, upload.encoding, 1, upload.units, upload.strength};
  command.tile = upload.tile;
  if (!upload.coat.empty()) command.coats = {upload.coat};
  command.scale = upload.scale.value_or(picture->scale.value_or(1));
  if (!upload.scale && picture->scale) command.units = Units::relative;  // a scale stated by a file is in sizes
  return scene.execute({command}, execute);
}

}  // namespace pelage
