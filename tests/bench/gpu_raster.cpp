// Strands rasterized by the GPU: build time of the shaders, median milliseconds of each stage (timer queries), minimum
// milliseconds of whole frames with read-back beside the CPU in the same run, and the mean difference of the two
// pictures.
// usage: bench_gpu_raster [--gl auto|egl|osmesa] [--size WIDTHxHEIGHT] [--triangles N] [--strands N] [--repetitions N]
#include "renderer/raster/gpu/gpu_raster.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "base/stopwatch.h"
#include "renderer/raster/gpu/stages.h"
#include "renderer/raster/kernels.h"
#include "renderer/strands/tracer.h"
#include "server/frames/fur_view.h"
#include "server/scene/creature_settings.h"
#include "tests/bench/measure.h"

namespace pelage::bench {
namespace {

struct Setup {
  GlChoice gl;
  int width, height, triangles, strands, repetitions;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Draws the light of one frame, whose fur is grown once, repeatedly on the CPU and on the GPU.
class Duel {
 public:
  Duel(const testing::FurredModel& model, const FurFrame& frame, const Gl& gl, int repetitions)
      : frame_(frame),
        repetitions_(repetitions),
        raster_(default_threads()),
        arrays_(make_arrays(model.view())),
        model_(make_model(model.view(), arrays_)) {
    const Stopwatch built;
    auto made = GpuRaster::create(gl);
    if (!made) std::fprintf(stderr, "%s\n", made.status().message.c_str()), std::exit(4);
    gpu_ = std::move(made).value();
    std::printf("shaders built in %.0f ms\n", built.milliseconds());
    GrowRecipe recipe{.coat = frame.coat(), .model_colours = takes_model_colours(frame.look, model_.has_colours)};
    fur_.update(model_, make_fields(model.view(), {}, {}), recipe, default_threads());
    quality_ = quality_of(frame.knobs, winding(frame.coat()));
    scene_ = raster_.scene_of(model_, fur_, frame, quality_, RasterOutput::light);
    raster_.fill_cells(scene_);
    std::printf("%zu strands\n", fur_.count());
  }

  void run(const char* name) {
    auto by_cpu = empty_picture<FloatImage>(frame_.width, frame_.height), by_gpu = by_cpu;
    double cpu = 1e9, gpu = 1e9;
    StageSamples stages, after_change;
    draw_gpu(by_gpu);  // warm-up: buffers grow to their final size
    for (int i = 0; i < repetitions_; ++i) {
      const Stopwatch on_cpu;
      draw_cpu(by_cpu);
      cpu = std::min(cpu, on_cpu.milliseconds());
      const Stopwatch on_gpu;
      draw_gpu(by_gpu);
      gpu = std::min(gpu, on_gpu.milliseconds());
      measure(by_gpu, stages);
      gpu_->forget(), measure(by_gpu, after_change);
    }
    std::printf("%s: GL %.2f ms with read-back, CPU %.2f ms on %d threads\n", name, gpu, cpu, default_threads());
    std::erase_if(after_change, [&](const auto& sample) { return stages.contains(sample.first); });
    const double sum = print(stages);
    std::printf("  where fur or lights are others also:\n");
    const double more = print(after_change);
    double apart = 0;
    for (std::size_t i = 0; i < by_cpu.rgba.size(); ++i) apart += std::abs(double{by_cpu.rgba[i]} - by_gpu.rgba[i]);
    std::printf("  all stages %8.3f, with those %.3f; light is %.2g apart in the mean\n", sum, sum + more,
                apart / static_cast<double>(by_cpu.rgba.size()));
  }

 private:
  using StageSamples = std::map<Stage, std::vector<double>>;  // milliseconds

  void measure(FloatImage& picture, StageSamples& samples) {
    StageTimes times;
    gpu_->measure(&times), draw_gpu(picture), gpu_->measure(nullptr);
    for (const auto& [stage, milliseconds] : times) samples[stage].push_back(milliseconds);
  }
  /// Prints the median of each stage. Returns their sum, in milliseconds.
  static double print(const StageSamples& samples) {
    double sum = 0;
    for (const auto& [stage, values] : samples) {
      std::printf("  %-10s %8.3f\n", name_of(stage), median(values));
      sum += median(values);
    }
    return sum;
  }
  void draw_cpu(FloatImage& picture) {
    RasterCounts counts;
    for (const PixelBox& box : Raster::boxes_of(frame_)) raster_.draw_box(scene_, box, picture, counts);
  }
  void draw_gpu(FloatImage& picture) {
    RasterCounts counts;
    for (const PixelBox& box : Raster::boxes_of(frame_, gpu_->box_pixels())) {
      if (const Status drawn = gpu_->draw_box(scene_, box, picture, counts); !drawn.ok())
        std::fprintf(stderr, "%s\n", drawn.message.c_str()), std::exit(4);
    }
  }

  const FurFrame& frame_;
  int repetitions_;
  Raster raster_;
  ModelArrays arrays_;
  FurModel model_;
  GrownFur fur_;
  RasterQuality quality_;
  RasterScene scene_;
  std::unique_ptr<GpuRaster> gpu_;
};

int run(const Setup& setup) {
  const Result<std::unique_ptr<Context>> context = select_context(setup.gl, 0);
  if (!context || !*context) return std::fprintf(stderr, "no GL\n"), 4;
  std::printf("%s; %s on the CPU\n%d x %d, %d triangles\n", (*context)->description().c_str(), instruction_set(),
              setup.width, setup.height, setup.triangles);
  testing::FurredModel model = testing::furred({Builtin::creature, setup.triangles});
  model.model.name = "creature", model.settings = first_settings(model.model);
  if (setup.strands > 0) model.settings.coats[0].coat.count = setup.strands;
  for (const auto& [name, tier] :
       {std::pair{"draft", Tier::draft}, {"interactive", Tier::interactive}, {"detailed", Tier::detailed}}) {
    FrameRequest request;
    request.width = setup.width, request.height = setup.height, request.knobs = knobs_of(tier);
    const double scale = request.knobs.scale;
    FurFrame frame = make_frame(model.view(), request);
    frame.width = static_cast<int>(frame.width * scale), frame.height = static_cast<int>(frame.height * scale);
    frame.eyes.clear();
    Duel(model, frame, (*context)->gl(), setup.repetitions).run(name);
  }
  return 0;
}

int asked(int argc, char** argv, const char* name, int fallback) {
  for (int i = 1; i + 1 < argc; ++i)
    if (std::strcmp(argv[i], name) == 0) return std::atoi(argv[i + 1]);
  return fallback;
}

}  // namespace
}  // namespace pelage::bench

int main(int argc, char** argv) {
  using namespace pelage;
  GlChoice gl = GlChoice::egl;
  int width = 512, height = 512;
  for (int i = 1; i + 1 < argc; ++i) {
    if (std::strcmp(argv[i], "--gl") == 0)
      gl = std::strcmp(argv[i + 1], "osmesa") == 0 ? GlChoice::osmesa
           : std::strcmp(argv[i + 1], "auto") == 0 ? GlChoice::automatic
                                                   : GlChoice::egl;
    if (std::strcmp(argv[i], "--size") == 0) std::sscanf(argv[i + 1], "%dx%d", &width, &height);
  }
  return bench::run({gl, width, height, bench::asked(argc, argv, "--triangles", 20000),
                     bench::asked(argc, argv, "--strands", 0), bench::asked(argc, argv, "--repetitions", 5)});
}
