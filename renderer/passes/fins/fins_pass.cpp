#include "renderer/passes/fins/fins_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "protocol/base/random.h"
#include "renderer/coat/side_view.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/passes/draw/draw.h"
#include "renderer/shaders/constants.h"

namespace pelage {

namespace {

constexpr std::uint64_t hair_seed = 0x6861697273;

float area_of(const StripMesh& mesh, glm::uvec3 t) {
  const glm::vec3 a = mesh.positions[t.x];
  return 0.5f * glm::length(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a));
}

std::array<std::uint32_t, 3> welded_corners(const StripMesh& mesh, glm::uvec3 t) {
  return {mesh.welded[t.x], mesh.welded[t.y], mesh.welded[t.z]};
}

/// An edge as one of its triangles has it.
struct HalfEdge {
  std::uint32_t low, high;  // of the model
  glm::uvec2 ends;          // render vertices
  float area;               // of the triangle
};

/// Cosine of the angle between the fur and the way to the eye, and the distance.
struct Facing {
  float cosine, distance;
};
Facing facing(glm::vec3 place, glm::vec3 normal, glm::vec3 viewpoint) {
  const glm::vec3 to_camera = viewpoint - place;
  const float distance = glm::length(to_camera);
  return {glm::dot(to_camera, normal) / std::max(distance * glm::length(normal), 1e-20f), distance};
}

template <class Strip, class FacingOf>
ShownStrips<Strip> choose(std::span<const Strip> all, float limit, const FacingOf& facing_of) {
  std::vector<std::pair<Facing, Strip>> chosen;
  for (const Strip& strip : all) {
    const Facing facing = facing_of(strip);
    if (std::abs(facing.cosine) < limit) chosen.emplace_back(facing, strip);
  }
  const auto behind = [](const auto& a, const auto& b) {
    const bool a_back_facing = a.first.cosine < 0, b_back_facing = b.first.cosine < 0;
    return a_back_facing != b_back_facing ? a_back_facing : a.first.distance > b.first.distance;
  };
  std::stable_sort(chosen.begin(), chosen.end(), behind);
  ShownStrips<Strip> shown;
  for (const auto& [facing, strip] : chosen) {
    shown.back_facing += facing.cosine < 0;
    shown.strips.push_back(strip);
  }
  return shown;
}

}  // namespace

std::vector<glm::uvec3> surface_triangles(const StripMesh& mesh) {
  std::vector<std::size_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return welded_corners(mesh, mesh.triangles[i]); };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  order.erase(std::unique(order.begin(), order.end(), [&](auto a, auto b) { return key(a) == key(b); }), order.end());
  std::vector<glm::uvec3> triangles;
  for (const std::size_t i : order) triangles.push_back(mesh.triangles[i]);
  return triangles;
}

std::vector<FinEdge> list_edges(const StripMesh& mesh) {
  std::vector<HalfEdge> halves;
  for (const glm::uvec3& t : surface_triangles(mesh)) {
    for (int k = 0; k < 3; ++k) {
      glm::uvec2 ends(t[k], t[(k + 1) % 3]);
      if (mesh.welded[ends.x] > mesh.welded[ends.y]) std::swap(ends.x, ends.y);
      halves.push_back({mesh.welded[ends.x], mesh.welded[ends.y], ends, area_of(mesh, t)});
    }
  }
  const auto key = [](const HalfEdge& half) { return std::pair(half.low, half.high); };
  std::stable_sort(halves.begin(), halves.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  std::vector<FinEdge> edges;
  for (std::size_t i = 0; i < halves.size();) {
    const HalfEdge& first = halves[i];
    float area = 0;
    for (; i < halves.size() && key(halves[i]) == key(first); ++i) area += halves[i].area;
    const float length = glm::distance(mesh.positions[first.ends.x], mesh.positions[first.ends.y]);
    // Half of both triangles' heights. Edges run three ways, and from any side about two of them show: half of that.
    if (length > 0) edges.push_back({first.ends, 0.5f * area / length});
  }
  return edges;
}

std::vector<HairRoot> scatter_hairs(const StripMesh& mesh, int count) {
  const std::vector<glm::uvec3> triangles = surface_triangles(mesh);
  std::vector<double> sums;
  double area = 0;
  for (const glm::uvec3& t : triangles) sums.push_back(area += area_of(mesh, t));
  std::vector<HairRoot> roots;
  if (!(area > 0)) return roots;
  Random random(hair_seed);
  for (int i = 0; i < count; ++i) {
    const double at = (i + random.uniform()) / count * area;  // one in each equal part of the area
    const auto found = std::min<std::size_t>(
        static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end(), at) - sums.begin()), sums.size() - 1);
    const double root = std::sqrt(random.uniform()), share = random.uniform();  // uniform on a triangle
    const glm::vec3 weights(1 - root, root * (1 - share), root * share);
    roots.push_back({triangles[found], static_cast<std::uint32_t>(random.uniform() * 4294967296.0), weights});
  }
  return roots;
}

ShownStrips<FinEdge> shown_fins(const StripMesh& mesh, std::span<const FinEdge> edges, glm::vec3 viewpoint) {
  return choose(edges, fin_limit, [&](const FinEdge& edge) {
    const Facing a = facing(mesh.positions[edge.ends.x], mesh.normals[edge.ends.x], viewpoint);
    const Facing b = facing(mesh.positions[edge.ends.y], mesh.normals[edge.ends.y], viewpoint);
    return std::abs(a.cosine) < std::abs(b.cosine) ? a : b;  // one end in the band is enough
  });
}

ShownStrips<HairRoot> shown_hairs(const StripMesh& mesh, std::span<const HairRoot> roots, glm::vec3 viewpoint) {
  return choose(roots, hair_limit, [&](const HairRoot& root) {
    glm::vec3 place(0), normal(0);
    for (int k = 0; k < 3; ++k) {
      place += root.weights[k] * mesh.positions[root.corners[k]];
      normal += root.weights[k] * mesh.normals[root.corners[k]];
    }
    return facing(place, normal, viewpoint);
  });
}

namespace shaders {
extern const char* const fin_vert;
extern const char* const fin_frag;
extern const char* const hair_vert;
extern const char* const hair_frag;
}  // namespace shaders

namespace {

constexpr int fin_segments = 6, hair_segments = 10;
constexpr int side_view_levels = 8;

StripMesh mesh_of(const ModelBuffers& model) {
  return {model.positions(), model.normals(), model.triangles(), model.welded()};
}

template <class Strip>
void send(const Gl& gl, const Buffer& buffer, const std::vector<Strip>& strips) {
  gl.NamedBufferData(buffer.id(), static_cast<GLsizeiptr>(strips.size() * sizeof(Strip)), strips.data(),
                     GL_STREAM_DRAW);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, pass_storage, buffer.id());
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
  gl.BindTextureUnit(colours_unit, drawing.coat.colours());
  gl.BindTextureUnit(skin_images_unit, drawing.model.base_images());
}

void FinsPass::draw_fins(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing, const DepthRange& range) {
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  draw_plain_fins(gl, frame, drawing, range);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
}

void FinsPass::draw_plain_fins(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing,
                               const DepthRange& range) {
  Geometry& geometry = geometry_of(frame.model);
  if (!geometry.edges) geometry.edges = list_edges(mesh_of(drawing.model));
  std::vector<FinEdge> shown = shown_fins(mesh_of(drawing.model), *geometry.edges, frame.camera.position).strips;
  std::erase_if(shown, [&](const FinEdge& edge) {
    const std::span<const glm::vec3> places = drawing.model.positions();
    const glm::vec3 middle = 0.5f * (places[edge.ends.x] + places[edge.ends.y]);
    return !range.holds(glm::dot(middle - frame.camera.position, frame.camera.forward));
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
  const ShownStrips<HairRoot> shown = shown_hairs(mesh_of(drawing.model), geometry.roots, frame.camera.position);
  bind(gl, drawing);
  send(gl, strips_, shown.strips);
  const Program& hair = programs_of(gl, drawing.variant).hair;
  hair.use();
  set_hair(hair, frame.coat);
  return {hair, shown.back_facing, shown.strips.size()};
}

void FinsPass::draw_hairs(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing) {
  const BoundHairs hairs = bind_hairs(gl, frame, drawing);
  if (frame.knobs.order == FragmentOrder::sorted) {
    draw_unordered(gl, hairs.program, hair_segments, hairs.count);
  } else {
    draw_four_passes(gl, hairs.program, hair_segments, hairs.back_facing, hairs.count);
  }
}

void FinsPass::draw_plain_hairs(const Gl& gl, const FurFrame& frame, const FurDrawing& drawing) {
  const BoundHairs hairs = bind_hairs(gl, frame, drawing);
  draw_all_strips(gl, hairs.program, hair_segments, hairs.count);
}

}  // namespace pelage
