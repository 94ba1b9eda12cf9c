// A picture in linear light, as far as it is: what its file is finished from.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "protocol/commands/answers.h"
#include "protocol/commands/frame.h"
#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"
#include "server/frames/frame_parts.h"
#include "server/scene/scene.h"

namespace pelage {

/// A picture with everything that its file needs. Never changes once it is made.
struct LinearPicture {
  Revision revision = 0;
  TraceReport report = {};            // of traced strands
  std::vector<FloatImage> aovs = {};  // those of linear_aovs(request), of the whole frame; a crop alone is drawn
  std::shared_ptr<const FurFrame> frame = {};
  ModelPlacement placement = {};
  FrameTimings timings = {};
  FrameCounters counters = {};  // of shells, or of what lies under traced strands
  // Of an earlier revision what it was drawn from: for as long as it lives, the renderer has it for overlays.
  SnapshotPtr past = {};
};

/// The AOVs that a request's file is made of: those of an EXR, with the parts of cryptomatte in its place; else beauty.
std::vector<Aov> linear_aovs(const FrameRequest& request);

/// The request for them.
FrameRequest linear_request(const FrameRequest& request);

/// The knobs that draw the same picture again: of a frame, with the report of traced strands.
Knobs knobs_of(const FurFrame& frame, const std::optional<TraceReport>& report);

/// The picture that an open shutter sees while a scene moves: the mean of pictures of one frame at several moments.
/// Depth, position, normal and tangent, whose mean would lie nowhere, come from the middle picture.
class MeanPicture {
 public:
  /// `aovs`: of each picture.
  MeanPicture(std::vector<Aov> aovs, int count) : kinds_(std::move(aovs)), count_(count) {}

  /// Adds the next picture, in the order of the moments. All pictures have the same size.
  void add(LinearPicture picture);
  /// Returns the mean, once `count` pictures were added.
  LinearPicture take() &&;

 private:
  std::vector<Aov> kinds_;
  int count_;
  int added_ = 0;
  LinearPicture mean_;                     // the middle one, until it is taken
  std::vector<std::vector<double>> sums_;  // of each AOV
  TraceReport report_;
  double noise_square_ = 0;
};

}  // namespace pelage
