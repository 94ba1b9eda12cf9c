#include "tests/support/furred_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>

#include "server/builtin/builtin.h"
#include "server/frames/fur_view.h"
#include "server/groom/first_groom.h"
#include "server/import/import.h"
#include "server/surface/prepare.h"

namespace pelage::testing {

FurredModel furred(const RawModel& raw, FirstGroom fur) {
  static std::uint64_t last_id = 0;  // ids are unique in a process
  Result<Mesh> mesh = prepare(raw, {.source_is_32_bit = raw.is_32_bit});
  if (!mesh) throw std::runtime_error(mesh.status().message);
  PatchMap patches = lay_patches(*mesh);
  FieldSet fields = first_groom(*mesh, fur);
  return {{Surface(std::move(mesh).value()), std::move(patches), ++last_id, "test"}, std::move(fields), {}};
}

FurredModel furred(BuiltinModel model, FirstGroom fur) { return furred(make_builtin(model), fur); }

Coat coarse(Coat coat) {
  constexpr int times = 9;
  coat.count /= times;
  coat.width_root *= times, coat.width_tip *= times;
  return coat;
}

FurredModel coarse(FurredModel model) {
  for (NamedCoat& coat : model.settings.coats) coat.coat = coarse(coat.coat);
  return model;
}

FurredModel furred_file(const std::string& path, FirstGroom fur) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const ModelFormat format = path.ends_with(".obj") ? ModelFormat::obj : ModelFormat::ply;
  const Result<RawModel> raw =
      import_model(program_folder() + "/pelage-import", format, std::as_bytes(std::span(bytes)));
  if (!raw) throw std::runtime_error(raw.status().message);
  return furred(*raw, fur);
}

FrameRequest small_frame(AutoView view, int size) {
  FrameRequest request;
  request.width = request.height = size;
  request.camera.automatic = view;
  request.background = Background::transparent;
  request.tone_map = ToneMap::none;
  return request;
}

Image draw(Renderer& renderer, const FurredModel& model, const FrameRequest& request) {
  const VertexRange all{0, static_cast<std::uint32_t>(model.fields.size())};
  const SceneView view = model.view(request.masked);
  sync_scene(renderer, view, {all}, nullptr, request.knobs.method == Method::shells);
  renderer.clear_view_cache();
  Result<Image> image = renderer.draw(make_frame(view, request));
  if (!image) throw std::runtime_error(image.status().message);
  return std::move(image).value();
}

FrameCounters counters_of(Renderer& renderer, const FurFrame& frame) {
  renderer.clear_view_cache();
  DrawTimes times;
  const Result<Image> image = renderer.draw(frame, &times);
  if (!image) throw std::runtime_error(image.status().message);
  return times.counters;
}

double covered(const Image& image) {
  std::size_t count = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) count += image.rgba[i] > 127;
  return 4.0 * static_cast<double>(count) / static_cast<double>(image.rgba.size());
}

double mean_difference(const Image& a, const Image& b) {
  assert(a.rgba.size() == b.rgba.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(int(a.rgba[i]) - int(b.rgba[i]));
  return sum / static_cast<double>(a.rgba.size());
}

int largest_difference(const Image& a, const Image& b) {
  assert(a.rgba.size() == b.rgba.size());
  int largest = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    largest = std::max(largest, std::abs(int(a.rgba[i]) - int(b.rgba[i])));
  return largest;
}

glm::dvec3 mean_colour(const Image& image, int min) {
  glm::dvec3 sum(0);
  int count = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i + 3] < min) continue;
    sum += glm::dvec3(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]);
    ++count;
  }
  return count ? sum / double(count) : sum;
}

}  // namespace pelage::testing
