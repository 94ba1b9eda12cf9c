#include "renderer/upload/model_buffers.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numeric>
#include <utility>

#include "renderer/shaders/constants.h"
#include "renderer/skin/fur_vertex.h"

namespace pelage {

namespace {

/// The layout of a vertex in its buffer.
struct RenderVertex {
  glm::vec3 position, normal, tangent;
  glm::vec2 tile_uv;
  glm::vec3 tile_axis, image_uv, colour;
  float weight;
  glm::vec3 shading_normal;  // for shading the surface; fur grows along `normal`
};

}  // namespace

/// A model for the GPU: its vertices, split where the corners of its triangles differ.
struct SplitModel {
  std::vector<RenderVertex> vertices;
  std::vector<glm::uvec3> triangles;  // indices of render vertices
  std::vector<std::uint32_t> welded;  // the model's vertex of each render vertex, rising
  std::vector<std::uint32_t> first;   // for each vertex of the model, its first render vertex; one more at the end
};

namespace {

bool same_look(const FurCorner& a, const FurCorner& b) {
  return a.tile_uv == b.tile_uv && a.tile_axis == b.tile_axis && a.image_uv == b.image_uv && a.colour == b.colour &&
         a.image == b.image && a.weight == b.weight && a.normal == b.normal;
}

RenderVertex make_vertex(const FurModel& model, std::uint32_t vertex, const FurCorner& corner) {
  return {model.positions[vertex],
          model.normals[vertex],
          model.tangents[vertex],
          corner.tile_uv,
          corner.tile_axis,
          {corner.image_uv, static_cast<float>(corner.image)},
          corner.colour,
          corner.weight,
          corner.normal == glm::vec3(0) ? model.normals[vertex] : corner.normal};
}

SplitModel split_corners(const FurModel& model) {
  SplitModel split;
  const std::size_t corners = 3 * model.triangles.size();
  const auto vertex_of = [&](std::uint32_t c) { return model.triangles[c / 3][static_cast<int>(c % 3)]; };
  const auto corner_of = [&](std::uint32_t c) -> const FurCorner& { return model.corners[c / 3][c % 3]; };
  std::vector<std::uint32_t> order(corners);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return vertex_of(a) < vertex_of(b); });

  split.triangles.resize(model.triangles.size());
  split.first.assign(model.positions.size() + 1, 0);
  std::vector<std::uint32_t> chosen;  // the corner that made each render vertex
  for (std::size_t i = 0; i < corners;) {
    const std::uint32_t vertex = vertex_of(order[i]);
    const std::size_t begin = chosen.size();
    for (; i < corners && vertex_of(order[i]) == vertex; ++i) {
      const auto same = std::find_if(chosen.begin() + static_cast<std::ptrdiff_t>(begin), chosen.end(),
                                     [&](auto c) { return same_look(corner_of(c), corner_of(order[i])); });
      const auto index = static_cast<std::uint32_t>(same - chosen.begin());
      if (same == chosen.end()) chosen.push_back(order[i]), split.welded.push_back(vertex);
      split.triangles[order[i] / 3][static_cast<int>(order[i] % 3)] = index;
    }
    split.first[vertex + 1] = static_cast<std::uint32_t>(chosen.size() - begin);
  }
  std::partial_sum(split.first.begin(), split.first.end(), split.first.begin());

  split.vertices.reserve(chosen.size());
  for (const std::uint32_t c : chosen) split.vertices.push_back(make_vertex(model, vertex_of(c), corner_of(c)));
  return split;
}

/// Returns the value of each render vertex's vertex (SplitModel::welded); empty if `values` is.
std::vector<glm::vec3> by_vertex(std::span<const glm::vec3> values, std::span<const std::uint32_t> welded) {
  std::vector<glm::vec3> result;
  result.reserve(values.empty() ? 0 : welded.size());
  for (std::size_t i = 0; i < welded.size() && !values.empty(); ++i) result.push_back(values[welded[i]]);
  return result;
}

GLuint location_of(Attribute attribute) { return static_cast<GLuint>(attribute); }

/// Returns the image at another size, by nearest texels.
std::vector<std::uint8_t> resized(const ImageView& image, int width, int height) {
  if (image.width == width && image.height == height) return {image.rgba.begin(), image.rgba.end()};
  std::vector<std::uint8_t> result(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int from = (y * image.height / height) * image.width + x * image.width / width;
      std::memcpy(&result[4 * static_cast<std::size_t>(y * width + x)], &image.rgba[4 * static_cast<std::size_t>(from)],
                  4);
    }
  }
  return result;
}

constexpr std::uint32_t sent_gap = 64;  // ranges with a smaller gap, in vertices, are uploaded together

std::vector<DirtyRange> sent_as_one(std::span<const DirtyRange> dirty) {
  std::vector<DirtyRange> joined;
  for (const DirtyRange& range : dirty) {
    const bool near =
        !joined.empty() && range.begin >= joined.back().begin && range.begin < joined.back().end + sent_gap;
    if (near)
      joined.back().end = std::max(joined.back().end, range.end);
    else
      joined.push_back(range);
  }
  return joined;
}

}  // namespace

ModelBuffers::ModelBuffers(const Gl& gl, const FurModel& model, const FurFields& fields, UploadCount& count)
    : vertex_array_(gl),
      fixed_(gl),
      fur_(gl),
      lod_(gl),
      variation_(gl),
      elements_(gl),
      original_(model.original ? model.original : model.id),
      has_colours_(model.has_colours) {
  SplitModel split = split_corners(model);
  const auto bytes = split.vertices.size() * sizeof(RenderVertex);
  gl.NamedBufferData(fixed_.id(), static_cast<GLsizeiptr>(bytes), split.vertices.data(), GL_STATIC_DRAW);
  gl.NamedBufferData(fur_.id(), static_cast<GLsizeiptr>(split.vertices.size() * sizeof(FurVertex)), nullptr,
                     GL_DYNAMIC_DRAW);
  keep(model, std::move(split));
  count.bytes += bytes;
  const DirtyRange all{0, static_cast<std::uint32_t>(model.positions.size())};
  update(gl, {fields.direction, fields.length, {&all, 1}, fields.skin, fields.paint}, count);
  make_vertex_array(gl);
  send_images(gl, model, count);
}

void ModelBuffers::keep(const FurModel& model, SplitModel split) {
  triangles_ = std::move(split.triangles), welded_ = std::move(split.welded), first_ = std::move(split.first);
  const std::vector<RenderVertex>& vertices = split.vertices;
  positions_.reserve(vertices.size()), normals_.reserve(vertices.size());
  for (const RenderVertex& vertex : vertices) {
    positions_.push_back(vertex.position), normals_.push_back(vertex.normal);
  }
  rest_positions_ = by_vertex(model.rest_positions, welded_), rest_normals_ = by_vertex(model.rest_normals, welded_);
  lengths_.resize(vertices.size()), lods_.resize(vertices.size());
  curvatures_ = curvatures(positions_, normals_, triangles_);
  centroids_.reserve(model.triangles.size()), face_normals_.reserve(model.triangles.size());
  for (const glm::uvec3& t : triangles_) {
    const RenderVertex &a = vertices[t.x], &b = vertices[t.y], &c = vertices[t.z];
    centroids_.push_back((a.position + b.position + c.position) / 3.0f);
    face_normals_.push_back(a.shading_normal + b.shading_normal + c.shading_normal);
  }
}

void ModelBuffers::make_vertex_array(const Gl& gl) {
  const GLuint id = vertex_array_.id();
  gl.VertexArrayVertexBuffer(id, 0, fixed_.id(), 0, sizeof(RenderVertex));
  gl.VertexArrayVertexBuffer(id, 1, fur_.id(), 0, sizeof(FurVertex));
  gl.VertexArrayVertexBuffer(id, 2, lod_.id(), 0, sizeof(float));
  gl.VertexArrayVertexBuffer(id, 3, variation_.id(), 0, sizeof(glm::vec4));
  gl.VertexArrayElementBuffer(id, elements_.id());
  const auto add = [&](Attribute attribute, GLint size, std::size_t offset, GLuint buffer) {
    gl.EnableVertexArrayAttrib(id, location_of(attribute));
    gl.VertexArrayAttribFormat(id, location_of(attribute), size, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    gl.VertexArrayAttribBinding(id, location_of(attribute), buffer);
  };
  add(Attribute::position, 3, offsetof(RenderVertex, position), 0);
  add(Attribute::normal, 3, offsetof(RenderVertex, normal), 0);
  add(Attribute::tangent, 3, offsetof(RenderVertex, tangent), 0);
  add(Attribute::tile_uv, 2, offsetof(RenderVertex, tile_uv), 0);
  add(Attribute::tile_axis, 3, offsetof(RenderVertex, tile_axis), 0);
  add(Attribute::image_uv, 3, offsetof(RenderVertex, image_uv), 0);
  add(Attribute::colour, 3, offsetof(RenderVertex, colour), 0);
  add(Attribute::weight, 1, offsetof(RenderVertex, weight), 0);
  add(Attribute::shading_normal, 3, offsetof(RenderVertex, shading_normal), 0);
  add(Attribute::groom, 3, offsetof(FurVertex, direction), 1);  // and the length after it
  add(Attribute::amounts, 4, offsetof(FurVertex, density), 1);  // density, width, wetness, bare
  add(Attribute::forms, 2, offsetof(FurVertex, curl), 1);       // curl, clump
  add(Attribute::root_paint, 4, offsetof(FurVertex, root_paint), 1);
  add(Attribute::tip_paint, 4, offsetof(FurVertex, tip_paint), 1);
  add(Attribute::shell_lod, 1, 0, 2);
  add(Attribute::variation, 4, 0, 3);
}

void ModelBuffers::send_images(const Gl& gl, const FurModel& model, UploadCount& count) {
  int width = 1, height = 1;
  for (const ImageView& image : model.images)
    width = std::max(width, image.width), height = std::max(height, image.height);
  width = std::min(width, 4096), height = std::min(height, 4096);
  const auto image_count = static_cast<GLsizei>(std::max<std::size_t>(1, model.images.size()));
  const int levels = model.images.empty() ? 1 : 1 + static_cast<int>(std::floor(std::log2(std::max(width, height))));
  images_ = Texture(gl, GLenum{GL_TEXTURE_2D_ARRAY});
  gl.TextureStorage3D(images_.id(), levels, GL_SRGB8_ALPHA8, width, height, image_count);
  for (std::size_t i = 0; i < model.images.size(); ++i) {
    const std::vector<std::uint8_t> pixels = resized(model.images[i], width, height);
    gl.TextureSubImage3D(images_.id(), 0, 0, 0, static_cast<GLint>(i), width, height, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                         pixels.data());
    count.bytes += pixels.size();
  }
  if (!model.images.empty()) gl.GenerateTextureMipmap(images_.id());
  gl.TextureParameteri(images_.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  gl.TextureParameteri(images_.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

std::size_t ModelBuffers::bytes(const Gl& gl) const {
  std::size_t bytes = sizeof(ModelBuffers) + gl.bytes_of_texture(images_.id());
  for (const Buffer* buffer : {&fixed_, &fur_, &lod_, &variation_, &elements_})
    bytes += gl.bytes_of_buffer(buffer->id());
  const auto add = [&](const auto&... arrays) { ((bytes += arrays.capacity() * sizeof(arrays[0])), ...); };
  add(welded_, first_, triangles_, centroids_, face_normals_, positions_, normals_, rest_positions_, rest_normals_,
      lengths_, skin_, curvatures_, lods_);
  return bytes;
}

float ModelBuffers::longest_fur() const {
  return lengths_.empty() ? 0 : *std::max_element(lengths_.begin(), lengths_.end());
}

namespace {

ModelBuffers::Painted painted_in(const FurPaint& paint) {
  const bool fur = !(paint.density.empty() && paint.width.empty() && paint.wetness.empty() && paint.bare.empty() &&
                     paint.curl.empty() && paint.clump.empty());
  return {fur, !(paint.root_colour.empty() && paint.tip_colour.empty())};
}

}  // namespace

std::string ModelBuffers::paint_defines() const {
  return std::string(painted_.fur ? "#define PAINT\n" : "") + (painted_.colours ? "#define PAINT_COLOUR\n" : "");
}

void ModelBuffers::update(const Gl& gl, const FurFields& fields, UploadCount& count) {
  const DirtyRange all{0, static_cast<std::uint32_t>(first_.size() - 1)};
  const Painted painted = painted_in(fields.paint);
  const bool same_skin = std::equal(fields.skin.begin(), fields.skin.end(), skin_.begin(), skin_.end());
  const std::span<const DirtyRange> dirty =
      painted == painted_ && same_skin && fields.coat == coat_ ? fields.dirty : std::span(&all, 1);
  coat_ = fields.coat, painted_ = painted, skin_.assign(fields.skin.begin(), fields.skin.end());
  if (!dirty.empty()) ++version_;
  for (const DirtyRange& range : sent_as_one(dirty)) send_fur(gl, fields, range, count);
}

void ModelBuffers::send_fur(const Gl& gl, const FurFields& fields, const DirtyRange& range, UploadCount& count) {
  const std::uint32_t begin = first_[range.begin], end = first_[range.end];
  if (begin == end) return;
  std::vector<FurVertex> fur;
  fur.reserve(end - begin);
  for (std::uint32_t i = begin; i < end; ++i) {
    fur.push_back(fur_vertex(fields, welded_[i], positions_[i], normals_[i]));
    lengths_[i] = fur.back().length;
  }
  const std::size_t bytes = fur.size() * sizeof(FurVertex);
  gl.NamedBufferSubData(fur_.id(), static_cast<GLintptr>(begin * sizeof(FurVertex)), static_cast<GLsizeiptr>(bytes),
                        fur.data());
  count.bytes += bytes;
}

void ModelBuffers::send_variation(const Gl& gl, std::span<const glm::vec4> values) {
  assert(values.size() == positions_.size());
  gl.NamedBufferData(variation_.id(), static_cast<GLsizeiptr>(values.size_bytes()), values.data(), GL_STATIC_DRAW);
}

namespace {

ModelBuffers::DrawList append(const std::vector<glm::uvec3>& triangles, std::vector<glm::uvec3>& elements) {
  const ModelBuffers::DrawList list{static_cast<GLsizei>(3 * elements.size()),
                                    static_cast<GLsizei>(3 * triangles.size())};
  elements.insert(elements.end(), triangles.begin(), triangles.end());
  return list;
}

}  // namespace

ModelBuffers::DrawLists ModelBuffers::lists_for(const Gl& gl, const ShellView& view) {
  for (std::size_t i = 0; i < lods_.size(); ++i)
    lods_[i] = shell_lod(view, {positions_[i], normals_[i], lengths_[i], curvatures_[i]});
  gl.NamedBufferData(lod_.id(), static_cast<GLsizeiptr>(lods_.size() * sizeof(float)), lods_.data(), GL_STREAM_DRAW);
  const ShellLists sorted = sort_triangles({triangles_, centroids_, face_normals_, positions_, lods_}, view);
  const int highest = max_lod(view.shells, view.policy);
  std::vector<glm::uvec3> elements;
  DrawLists lists;
  lists.all = append(triangles_, elements);
  const auto shells_of = [&](const ShellLists::OfLods& of_lods) {
    std::array<DrawList, max_shell_lod + 1> sent;
    for (std::size_t lod = 0; lod < sent.size(); ++lod) sent[lod] = append(of_lods[lod], elements);
    std::vector<std::pair<int, DrawList>> shells;
    for (int shell = 0; shell < view.shells; ++shell)
      shells.emplace_back(shell, sent[static_cast<std::size_t>(std::min(gone_from(shell) - 1, highest))]);
    return shells;
  };
  lists.back_facing = shells_of(sorted.back_facing), lists.facing = shells_of(sorted.facing);
  std::reverse(lists.back_facing.begin(), lists.back_facing.end());
  std::vector<glm::uvec3> visible = sorted.facing[static_cast<std::size_t>(highest)];
  const std::vector<glm::uvec3>& behind = sorted.back_facing[static_cast<std::size_t>(highest)];
  visible.insert(visible.end(), behind.begin(), behind.end());
  lists.visible = append(visible, elements);
  gl.NamedBufferData(elements_.id(), static_cast<GLsizeiptr>(elements.size() * sizeof(glm::uvec3)), elements.data(),
                     GL_STREAM_DRAW);
  return lists;
}

}  // namespace pelage
