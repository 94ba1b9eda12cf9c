#include "server/import_worker/job.h"

#include <array>
#include <utility>

#include "server/guide_files/read_guides.h"
#include "server/import/import.h"
#include "server/import_worker/parse.h"
#include "server/import_worker/read_picture.h"
#include "server/import_worker/read_saved_scene.h"

namespace pelage {

namespace {

template <ModelFormat format, bool pictures>
Result<std::string> read_model(std::string&& bytes, const std::string& pose) {
  const Result<RawModel> model = parse_model(format, std::move(bytes), pose, pictures);
  if (!model.ok()) return model.status();
  return encode_raw_model(*model);
}

Result<std::string> read_light(std::string&& bytes, const std::string&) {
  const Result<SphericalHarmonics> harmonics = read_environment(bytes);
  if (!harmonics.ok()) return harmonics.status();
  return encode_harmonics(*harmonics);
}

Result<std::string> read_data(std::string&& bytes, const std::string&) {
  const Result<MapPicture> picture = read_map_picture(bytes);
  if (!picture.ok()) return picture.status();
  return encode_map_picture(*picture);
}

Result<std::string> read_backplate(std::string&& bytes, const std::string&) {
  const Result<RawImage> image = read_skin_texture(bytes);
  if (!image.ok()) return image.status();
  return encode_raw_image(*image);
}

template <GuideFormat format>
Result<std::string> read_curves(std::string&& bytes, const std::string&) {
  const Result<GuideFile> file = read_guides(format, bytes);
  if (!file.ok()) return file.status();
  return encode_guides(*file);
}

Result<std::string> read_saved(std::string&& bytes, const std::string&) { return read_saved_scene(std::move(bytes)); }

bool never(std::string_view) { return false; }
bool always(std::string_view) { return true; }

/// A glTF lists its pictures under this name, which it may spell with escapes of letters.
bool names_images(std::string_view bytes) {
  return bytes.find("\"images\"") != std::string_view::npos || bytes.find("\\u00") != std::string_view::npos;
}

/// Indexed by ModelFormat. OBJ, PLY, STL, OFF and 3DS have pictures only in a zip archive.
template <bool pictures>
constexpr std::array<Job, worker_format_names.size()> models = {
    {{read_model<ModelFormat::obj, pictures>, never},
     {read_model<ModelFormat::ply, pictures>, never},
     {read_model<ModelFormat::stl, pictures>, never},
     {read_model<ModelFormat::off, pictures>, never},
     {read_model<ModelFormat::gltf, pictures>, pictures ? names_images : never},
     {read_model<ModelFormat::glb, pictures>, pictures ? names_images : never},
     {read_model<ModelFormat::tds, pictures>, never},
     {read_model<ModelFormat::zip, pictures>, pictures ? always : never}}};

/// Indexed by GuideFormat.
constexpr std::array<Job, worker_guide_names.size()> guides = {{{read_curves<GuideFormat::usda>, never},
                                                                {read_curves<GuideFormat::hair>, never},
                                                                {read_curves<GuideFormat::json>, never}}};

}  // namespace

std::optional<Job> job_of(std::string_view name) {
  for (std::size_t i = 0; i < worker_format_names.size(); ++i) {
    if (name == worker_format_names[i]) return models<true>[i];
    if (name == std::string(worker_format_names[i]) + worker_shape) return models<false>[i];
  }
  for (std::size_t i = 0; i < guides.size(); ++i)
    if (name == worker_guide_names[i]) return guides[i];
  if (name == worker_environment) return Job{read_light, always};
  if (name == worker_map) return Job{read_data, always};
  if (name == worker_picture) return Job{read_backplate, always};
  if (name == worker_saved) return Job{read_saved, never};
  return {};
}

}  // namespace pelage
