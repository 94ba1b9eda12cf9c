// Fur blended by depth: the areas that a picture is cut into, the fragment lists of their pixels, and the sorting
// pass.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/image/area.h"

namespace pelage {

/// The two halves of an area of at least two pixels, cut across its longer side.
std::vector<Area> halves(const Area& area);

/// Cuts an area in halves until each has at most `max` pixels, or only one. Together they are the area.
std::vector<Area> cut(const Area& area, double max);

// The buffers behind renderer/shaders/fragment_lists.glsl.

class FragmentLists {
 public:
  /// As the shader has it, before the first fragment of each pixel.
  struct Header {
    std::uint32_t count = 0, capacity = 0;
    std::int32_t left = 0, top = 0, width = 0;
    std::uint32_t unsorted = 0, too_long = 0, padding = 0;
  };
  static constexpr std::size_t fragment_bytes = 24;  // colour, depth and link
  static constexpr double max_pixels = 1024 * 1024;  // of an area: 4 MiB beside the fragments

  /// Returns whether fragment shaders of this context can write as many buffers as the lists take.
  static bool possible(const Gl& gl);

  /// Room for as many fragments as fit into `bytes` and into what the GL allows for one buffer; at least 1.
  FragmentLists(const Gl& gl, std::size_t bytes);

  bool complete() const { return complete_; }
  std::uint32_t capacity() const { return capacity_; }
  /// Empties the lists, for the pixels of an area, and binds the buffers.
  void begin(const Gl& gl, const Area& area) const;
  /// Returns the header, once all that was asked for is drawn.
  Header header(const Gl& gl) const;
  void clear_unsorted(const Gl& gl) const;

 private:
  Buffer firsts_, links_, colours_;
  std::uint32_t capacity_ = 0;
  bool complete_ = false;
};

// The converged picture: all fragments of a pixel are kept in a list, sorted by depth and blended in that order.
//
// Lists rather than depth peeling: a pixel of 1,024 shells has over a thousand fragments, and peeling would draw all
// shells again for each of them. The picture is drawn in areas whose fragments fit into a stated memory; an area that
// does not fit is halved and drawn again.

class SortedPass {
 public:
  /// Bytes for the fragments of an area. Small enough that software GL under load draws one within the minute that
  /// wait_for grants; more would save little, as an area costs no more than its triangles again.
  static constexpr std::size_t default_bytes = std::size_t{64} << 20;

  SortedPass(const Gl& gl, std::size_t bytes) : nothing_(gl), bytes_(bytes) {}

  /// "" when the programs were built, or not asked for yet.
  std::string failure() const { return failure_; }

  /// Blends what `draw_fragments` draws over an area of the target, which has one sample and a depth buffer that is
  /// only tested against. It is called once for each area, with the draw state set and no colour written; its programs
  /// include fragment.glsl with SORTED. `expected` fragments for a covered pixel are a first guess: a wrong one costs
  /// time. Fails with invalid, naming the order, when the GL lacks what lists need; with too_large when there is no
  /// memory, or not enough for a single pixel; with unavailable when the GL does not answer.
  Status draw(const Gl& gl, const RenderTarget& target, const Area& within, int expected,
              const std::function<void()>& draw_fragments);

 private:
  void make_programs(const Gl& gl);
  /// How many fragments the area has; they are in the target if there was room for them.
  Result<std::uint32_t> draw_area(const Gl& gl, const FragmentLists& lists, const RenderTarget& target,
                                  const std::function<void()>& draw_fragments) const;
  Status sort(const Gl& gl, const FragmentLists& lists) const;
  void draw_whole(const Gl& gl, const Program& program) const;

  std::optional<Program> merge_, compose_;  // made when first used
  std::optional<FragmentLists> lists_;      // made when first used and kept: new memory costs a software GL 50 ms
  VertexArray nothing_;
  std::size_t bytes_;
  std::string failure_;
};

}  // namespace pelage
