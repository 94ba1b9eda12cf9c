// What the target of the last frame shows. A stroke changes a part of the body: when the next frame is the same but for
// the fields of some vertices and what stands on them, only the part of the picture that these may reach is drawn again.
#pragma once

#include <optional>

#include "renderer/input/fur_scene.h"
#include "renderer/passes/sorted/areas.h"
#include "renderer/upload/set_cells.h"

namespace pelage {

class KeptLight {
 public:
  /// Remembers that the target shows the frame's light. Frames in which a vertex may change pixels far away are not
  /// kept: those with maps of shadows, fins, guard hairs, sorted fragments or an overlay.
  void keep(const FurFrame& frame);
  void forget() { frame_.reset(); }
  /// The frame that the target shows, where it is this one but for curves and changes of the model's fields; it is
  /// forgotten, as something else will be drawn.
  std::optional<FurFrame> take(const FurFrame& frame);

 private:
  std::optional<FurFrame> frame_;
};

/// The part of the picture that groups of curves reach, before or now, which are not the same in both frames.
std::optional<ClipBox> changed_curves(const FurFrame& before, const FurFrame& now, const glm::mat4& to_clip);

/// A part of a picture that is drawn on its own, and all cells that it touches.
struct PicturePart {
  Area area;
  CellBox cells;
};

/// The pixels that the box touches; no pixels for no box.
PicturePart part_of(const std::optional<ClipBox>& box, int width, int height);

}  // namespace pelage
