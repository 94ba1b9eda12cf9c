#include "renderer/passes/sorted/fragment_lists.h"

#include <algorithm>
#include <cassert>

#include "renderer/shaders/constants.h"

namespace pelage {

std::vector<Area> halves(const Area& area) {
  assert(area.pixels() >= 2);
  Area first = area, second = area;
  if (area.width >= area.height) {
    first.width = area.width / 2;
    second.left += first.width, second.width -= first.width;
  } else {
    first.height = area.height / 2;
    second.top += first.height, second.height -= first.height;
  }
  return {first, second};
}

std::vector<Area> cut(const Area& area, double max) {
  std::vector<Area> done, open{area};
  while (!open.empty()) {
    const Area next = open.back();
    open.pop_back();
    if (next.pixels() <= max || next.pixels() < 2) {
      done.push_back(next);
      continue;
    }
    for (const Area& half : halves(next)) open.push_back(half);
  }
  return done;
}

namespace {

constexpr GLint buffer_count = 3;
constexpr std::size_t colour_bytes = 16, link_bytes = 8;

GLint limit(const Gl& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return value;
}

}  // namespace

bool FragmentLists::possible(const Gl& gl) {
  return limit(gl, GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS) >= buffer_count &&
         limit(gl, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS) >= fragment_lists_storage + buffer_count;
}

FragmentLists::FragmentLists(const Gl& gl, std::size_t bytes) : firsts_(gl), links_(gl), colours_(gl) {
  const auto block = static_cast<std::size_t>(std::max(limit(gl, GL_MAX_SHADER_STORAGE_BLOCK_SIZE), 1));
  constexpr std::size_t max = 1u << 30;  // places must leave the bit that marks a sorted list
  capacity_ = static_cast<std::uint32_t>(
      std::clamp<std::size_t>(std::min(bytes / fragment_bytes, block / colour_bytes), 1, max));
  const auto reserve = [&](const Buffer& buffer, std::size_t size) {
    gl.NamedBufferData(buffer.id(), static_cast<GLsizeiptr>(size), nullptr, GL_STREAM_COPY);
  };
  reserve(links_, capacity_ * link_bytes);
  reserve(colours_, capacity_ * colour_bytes);
  complete_ = gl.GetError() == GL_NO_ERROR;
}

void FragmentLists::begin(const Gl& gl, const Area& area) const {
  assert(area.pixels() <= max_pixels);
  const auto pixels = static_cast<std::size_t>(area.pixels());
  gl.NamedBufferData(firsts_.id(), static_cast<GLsizeiptr>(sizeof(Header) + pixels * sizeof(std::uint32_t)), nullptr,
                     GL_STREAM_COPY);
  gl.ClearNamedBufferData(firsts_.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  const Header header{.capacity = capacity_, .left = area.left, .top = area.top, .width = area.width};
  gl.NamedBufferSubData(firsts_.id(), 0, sizeof(header), &header);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, fragment_lists_storage, firsts_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, fragment_links_storage, links_.id());
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, fragment_colours_storage, colours_.id());
}

FragmentLists::Header FragmentLists::header(const Gl& gl) const {
  Header header;
  gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  gl.GetNamedBufferSubData(firsts_.id(), 0, sizeof(header), &header);
  return header;
}

void FragmentLists::clear_unsorted(const Gl& gl) const {
  const std::uint32_t none = 0;
  gl.NamedBufferSubData(firsts_.id(), offsetof(Header, unsorted), sizeof(none), &none);
}

}  // namespace pelage
