// Frames of rasterized strands: what a coat grows is kept for each model, so that a stroke grows its part alone.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "protocol/base/status.h"
#include "renderer/frame/draw_times.h"
#include "renderer/frame/pieces.h"
#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

enum class RasterOutput;

/// Belongs to one thread; draws on up to `threads`, with the same bits for any number of them.
class RasterRenderer {
 public:
  explicit RasterRenderer(int threads);
  ~RasterRenderer();

  bool has(std::uint64_t model) const { return models_.contains(model); }
  /// Both give the bytes that were taken over.
  std::size_t add(const FurModel& model, const FurFields& fields);
  std::size_t update(std::uint64_t model, const FurFields& fields);
  void forget(std::uint64_t original);
  void forget_all();
  /// Of all copies of a model (FurModel::original), with their strands.
  std::size_t bytes_of(std::uint64_t original) const;

  /// One picture for each, as Renderer::draw_aovs has them, of the frame's size; with a crop what lies outside it is
  /// not drawn. The pause is called between boxes of about a million pixels. Fails with too_large when there is no
  /// memory for it, and with conflict when the pause gives the drawing up.
  Result<std::vector<FloatImage>> draw(const FurFrame& frame, std::span<const Aov> aovs, DrawTimes& times,
                                       const Pause& pause);

 private:
  struct Model;
  /// Grows what changed. What is kept of other models is dropped where all take too much, the longest unused first.
  Model& grown(const FurFrame& frame);
  Result<FloatImage> draw_shown(const FurFrame& frame, RasterOutput shown, DrawTimes& times, const Pause& pause);

  int threads_;
  std::map<std::uint64_t, std::unique_ptr<Model>> models_;
  std::uint64_t uses_ = 0;
};

}  // namespace pelage
