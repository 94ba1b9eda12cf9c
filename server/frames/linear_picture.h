// Pictures in linear light, from which files are finished.
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

/// A linear picture with everything that its file needs. Immutable.
struct LinearPicture {
  Revision revision = 0;
  TraceReport report = {};            // of traced strands
  std::vector<FloatImage> aovs = {};  // linear_aovs(request), for the whole frame; with a crop, only that part is drawn
  std::shared_ptr<const FurFrame> frame = {};
  ModelPlacement placement = {};
  FrameTimings timings = {};
  FrameCounters counters = {};  // of the drawing, or of a traced picture's backplate
  // The snapshot of an earlier revision that it was drawn from; while it lives, the renderer keeps its copy for
  // overlays.
  SnapshotPtr past = {};
};

/// Returns the AOVs that a request's file is made of. For a linear format, those it names, with cryptomatte replaced by
/// its parts; else beauty.
std::vector<Aov> linear_aovs(const FrameRequest& request);

/// Returns the request for those AOVs, as an EXR.
FrameRequest linear_request(const FrameRequest& request);

/// Returns the knobs that reproduce the picture of a frame; `report` is that of traced strands.
Knobs knobs_of(const FurFrame& frame, const std::optional<TraceReport>& report);

/// The picture of an open shutter while a scene moves: the mean of pictures of one frame at several times. AOVs whose
/// mean is meaningless, such as depth, position, normal and tangent, come from the middle picture.
class MeanPicture {
 public:
  /// `aovs` are those of each picture; `count` is the number of pictures.
  MeanPicture(std::vector<Aov> aovs, int count) : kinds_(std::move(aovs)), count_(count) {}

  /// Adds the next picture, in order of time. All pictures have the same size.
  void add(LinearPicture picture);
  /// Returns the mean, after `count` pictures were added.
  LinearPicture take() &&;

 private:
  std::vector<Aov> kinds_;
  int count_;
  int added_ = 0;
  LinearPicture mean_;                     // the middle picture, until take()
  std::vector<std::vector<double>> sums_;  // for each AOV
  TraceReport report_;
  double noise_square_ = 0;
};

}  // namespace pelage
