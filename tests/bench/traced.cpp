#include "tests/bench/traced.h"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace pelage::bench {

namespace {

constexpr std::size_t memory = std::size_t{6} << 30;

void check(const Status& status) {
  if (!status.ok()) std::fprintf(stderr, "%s\n", status.message.c_str()), std::exit(4);
}

bool always() { return true; }

void begin(Renderer& renderer, Tracer& tracer, const SceneView& view, const FurFrame& frame) {
  sync_scene(renderer, view, {});
  Result<Backplate> base = renderer.draw_backplate(frame);
  if (!base) check(base.status());
  const ModelArrays arrays = make_arrays(view);
  check(tracer.begin(make_model(view, arrays), make_fields(view, frame.skin, {}), frame, std::move(*base),
                     std::array{Aov::beauty}, always));
}

}  // namespace

FurFrame begin_trace(Renderer& renderer, Tracer& tracer, const testing::FurredModel& model, const FrameRequest& request,
                     float distance) {
  FurFrame frame = make_frame(model.view(), request);
  frame.camera.position *= distance;
  begin(renderer, tracer, model.view(), frame);
  return frame;
}

void trace_to_end(Tracer& tracer, const std::function<void(const TraceReport&)>& after_pass) {
  while (tracer.report().end == TraceEnd::none) {
    check(tracer.add_pass(always));
    if (after_pass) after_pass(tracer.report());
  }
}

FloatImage traced_light(Renderer& renderer, const SceneView& view, const FurFrame& frame) {
  Tracer tracer(2, memory, false);
  begin(renderer, tracer, view, frame);
  trace_to_end(tracer);
  return tracer.aov(Aov::beauty);
}

FloatImage traced_beauty(Renderer& renderer, const testing::FurredModel& model, const FrameRequest& request,
                         float distance) {
  Tracer tracer(2, memory, false);
  begin_trace(renderer, tracer, model, request, distance);
  trace_to_end(tracer);
  return tracer.aov(Aov::beauty);
}

}  // namespace pelage::bench
