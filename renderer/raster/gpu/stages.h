// The compute shaders of the rasterizer, each built when it is first needed.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <utility>

#include "base/status.h"
#include "renderer/gl/program.h"
#include "renderer/raster/gpu/storage.h"
#include "renderer/raster/raster_scene.h"

namespace pelage {

/// A buffer that a stage reads or writes, and its binding.
struct StageStorage {
  int binding;
  const Storage* storage;
};

enum class Stage {
  bend,
  density,
  body,
  within,
  sweep,
  look_back,
  near,
  columns,
  sky,
  skin,
  intersect_eyes,
  ends,
  hidden,
  keep,
  place,
  mark,
  light,
  hand_on,
  bins,
  scan,
  sort,
  blend,
  name,
  light_eyes,
  skin_light,
  ground,
  resolve,
  finish
};

/// Milliseconds of each stage on the GPU.
using StageTimes = std::map<Stage, double>;
/// Returns the name of a stage's shader file, without its extension.
const char* name_of(Stage stage);

class Stages {
 public:
  explicit Stages(const Gl& gl) : gl_(gl), timer_(gl, GL_TIME_ELAPSED) {}

  /// Makes a stage current, with its storage, in the variant for `output` if it depends on that. Returns null if the
  /// stage cannot be built: `failure` says why.
  const Program* begin(Stage stage, RasterOutput output, std::initializer_list<StageStorage> storage);
  /// Runs the current stage with that many work groups. What it writes is visible to later stages.
  void run(std::size_t groups) const;
  void run(glm::ivec2 groups) const;

  const Status& failure() const { return failure_; }

  /// Where given, each run waits for the GPU and adds its milliseconds to `times`; for benchmarks. Null turns that off.
  void measure(StageTimes* times) { times_ = times; }

 private:
  void dispatch(glm::ivec2 groups) const;

  const Gl& gl_;
  QueryObject timer_;
  StageTimes* times_ = nullptr;
  Stage current_ = Stage::skin;
  std::map<std::pair<Stage, std::string>, Program> programs_;
  Status failure_;
};

}  // namespace pelage
