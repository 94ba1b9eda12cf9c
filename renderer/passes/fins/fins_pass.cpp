#include "renderer/passes/fins/fins_pass.h"

#include <algorithm>
#include <numeric>

#include "renderer/coat/side_view.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/passes/draw/strips.h"

namespace pelage {

namespace shaders {
extern const char* const fin_vert;
extern const char* const fin_frag;
extern const char* const hair_vert;
extern const char* const hair_frag;
}  // namespace shaders

namespace {

constexpr int fin_segments = 6, hair_segments = 10;
constexpr int side_view_levels = 8;
constexpr GLuint side_view_unit = 11;  // as fin.frag

StripMesh mesh_of(const ModelBuffers& model) {
  return {model.positions(), model.normals(), model.triangles(), model.welded()};
}

template <class Strip>
void send(const Gl& gl, const Buffer& buffer, const std::vector<Strip>& strips) {
  gl.NamedBufferData(buffer.id(), static_cast<GLsizeiptr>(strips.size() * sizeof(Strip)), strips.data(),
                     GL_STREAM_DRAW);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, buffer.id());
}

}  // namespace

FinsPass::Programs::Programs(const Gl& gl, const std::string& defines)
    : fin(gl, shaders::fin_vert, shaders::fin_frag, defines),
      hair(gl, shaders::hair_vert, shaders::hair_frag, defines) {}

const FinsPass::Programs& FinsPass::programs_of(const Gl& gl, const std::string& variant) {
  const auto [place, made] = programs_.try_emplace(variant, gl, variant);
  if (made) failure_ += place->second.fin.log() + place->second.hair.log();
  return place->second;
}

FinsPass::Geometry& FinsPass::geometry_of(std::uint64_t model) {
  if (geometry_.model != model) geometry_ = {model, {}, {}, 0};
  return geometry_;
}

void FinsPass::send_side_view(const Gl& gl, const Coat& coat) {
  if (side_view_coat_ && same_strands(*side_view_coat_, coat)) return;
  side_view_coat_ = coat;
  const std::vector<glm::vec4> texels = bake_side_view(coat);
  side_view_ = Texture(gl, GLenum{GL_TEXTURE_2D});
  gl.TextureStorage2D(side_view_.id(), side_view_levels, GL_RGBA16F, side_view_width, side_view_height);
  gl.TextureSubImage2D(side_view_.id(), 0, 0, 0, side_view_width, side_view_height, GL_RGBA, GL_FLOAT, texels.data());
  gl.GenerateTextureMipmap(side_view_.id());
  gl.TextureParameteri(side_view_.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TextureParameteri(side_view_.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TextureParameteri(side_view_.id(), GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl.TextureParameteri(side_view_.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void FinsPass::bind(const Gl& gl, const FurDrawing& drawing) const {
  std::vector<GLuint> order(2 * (std::max(fin_segments, hair_segments) + 1));
  std::iota(order.begin(), order.end(), 0u);
  gl.NamedBufferData(elements_.id(), static_cast<GLsizeiptr>(order.size() * sizeof(GLuint)), order.data(),
                     GL_STATIC_DRAW);
  gl.VertexArrayElementBuffer(array_.id(), elements_.id());
  gl.BindVertexArray(array_.id());
  drawing.model.bind_storage(gl);
  gl.BindTextureUnit(1, drawing.coat.colours());
  gl.BindTextureUnit(2, drawing.model.base_images());
}

void FinsPass::draw_fins(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing, const DepthRange& range) {
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  draw_plain_fins(gl, frame, drawing, range);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
}

void FinsPass::draw_plain_fins(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing, const DepthRange& range) {
  Geometry& geometry = geometry_of(frame.model);
  if (!geometry.edges) geometry.edges = list_edges(mesh_of(drawing.model));
  std::vector<FinEdge> shown = shown_fins(mesh_of(drawing.model), *geometry.edges, frame.camera.eye).strips;
  std::erase_if(shown, [&](const FinEdge& edge) {
    const std::span<const glm::vec3> places = drawing.model.positions();
    const glm::vec3 middle = 0.5f * (places[edge.ends.x] + places[edge.ends.y]);
    return !range.holds(glm::dot(middle - frame.camera.eye, frame.camera.forward));
  });
  if (shown.empty()) return;
  send_side_view(gl, frame.coat);
  bind(gl, drawing);
  send(gl, strips_, shown);
  gl.BindTextureUnit(side_view_unit, side_view_.id());
  const Program& fin = programs_of(gl, drawing.variant).fin;
  fin.use();
  fin.set("segments", fin_segments);
  fin.set("limit", fin_limit);
  fin.set("slab_depth", static_cast<float>(side_view_depth * frame.coat.tile));
  draw_strips(gl, fin_segments, shown.size());
}

void FinsPass::set_hair(const Program& hair, const Coat& coat) const {
  hair.set("segments", hair_segments);
  hair.set("limit", hair_limit);
  hair.set("width_root", static_cast<float>(coat.width_root));
  hair.set("width_tip", static_cast<float>(coat.width_tip));
  hair.set("bow", static_cast<float>((coat.bend + coat.mess) * nominal_length));
  hair.set("spread", static_cast<float>(coat.colour_spread));
}

FinsPass::BoundHairs FinsPass::bind_hairs(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing) {
  Geometry& geometry = geometry_of(frame.model);
  if (geometry.hair_count != frame.knobs.guard_hairs) {
    geometry.hair_count = frame.knobs.guard_hairs;
    geometry.roots = scatter_hairs(mesh_of(drawing.model), geometry.hair_count);
  }
  const ShownStrips<HairRoot> shown = shown_hairs(mesh_of(drawing.model), geometry.roots, frame.camera.eye);
  bind(gl, drawing);
  send(gl, strips_, shown.strips);
  const Program& hair = programs_of(gl, drawing.variant).hair;
  hair.use();
  set_hair(hair, frame.coat);
  return {hair, shown.averted, shown.strips.size()};
}

void FinsPass::draw_hairs(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing) {
  const BoundHairs hairs = bind_hairs(gl, frame, drawing);
  if (frame.knobs.order == FragmentOrder::sorted) {
    draw_unordered(gl, hairs.program, hair_segments, hairs.count);
  } else {
    draw_four_passes(gl, hairs.program, hair_segments, hairs.averted, hairs.count);
  }
}

void FinsPass::draw_plain_hairs(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing) {
  const BoundHairs hairs = bind_hairs(gl, frame, drawing);
  draw_all_strips(gl, hairs.program, hair_segments, hairs.count);
}

}  // namespace pelage
