#include "renderer/raster/gpu/stages.h"

#include <algorithm>
#include <string_view>

#include "base/stopwatch.h"

namespace pelage {

namespace shaders {
extern const char* const bend_comp;
extern const char* const bins_comp;
extern const char* const blend_comp;
extern const char* const body_comp;
extern const char* const columns_comp;
extern const char* const density_comp;
extern const char* const ends_comp;
extern const char* const finish_comp;
extern const char* const ground_comp;
extern const char* const hand_on_comp;
extern const char* const hidden_comp;
extern const char* const intersect_eyes_comp;
extern const char* const keep_comp;
extern const char* const light_comp;
extern const char* const light_eyes_comp;
extern const char* const look_back_comp;
extern const char* const mark_comp;
extern const char* const name_comp;
extern const char* const near_comp;
extern const char* const place_comp;
extern const char* const resolve_comp;
extern const char* const scan_comp;
extern const char* const skin_comp;
extern const char* const skin_light_comp;
extern const char* const sky_comp;
extern const char* const sort_comp;
extern const char* const sweep_comp;
extern const char* const within_comp;
}  // namespace shaders

namespace {

struct StageSource {
  const char *name, *source;
};

StageSource source_of(Stage stage) {
  switch (stage) {
    case Stage::bend: return {"bend", shaders::bend_comp};
    case Stage::density: return {"density", shaders::density_comp};
    case Stage::body: return {"body", shaders::body_comp};
    case Stage::within: return {"within", shaders::within_comp};
    case Stage::sweep: return {"sweep", shaders::sweep_comp};
    case Stage::look_back: return {"look_back", shaders::look_back_comp};
    case Stage::near: return {"near", shaders::near_comp};
    case Stage::columns: return {"columns", shaders::columns_comp};
    case Stage::sky: return {"sky", shaders::sky_comp};
    case Stage::skin: return {"skin", shaders::skin_comp};
    case Stage::intersect_eyes: return {"intersect_eyes", shaders::intersect_eyes_comp};
    case Stage::light_eyes: return {"light_eyes", shaders::light_eyes_comp};
    case Stage::ends: return {"ends", shaders::ends_comp};
    case Stage::hidden: return {"hidden", shaders::hidden_comp};
    case Stage::keep: return {"keep", shaders::keep_comp};
    case Stage::place: return {"place", shaders::place_comp};
    case Stage::mark: return {"mark", shaders::mark_comp};
    case Stage::light: return {"light", shaders::light_comp};
    case Stage::hand_on: return {"hand_on", shaders::hand_on_comp};
    case Stage::bins: return {"bins", shaders::bins_comp};
    case Stage::scan: return {"scan", shaders::scan_comp};
    case Stage::sort: return {"sort", shaders::sort_comp};
    case Stage::blend: return {"blend", shaders::blend_comp};
    case Stage::name: return {"name", shaders::name_comp};
    case Stage::skin_light: return {"skin_light", shaders::skin_light_comp};
    case Stage::ground: return {"ground", shaders::ground_comp};
    case Stage::finish: return {"finish", shaders::finish_comp};
    case Stage::resolve: return {"resolve", shaders::resolve_comp};
  }
  return {"", nullptr};
}

/// Returns the name by which shaders select an output; empty for light.
std::string name_of(RasterOutput output) {
  switch (output) {
    case RasterOutput::light: return {};
    case RasterOutput::albedo: return "SHOWN_ALBEDO";
    case RasterOutput::normal: return "SHOWN_NORMAL";
    case RasterOutput::tangent: return "SHOWN_TANGENT";
    case RasterOutput::direct: return "SHOWN_DIRECT";
    case RasterOutput::triangle: return "SHOWN_TRIANGLE";
    case RasterOutput::field: return "SHOWN_FIELD";
    case RasterOutput::shadow: return "SHOWN_SHADOW";
    case RasterOutput::distance: return "SHOWN_DISTANCE";
    case RasterOutput::depth: return "SHOWN_DEPTH";
    case RasterOutput::count: return "SHOWN_COUNT";
    case RasterOutput::strand: return "SHOWN_STRAND";
    case RasterOutput::objects: assert(false);  // the CPU draws them
  }
  return {};
}

/// Returns the #define lines for an output, but only of names that the source contains, so that a stage has no more
/// variants than it needs.
std::string defines_of(std::string_view source, RasterOutput output) {
  std::string defines;
  const auto add = [&](const std::string& name) {
    if (!name.empty() && source.find(name) != source.npos) defines += "#define " + name + "\n";
  };
  add(name_of(output)), add(is_coloured(output) ? "" : "UNCOLOURED");
  return defines;
}

}  // namespace

const char* name_of(Stage stage) { return source_of(stage).name; }

const Program* Stages::begin(Stage stage, RasterOutput output, std::initializer_list<StageStorage> storage) {
  const char* source = source_of(stage).source;
  const std::string defines = defines_of(source, output);
  const auto [found, is_new] = programs_.try_emplace({stage, defines});
  Program& program = found->second;
  if (is_new) program = Program::of_compute(gl_, source, defines);
  if (program.id() == 0) {
    failure_ = pelage::failure(Code::unavailable, "a shader of the rasterizer cannot be built: " + program.log());
    return nullptr;
  }
  program.use();
  current_ = stage;
  for (const auto& [binding, of] : storage)
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(binding), of->id());
  return &program;
}

void Stages::run(std::size_t groups) const {
  constexpr std::size_t across = 32768;  // work groups in a row; GL guarantees 65535
  if (groups == 0) return;
  run({std::min(groups, across), (groups + across - 1) / across});
}

void Stages::run(glm::ivec2 groups) const {
  if (!times_) return dispatch(groups);
  gl_.Finish();
  const Stopwatch passed;
  gl_.BeginQuery(GL_TIME_ELAPSED, timer_.id());
  dispatch(groups);
  gl_.EndQuery(GL_TIME_ELAPSED);
  gl_.Finish();
  GLuint64 nanoseconds = 0;
  gl_.GetQueryObjectui64v(timer_.id(), GL_QUERY_RESULT, &nanoseconds);
  // A software GL is timed on the CPU, because llvmpipe's timer does not run while it computes.
  (*times_)[current_] += gl_.is_software() ? passed.milliseconds() : 1e-6 * static_cast<double>(nanoseconds);
}

void Stages::dispatch(glm::ivec2 groups) const {
  gl_.DispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), 1);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

}  // namespace pelage
