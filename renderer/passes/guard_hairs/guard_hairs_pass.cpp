#include "renderer/passes/guard_hairs/guard_hairs_pass.h"

#include <numeric>

#include "renderer/coat/strand_tile.h"
#include "renderer/passes/draw/draw.h"
#include "renderer/shaders/constants.h"

namespace pelage {

namespace shaders {
extern const char* const hair_vert;
extern const char* const hair_frag;
}  // namespace shaders

namespace {

HairMesh mesh_of(const ModelBuffers& model) {
  return {model.positions(), model.normals(), model.triangles(), model.welded()};
}

void set_hair(const Program& hair, const Coat& coat) {
  hair.set("segments", hair_segments);
  hair.set("limit", hair_limit);
  hair.set("width_root", static_cast<float>(coat.width_root));
  hair.set("width_tip", static_cast<float>(coat.width_tip));
  hair.set("bow", static_cast<float>((coat.bend + coat.mess) * nominal_length));
  hair.set("spread", static_cast<float>(coat.colour_spread));
}

}  // namespace

const Program& GuardHairsPass::program_of(const Gl& gl, const std::string& variant) {
  const auto [place, made] = programs_.try_emplace(variant, gl, shaders::hair_vert, shaders::hair_frag, variant);
  if (made) failure_ += place->second.log();
  return place->second;
}

void GuardHairsPass::bind(const Gl& gl, const FurDrawing& drawing) const {
  std::vector<GLuint> order(2 * (hair_segments + 1));
  std::iota(order.begin(), order.end(), 0u);
  gl.NamedBufferData(elements_.id(), static_cast<GLsizeiptr>(order.size() * sizeof(GLuint)), order.data(),
                     GL_STATIC_DRAW);
  gl.VertexArrayElementBuffer(array_.id(), elements_.id());
  gl.BindVertexArray(array_.id());
  drawing.model.bind_storage(gl);
  gl.BindTextureUnit(colours_unit, drawing.coat.colours());
  gl.BindTextureUnit(skin_images_unit, drawing.model.base_images());
}

GuardHairsPass::BoundHairs GuardHairsPass::bind_hairs(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing) {
  if (geometry_.model != frame.model || geometry_.count != frame.knobs.guard_hairs)
    geometry_ = {frame.model, scatter_hairs(mesh_of(drawing.model), frame.knobs.guard_hairs), frame.knobs.guard_hairs};
  const ShownHairs shown = shown_hairs(mesh_of(drawing.model), geometry_.roots, frame.camera.position);
  bind(gl, drawing);
  gl.NamedBufferData(roots_.id(), static_cast<GLsizeiptr>(shown.roots.size() * sizeof(HairRoot)), shown.roots.data(),
                     GL_STREAM_DRAW);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, pass_storage, roots_.id());
  const Program& hair = program_of(gl, drawing.variant);
  hair.use();
  set_hair(hair, frame.coat);
  return {hair, shown.back_facing, shown.roots.size()};
}

void GuardHairsPass::draw(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing) {
  const BoundHairs hairs = bind_hairs(gl, frame, drawing);
  if (frame.knobs.order == FragmentOrder::sorted) {
    draw_unordered(gl, hairs.program, hair_segments, hairs.count);
  } else {
    draw_four_passes(gl, hairs.program, hair_segments, hairs.back_facing, hairs.count);
  }
}

void GuardHairsPass::draw_plain(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing) {
  const BoundHairs hairs = bind_hairs(gl, frame, drawing);
  draw_all_strips(gl, hairs.program, hair_segments, hairs.count);
}

}  // namespace pelage
