#include "renderer/raster/gpu/gpu_raster.h"

#include <algorithm>
#include <list>
#include <utility>

#include "renderer/gl/sync.h"
#include "renderer/raster/gpu/box_stages.h"
#include "renderer/raster/gpu/scene_data.h"

namespace pelage {

struct GpuRaster::State {
  /// Number of scenes kept on the GPU, so that clients who take turns do not upload everything again.
  static constexpr std::size_t max_scenes = 4;

  struct Scene {
    const GrownPart* of;  // parts of the scene's fur: identify the scene
    SceneData data;
  };

  const Gl& gl;
  BoxStages stages;
  std::list<Scene> scenes = {};  // most recently drawn first

  /// Frees all buffers after the GL ran out of memory, so that the next frame starts fresh.
  Status out_of_memory() {
    while (gl.GetError() != GL_NO_ERROR) {
    }
    scenes.clear(), stages.release();
    return failure(Code::too_large, "no memory on the GPU for a frame of this size", "/width");
  }

  SceneData& data_of(const RasterScene& scene) {
    const auto found = std::ranges::find(scenes, scene.parts.data(), &Scene::of);
    if (found != scenes.end()) {
      scenes.splice(scenes.begin(), scenes, found);
    } else {
      if (scenes.size() == max_scenes) scenes.pop_back();
      scenes.push_front({scene.parts.data(), SceneData(gl)});
    }
    return scenes.front().data;
  }
};

Result<std::unique_ptr<GpuRaster>> GpuRaster::create(const Gl& gl, std::size_t max_bytes) {
  std::unique_ptr<GpuRaster> raster(new GpuRaster(gl, max_bytes));
  // Builds the common stages now; the first frame that needs a rarely used stage waits for it.
  for (const Stage stage :
       {Stage::skin, Stage::ends, Stage::hidden, Stage::keep, Stage::place, Stage::mark, Stage::light, Stage::hand_on,
        Stage::bins, Stage::scan, Stage::sort, Stage::blend, Stage::skin_light, Stage::resolve, Stage::finish})
    if (!raster->state_->stages.stages().begin(stage, RasterOutput::light, {}))
      return raster->state_->stages.stages().failure();
  return raster;
}

GpuRaster::GpuRaster(const Gl& gl, std::size_t max_bytes)
    : state_(std::make_unique<State>(State{gl, BoxStages(gl, max_bytes)})) {}
GpuRaster::~GpuRaster() = default;

namespace {

Status lost_it() { return failure(Code::unavailable, "the GL was reset"); }

}  // namespace

void GpuRaster::forget() { state_->scenes.clear(); }

bool GpuRaster::can_draw(const FurModel& model, const GrownFur& fur) const {
  std::size_t groups = 0, side = 0;
  for (const GrownPart& part : fur.parts()) groups += (part.strands->count() + strand_group - 1) / strand_group;
  for (const ImageView& image : model.images)
    side = std::max({side, static_cast<std::size_t>(image.width), static_cast<std::size_t>(image.height)});
  const std::size_t texels = 6 * side * side * model.images.size();  // bytes, with mip levels
  return groups <= max_strand_groups && std::max({StrandPool::bytes_for(fur.parts()), fur.bend().triangles.size_bytes(),
                                                  model.corners.size_bytes(), texels}) <= state_->stages.max_bytes();
}

void GpuRaster::measure(StageTimes* times) { state_->stages.stages().measure(times); }

int GpuRaster::box_pixels() const {
  constexpr std::size_t limit = 1 << 24;
  return static_cast<int>(std::min(state_->stages.max_bytes() / 32, limit));
}

Result<bool> GpuRaster::draw_rows(const RasterScene& scene, const PixelBox& pixels, RasterCounts& counts,
                                  const Encoding* encoding) {
  if (lost_) return lost_it();
  SceneData& data = state_->data_of(scene);
  BoxStages& stages = state_->stages;
  data.send_strands(scene);
  const StrandPlan strands = strand_plan(scene, pixels, data.pool);
  const DrawnBox box{scene, pixels, strands, tiles_of(pixels)};
  data.send(box);
  Totals found;
  do {
    data.send_plan(strands);  // resets what stages wrote into its parts
    if (!stages.draw(box, data) || (encoding && !stages.encode(scene, *encoding))) return stages.stages().failure();
    lost_ = !wait_for(state_->gl).ok() || state_->gl.GetGraphicsResetStatus() != GL_NO_ERROR;
    if (lost_) return lost_it();
    if (state_->gl.GetError() != GL_NO_ERROR) return state_->out_of_memory();
    found = stages.totals();
    if (!stages.has_room_for(found)) return false;
  } while (stages.grow_capacities(found));
  counts.entries += found.entries, counts.lit += found.lit_points;
  return true;
}

Status GpuRaster::draw_box(const RasterScene& scene, const PixelBox& box, FloatImage& picture, RasterCounts& counts) {
  const Result<bool> drawn = draw_rows(scene, box, counts);
  if (!drawn) return drawn.status();
  if (!*drawn) return draw_halves(scene, box, picture, counts);
  state_->stages.read(scene, box, picture);
  return {};
}

Result<std::optional<Image>> GpuRaster::draw_picture(const RasterScene& scene, const Encoding& encoding) {
  RasterCounts counts;
  const PixelBox full_box{0, 0, scene.width, scene.height};
  const std::int64_t pixels =
      std::max(scene.width * std::int64_t{scene.height}, encoding.width * std::int64_t{encoding.height});
  if (pixels > box_pixels()) return std::optional<Image>();
  const Result<bool> drawn = draw_rows(scene, full_box, counts, &encoding);
  if (!drawn) return drawn.status();
  if (!*drawn) return std::optional<Image>();
  auto picture = empty_picture<Image>(encoding.width, encoding.height);
  state_->stages.read(picture);
  return std::optional<Image>(std::move(picture));
}

Status GpuRaster::draw_halves(const RasterScene& scene, const PixelBox& box, FloatImage& picture,
                              RasterCounts& counts) {
  const int middle = box.top + (tiles_of(box).down / 2) * tile_side;
  if (middle == box.top) return failure(Code::too_large, "no memory on the GPU for a frame of this size", "/width");
  const Status drawn = draw_box(scene, {box.left, box.top, box.right, middle}, picture, counts);
  return drawn.ok() ? draw_box(scene, {box.left, middle, box.right, box.bottom}, picture, counts) : drawn;
}

}  // namespace pelage
