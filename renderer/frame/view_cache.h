// The last views and the targets that show them. A stroke changes a part of the body: when a view is drawn again, the
// same but for the fields of some vertices and what stands on them, only the part of the picture that these may reach
// is drawn.
#pragma once

#include <cstdint>
#include <list>
#include <optional>

#include "renderer/gl/handles.h"
#include "renderer/input/fur_scene.h"
#include "renderer/passes/sorted/sorted_pass.h"
#include "renderer/visibility/picture_cells.h"

namespace pelage {

struct ShownFrame {
  FurFrame frame;
  GLenum picture = 0;         // the format of the finished picture, 0 where it is not this frame's
  std::uint64_t changes = 0;  // ModelBuffers::changes when it was drawn
};

struct CachedView {
  RenderTarget drawn, picture;      // light, the finished picture
  std::optional<ShownFrame> shown;  // none: the targets are to be used again
  bool came_back = false;           // asked for more than once
};

/// So that several who groom, or look from several sides, do not cost each other whole frames.
class ViewCache {
 public:
  /// The view that shows the frame's light: this frame but for curves and changes of the model's fields. Its picture is
  /// lost where it is of another format, or finished otherwise. If there is none, targets that may be drawn over.
  CachedView take(const FurFrame& frame, GLenum picture);
  /// Frames in which a vertex may change pixels far away are not kept, their targets are: those with maps of shadows,
  /// fins, guard hairs, sorted fragments or an overlay. What is too many or too large is given back: first what shows
  /// nothing, then what was asked for once, as an orbit asks for each of its frames, then what is oldest.
  void keep(CachedView view);
  void clear_shown();
  void give_back() { views_.clear(); }

 private:
  using Views = std::list<CachedView>;  // the last one first
  Views::iterator victim();
  CachedView take_out(Views::iterator view);

  Views views_;
};

/// The part of the picture where curves are not, or do not look, the same in both frames.
std::optional<ClipBox> changed_curves(const FurFrame& before, const FurFrame& now, const glm::mat4& to_clip);

/// The pixels that the box touches; no pixels for no box.
Area area_of(const std::optional<ClipBox>& box, int width, int height);
/// All cells that an area of a picture of that size touches.
CellBox cells_of(const Area& area, int width, int height);

/// The pixels of a finished picture that an area of its light touches.
Area finished_area(const Area& area, const RenderTarget& light, const RenderTarget& picture);

}  // namespace pelage
