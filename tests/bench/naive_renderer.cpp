#include "tests/bench/naive_renderer.h"

#include <array>
#include <cassert>

#include "renderer/finish/finish.h"
#include "renderer/shells/draw/draw.h"
#include "server/frames/fur_view.h"

namespace pelage {
namespace shaders {
extern const char* const fur_vert;
extern const char* const naive_frag;
extern const char* const skin_vert;
extern const char* const skin_frag;
}  // namespace shaders

namespace bench {

namespace {

ModelBuffers send(const Gl& gl, const testing::FurredModel& model) {
  UploadCount count;
  const Mesh& mesh = model.model.surface.mesh();
  const FurTriangles patch_triangles = make_fur_triangles(mesh, model.model.patches);
  return ModelBuffers(gl,
                      {model.model.id,
                       mesh.positions,
                       mesh.normals,
                       mesh.tangents,
                       patch_triangles.triangles,
                       patch_triangles.corners,
                       {},
                       !mesh.corners.empty()},
                      {model.fields.direction(), model.fields.length(), {}}, count);
}

std::string defines_of(const FurFrame& frame, const testing::FurredModel& model) {
  const bool ramp = !takes_model_colours(frame.look, !model.model.surface.mesh().corners.empty());
  return std::string(ramp ? "#define RAMP_COLOURS\n" : "") + "#define FAR_LIGHTS\n#define LIGHTS " +
         std::to_string(frame.lights.size()) + "\n#define SHADING_MODEL " +
         std::to_string(static_cast<int>(frame.look.shading)) + "\n";
}

CoatTextures trilinear(const Gl& gl, const Coat& coat) {
  UploadCount count;
  CoatTextures textures(gl, coat, bake_slices(coat), count);
  for (const GLuint texture : {textures.shapes(), textures.colours()}) {
    gl.TextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  }
  return textures;
}

}  // namespace

NaiveRenderer::NaiveRenderer(const Gl& gl, const testing::FurredModel& model, const FurFrame& frame)
    : gl_(gl),
      frame_(frame),
      coat_(trilinear(gl, frame.coat())),
      model_(send(gl, model)),
      skin_(gl, shaders::skin_vert, shaders::skin_frag, defines_of(frame, model)),
      shell_(gl, shaders::fur_vert, shaders::naive_frag, defines_of(frame, model)),
      scattering_(gl),
      block_(gl),
      drawn_(gl, GL_RGBA16F, frame.width, frame.height, true) {
  assert(skin_.id() && shell_.id() && drawn_.complete());
  gl.NamedBufferData(block_.id(), sizeof(FrameBlock), nullptr, GL_STREAM_DRAW);
}

Image NaiveRenderer::draw() {
  const FrameBlock block = make_frame_block(frame_, coat_.slices(), model_.has_colours(), frame_.height);
  const int shells = frame_.knobs.shells.count;
  const auto lists =
      model_.lists_for(gl_, {glm::vec3(block.viewpoint), block.viewpoint.w, shells, ShellPolicy::uniform});
  const std::array<float, 4> nothing{};
  const float far_away = 0;
  gl_.ClearNamedFramebufferfv(drawn_.framebuffer(), GL_COLOR, 0, nothing.data());
  gl_.ClearNamedFramebufferfv(drawn_.framebuffer(), GL_DEPTH, 0, &far_away);
  gl_.NamedBufferSubData(block_.id(), 0, sizeof(FrameBlock), &block);
  gl_.BindBufferBase(GL_UNIFORM_BUFFER, 0, block_.id());
  scattering_.prepare(gl_, frame_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_.framebuffer());
  gl_.Viewport(0, 0, frame_.width, frame_.height);
  gl_.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_GEQUAL);
  gl_.BindVertexArray(model_.vertex_array());
  gl_.BindTextureUnit(0, coat_.shapes());
  gl_.BindTextureUnit(1, coat_.colours());
  gl_.BindTextureUnit(2, model_.base_images());
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_BLEND);
  skin_.use();
  gl_.DrawElements(GL_TRIANGLES, lists.all.count, GL_UNSIGNED_INT, nullptr);
  gl_.DepthMask(GL_FALSE);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  shell_.use();
  shell_.set("push", 0.0f);
  shell_.set("shell_count", shells);
  const auto draw_side = [&](const std::vector<std::pair<int, ModelBuffers::DrawList>>& side, int sign) {
    shell_.set("shell_side", sign);
    for (const auto& [shell, list] : side) {
      shell_.set("shell", shell);
      draw_list(gl_, list);
    }
  };
  draw_side(lists.back_facing, -1);
  draw_side(lists.facing, 1);
  gl_.Disable(GL_BLEND);
  FloatImage light;
  light.width = frame_.width, light.height = frame_.height;
  light.rgba.resize(4 * static_cast<std::size_t>(frame_.width) * static_cast<std::size_t>(frame_.height));
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.framebuffer());
  gl_.ReadPixels(0, 0, frame_.width, frame_.height, GL_RGBA, GL_FLOAT, light.rgba.data());
  gl_.DepthMask(GL_TRUE);
  return finish_picture(frame_, {light});
}

}  // namespace bench
}  // namespace pelage
