#include "renderer/shells/sorted/sorted_pass.h"

#include <algorithm>
#include <cassert>

#include "renderer/gl/sync.h"
#include "renderer/shaders/constants.h"
#include "renderer/shells/draw/draw.h"

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
  std::vector<Area> done, pending{area};
  while (!pending.empty()) {
    const Area next = pending.back();
    pending.pop_back();
    if (next.pixels() <= max || next.pixels() < 2) {
      done.push_back(next);
      continue;
    }
    for (const Area& half : halves(next)) pending.push_back(half);
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
  constexpr std::size_t max = 1u << 30;  // indices must leave the bit that marks a sorted list (in_order)
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

namespace shaders {
extern const char* const whole_target_vert;
extern const char* const merge_frag;
extern const char* const compose_frag;
}  // namespace shaders

namespace {

constexpr int max_rounds = 32;          // each halves the number of runs
constexpr double guessed_cover = 0.25;  // share of a picture's pixels that fur covers
constexpr double cautious = 0.8;        // share of the room that the parts of a cut area should use

Status impossible() {
  return failure(Code::invalid, "this server's GL cannot keep lists of fragments", "/quality/order", "shells");
}

Status too_large(const char* why) { return failure(Code::too_large, why, "/quality/order"); }

Status wrong() { return failure(Code::internal, "the GL does not sort as it should"); }

Status no_memory() { return too_large("no memory for the fragments of a sorted frame"); }

void set_colour_writes(const Gl& gl, GLboolean on) { gl.ColorMask(on, on, on, on); }

}  // namespace

void SortedPass::make_programs(const Gl& gl) {
  if (merge_) return;
  merge_.emplace(gl, shaders::whole_target_vert, shaders::merge_frag);
  compose_.emplace(gl, shaders::whole_target_vert, shaders::compose_frag);
  failure_ = merge_->log() + compose_->log();
}

Status SortedPass::draw(const Gl& gl, const RenderTarget& target, const Area& within, int expected,
                        const std::function<void()>& draw_fragments) {
  if (!FragmentLists::possible(gl)) return impossible();
  make_programs(gl);
  if (!lists_) lists_.emplace(gl, bytes_);
  if (!lists_->complete()) return lists_.reset(), no_memory();
  const FragmentLists& lists = *lists_;
  const double fitting = lists.capacity() / (guessed_cover * std::max(expected, 1));
  std::vector<Area> areas = cut(within, std::min(fitting, FragmentLists::max_pixels));
  Status status;
  gl.Enable(GL_SCISSOR_TEST);
  while (!areas.empty() && status.ok()) {
    const Area area = areas.back();
    areas.pop_back();
    lists.begin(gl, area);
    gl.Scissor(area.left, area.top, area.width, area.height);
    const Result<std::uint32_t> count = draw_area(gl, lists, target, draw_fragments);
    if (!count) {
      status = count.status();
    } else if (*count > lists.capacity() && area.pixels() < 2) {
      status = no_memory();
    } else if (*count > lists.capacity()) {
      const double share = std::min(0.5, cautious * lists.capacity() / *count);
      for (const Area& part : cut(area, std::max(1.0, share * area.pixels()))) areas.push_back(part);
    }
  }
  gl.Disable(GL_SCISSOR_TEST);
  return status;
}

Result<std::uint32_t> SortedPass::draw_area(const Gl& gl, const FragmentLists& lists, const RenderTarget& target,
                                            const std::function<void()>& draw_fragments) const {
  set_draw_state(gl, target);
  set_colour_writes(gl, GL_FALSE);
  gl.DepthMask(GL_FALSE);
  draw_fragments();
  set_colour_writes(gl, GL_FALSE);
  gl.Disable(GL_DEPTH_TEST);
  gl.DepthMask(GL_FALSE);
  Status status = wait_for(gl);
  const std::uint32_t count = status.ok() ? lists.header(gl).count : 0;
  const bool fitted = status.ok() && count <= lists.capacity();
  if (fitted) status = sort(gl, lists);
  set_colour_writes(gl, GL_TRUE);
  if (fitted && status.ok()) {
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw_fullscreen(gl, *compose_);
    gl.Disable(GL_BLEND);
  }
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthMask(GL_TRUE);
  if (!status.ok()) return status;
  return count;
}

Status SortedPass::sort(const Gl& gl, const FragmentLists& lists) const {
  for (int round = 0; round < max_rounds; ++round) {
    lists.clear_unsorted(gl);
    draw_fullscreen(gl, *merge_);
    if (const Status answer = wait_for(gl); !answer.ok()) return answer;
    const FragmentLists::Header header = lists.header(gl);
    if (header.too_long) return too_large("a pixel has too many fragments to sort");
    if (!header.unsorted) return {};
  }
  return wrong();
}

void SortedPass::draw_fullscreen(const Gl& gl, const Program& program) const {
  gl.BindVertexArray(empty_vertex_array_.id());
  program.use();
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace pelage
