#include "server/batch/job_scene.h"

#include <filesystem>
#include <span>

#include "server/batch/input_file.h"
#include "server/export/export_file.h"
#include "server/import/import.h"

namespace pelage {

namespace {

constexpr const char* scene_extension = ".pelage";

Result<std::shared_ptr<Scene>> load_model(SceneStore& store, const RenderJob& job, const std::string& path,
                                          const std::string& bytes) {
  const Result<ModelFormat> format = format_of_file(path, "/scene");
  if (!format) return format.status();
  ImportOptions options = job.options.value_or(ImportOptions());
  options.format = *format;
  NewScene empty;  // a placeholder until the model is loaded
  empty.name = "job", empty.model = {.shape = Builtin::plane, .triangles = 2};
  auto scene = store.create(empty);
  if (!scene) return scene;
  const auto loaded = store.load_model(**scene, options, std::as_bytes(std::span(bytes)));
  if (!loaded) return in_file(path, loaded.status());
  return scene;
}

Result<std::shared_ptr<Scene>> open_scene(SceneStore& store, const RenderJob& job, const std::string& folder) {
  if (job.builtin) {
    NewScene request;
    request.name = "job", request.model = *job.builtin;
    return store.create(request);
  }
  if (job.scene.find("://") != std::string::npos)
    return with_next(failure(Code::invalid, "pelage-render reads files alone.", "/scene", "a file"),
                     "submit the job with `pelage farm submit`, or get the scene with `pelage farm pack`");
  const std::filesystem::path asked(job.scene);
  const std::string path = (asked.is_absolute() ? asked : std::filesystem::path(folder) / asked).string();
  const Result<std::string> bytes = read_file(path);
  if (!bytes) return bytes.status();
  const bool saved = asked.extension() == scene_extension;
  if (saved && job.options)
    return failure(Code::invalid, "Options are of a model's file; a scene has its model.", "/options",
                   "without .pelage");
  if (!saved) return load_model(store, job, path, *bytes);
  auto opened = open_saved(store, *bytes, {});
  return opened ? std::move(opened) : in_file(path, opened.status());
}

}  // namespace

Result<JobScene> JobScene::open(const RenderJob& job, const std::string& folder) {
  Result<TemporaryFolder> data = TemporaryFolder::make();
  if (!data) return data.status();
  auto store = SceneStore::open(data->file("data"), program_folder() + "/pelage-import");
  if (!store) return store.status();
  auto scene = open_scene(**store, job, folder);
  if (!scene) return scene.status();
  for (std::size_t k = 0; k < job.commands.size(); ++k) {
    const auto answer = (*store)->execute(**scene, {job.commands[k]});
    if (answer) continue;
    Status status = answer.status();
    status.pointer = "/commands/" + std::to_string(k) + status.pointer;
    return status;
  }
  return JobScene(std::move(data).value(), std::move(store).value(), std::move(scene).value());
}

}  // namespace pelage
