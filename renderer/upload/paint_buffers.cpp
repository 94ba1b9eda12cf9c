#include "renderer/upload/paint_buffers.h"

#include "renderer/upload/model_buffers.h"

namespace pelage {

namespace {

constexpr GLuint numbers_slot = 4, colours_slot = 5;  // of the vertex array

struct Pair {
  glm::vec4 first{0}, second{0};
};

float value_of(std::span<const float> field, std::uint32_t vertex, float default_value) {
  return field.empty() ? default_value : field[vertex];
}

Pair numbers_of(const FurPaint& paint, std::uint32_t v) {
  return {{value_of(paint.density, v, 1), value_of(paint.width, v, 1), value_of(paint.wetness, v, 0),
           value_of(paint.bare, v, 0)},
          {value_of(paint.curl, v, 0), value_of(paint.clump, v, 0), 0, 0}};
}

/// So that a colour fades out over an edge without the colour of what is not painted.
glm::vec4 covered(std::span<const glm::vec4> field, std::uint32_t vertex) {
  return field.empty() ? glm::vec4(0) : glm::vec4(glm::vec3(field[vertex]) * field[vertex].a, field[vertex].a);
}

void add_pair(const Gl& gl, GLuint array, GLuint slot, GLuint buffer, Attribute first) {
  gl.VertexArrayVertexBuffer(array, slot, buffer, 0, sizeof(Pair));
  for (GLuint k = 0; k < 2; ++k) {
    const GLuint place = static_cast<GLuint>(first) + k;
    gl.EnableVertexArrayAttrib(array, place);
    gl.VertexArrayAttribFormat(array, place, 4, GL_FLOAT, GL_FALSE, k * static_cast<GLuint>(sizeof(glm::vec4)));
    gl.VertexArrayAttribBinding(array, place, slot);
  }
}

template <class Make>
void send_pairs(const Gl& gl, const Buffer& buffer, std::size_t begin, std::span<const std::uint32_t> welded, Make make,
                UploadCount& count) {
  std::vector<Pair> pairs;
  pairs.reserve(welded.size());
  for (const std::uint32_t vertex : welded) pairs.push_back(make(vertex));
  const std::size_t bytes = pairs.size() * sizeof(Pair);
  gl.NamedBufferSubData(buffer.id(), static_cast<GLintptr>(begin * sizeof(Pair)), static_cast<GLsizeiptr>(bytes),
                        pairs.data());
  count.bytes += bytes;
}

}  // namespace

bool PaintBuffers::prepare(const Gl& gl, const FurPaint& paint, GLuint vertex_array, std::size_t render_vertices) {
  Touched touched;
  touched.fur = !(paint.density.empty() && paint.width.empty() && paint.wetness.empty() && paint.bare.empty() &&
                  paint.curl.empty() && paint.clump.empty());
  touched.colours = !(paint.root_colour.empty() && paint.tip_colour.empty());
  if (touched == touched_) return false;
  const auto bytes = static_cast<GLsizeiptr>(render_vertices * sizeof(Pair));
  if (touched.fur && !touched_.fur) {
    gl.NamedBufferData(numbers_.id(), bytes, nullptr, GL_DYNAMIC_DRAW);
    add_pair(gl, vertex_array, numbers_slot, numbers_.id(), Attribute::painted_numbers);
  }
  if (touched.colours && !touched_.colours) {
    gl.NamedBufferData(colours_.id(), bytes, nullptr, GL_DYNAMIC_DRAW);
    add_pair(gl, vertex_array, colours_slot, colours_.id(), Attribute::painted_colours);
  }
  touched_ = touched;
  return true;
}

void PaintBuffers::send(const Gl& gl, const FurPaint& paint, std::size_t begin, std::span<const std::uint32_t> welded,
                        UploadCount& count) const {
  if (touched_.fur) {
    send_pairs(
        gl, numbers_, begin, welded, [&](std::uint32_t v) { return numbers_of(paint, v); }, count);
  }
  if (!touched_.colours) return;
  const auto colours_of = [&](std::uint32_t v) {
    return Pair{covered(paint.root_colour, v), covered(paint.tip_colour, v)};
  };
  send_pairs(gl, colours_, begin, welded, colours_of, count);
}

std::string PaintBuffers::defines() const {
  return std::string(touched_.fur ? "#define PAINT\n" : "") + (touched_.colours ? "#define PAINT_COLOUR\n" : "");
}

}  // namespace pelage
