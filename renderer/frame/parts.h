// What the parts of the renderer share.
#pragma once

#include <optional>
#include <string>

#include "renderer/frame/draw_clock.h"
#include "renderer/frame/gl_renderer.h"

namespace pelage {

/// Draws and clears touch an area alone while it lives; nothing is set where there is none.
class ScissorTest {
 public:
  ScissorTest(const Gl& gl, const std::optional<Area>& area) : gl_(gl), on_(area) {
    if (!on_) return;
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(area->left, area->top, area->width, area->height);
  }
  ~ScissorTest() {
    if (on_) gl_.Disable(GL_SCISSOR_TEST);
  }
  ScissorTest(const ScissorTest&) = delete;
  ScissorTest& operator=(const ScissorTest&) = delete;

 private:
  const Gl& gl_;
  bool on_;
};

struct GlRenderer::Prepared {
  const CoatTextures& coat;
  ModelBuffers& model;
  ModelBuffers::DrawLists lists;
  std::string variant;
  FrameBlock block;
  std::optional<Area> part;  // that is drawn; all where there is none

  FurDrawing drawing(const FurFrame& frame) const { return {frame, variant, model, lists, coat}; }
};

Area area_of(const RenderTarget& target);  // all of it
/// All cells that an area of a picture of that size touches.
CellBox cells_of(const Area& area, int width, int height);

/// The #define lines of a frame's light and colours: light from all around that is not white from everywhere, how many
/// lights there are, whether all are far away, and whether the coat's ramp alone gives the colours.
std::string light_of(const FurFrame& frame, bool model_has_colours);

/// The #define lines of what shapes and colours the fur beside its fields.
std::string shape_of(const Coat& coat, const ModelBuffers& model);

template <class Picture>
Result<Picture> GlRenderer::read_back(const RenderTarget& picture, GLenum type) {
  Picture image;
  image.width = picture.width(), image.height = picture.height();
  image.rgba.resize(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, picture.framebuffer());
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, image.width, image.height, GL_RGBA, type, image.rgba.data());
  if (gl_.GetError() != GL_NO_ERROR) return failure(Code::internal, "a GL error while drawing");
  return image;
}

}  // namespace pelage
