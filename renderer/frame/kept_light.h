// What the targets of the last frame show. A stroke changes a part of the body: when the next frame is the same but for
// the fields of some vertices and what stands on them, only the part of the picture that these may reach is drawn again.
#pragma once

#include <optional>

#include "renderer/gl/render_target.h"
#include "renderer/input/fur_scene.h"
#include "renderer/passes/sorted/areas.h"
#include "renderer/upload/set_cells.h"

namespace pelage {

struct ShownFrame {
  FurFrame frame;
  GLenum picture = 0;  // the format of the finished picture, 0 where that is lost
};

class KeptLight {
 public:
  /// Remembers that the targets show the frame's light and its picture. Frames in which a vertex may change pixels far
  /// away are not kept: those with maps of shadows, fins, guard hairs, sorted fragments or an overlay.
  void keep(const FurFrame& frame, GLenum picture);
  void forget() { shown_.reset(); }
  void forget_picture() {
    if (shown_) shown_->picture = 0;
  }
  /// The frame whose light the target shows, where it is this one but for curves and changes of the model's fields; it
  /// is forgotten, as something else will be drawn. Its picture is lost where it is of another format, or finished
  /// otherwise.
  std::optional<ShownFrame> take(const FurFrame& frame, GLenum picture);

 private:
  std::optional<ShownFrame> shown_;
};

/// The part of the picture where curves are not, or do not look, the same in both frames.
std::optional<ClipBox> changed_curves(const FurFrame& before, const FurFrame& now, const glm::mat4& to_clip);

/// A part of a picture that is drawn on its own, and all cells that it touches.
struct PicturePart {
  Area area;
  CellBox cells;
};

/// The pixels that the box touches; no pixels for no box.
PicturePart part_of(const std::optional<ClipBox>& box, int width, int height);

/// The pixels of a finished picture that an area of its light touches.
Area finished_area(const Area& area, const RenderTarget& light, const RenderTarget& picture);

}  // namespace pelage
