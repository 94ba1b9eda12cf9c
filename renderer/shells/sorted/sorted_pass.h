// Blends fur in the order of depth: cuts a picture into areas, and keeps and sorts a list of fragments for each pixel
// of an area.
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

/// Returns the two halves of an area of at least two pixels, cut across its longer side.
std::vector<Area> halves(const Area& area);

/// Cuts an area in halves until each part has at most `max` pixels, or only one.
std::vector<Area> cut(const Area& area, double max);

// The buffers behind renderer/shaders/fragment_lists.glsl.

class FragmentLists {
 public:
  /// FragmentLists of fragment_lists.glsl, which describes the members, up to the first fragment of each pixel.
  struct Header {
    std::uint32_t count = 0, capacity = 0;
    std::int32_t left = 0, top = 0, width = 0;
    std::uint32_t unsorted = 0, too_long = 0, padding = 0;
  };
  static constexpr std::size_t fragment_bytes = 24;  // colour, depth and link
  static constexpr double max_pixels = 1024 * 1024;  // pixels of an area: 4 MiB beside the fragments

  /// Returns whether fragment shaders of this GL can write as many buffers as the lists need.
  static bool possible(const Gl& gl);

  /// Makes room for as many fragments as fit into `bytes` and into the largest buffer of the GL; at least 1.
  FragmentLists(const Gl& gl, std::size_t bytes);

  /// Returns whether there was memory for the buffers.
  bool complete() const { return complete_; }
  std::uint32_t capacity() const { return capacity_; }
  /// Makes empty lists for the pixels of an area, and binds the buffers.
  void begin(const Gl& gl, const Area& area) const;
  /// Returns the header; waits for the GL to finish drawing.
  Header header(const Gl& gl) const;
  void clear_unsorted(const Gl& gl) const;

 private:
  Buffer firsts_, links_, colours_;
  std::uint32_t capacity_ = 0;
  bool complete_ = false;
};

// The reference for unsorted shells: all fragments of a pixel are kept in a list, sorted by depth and blended in order.
//
// It uses lists instead of depth peeling: a pixel of 1,024 shells has over a thousand fragments, and peeling would draw
// all shells again for each of them. The picture is drawn in areas whose fragments fit into the given memory; an area
// that does not fit is cut and drawn again.

class SortedPass {
 public:
  /// Default bytes for the fragments of an area: so few that a software GL under load draws an area within the minute
  /// that wait_for allows. More would save little: another area only costs drawing the triangles again.
  static constexpr std::size_t default_bytes = std::size_t{64} << 20;

  SortedPass(const Gl& gl, std::size_t bytes) : empty_vertex_array_(gl), bytes_(bytes) {}

  /// Returns why programs could not be built; "" if they were, or are not needed yet.
  std::string failure() const { return failure_; }

  /// Blends what `draw_fragments` draws over the area `within` of the target, whose depth buffer is tested but not
  /// written. `draw_fragments` is called for each area, with the draw state set and colour writes off; its programs
  /// include fragment.glsl with SORTED. `expected` is a first guess of the fragments in a covered pixel; a wrong one
  /// only costs time. Fails with invalid, with a pointer to the order, if the GL lacks what lists need; with too_large
  /// if there is no memory, or not enough for a single pixel; with unavailable if the GL does not answer.
  Status draw(const Gl& gl, const RenderTarget& target, const Area& within, int expected,
              const std::function<void()>& draw_fragments);

 private:
  void make_programs(const Gl& gl);
  /// Draws the fragments of an area, and blends them into the target if there was room for all. Returns their number.
  Result<std::uint32_t> draw_area(const Gl& gl, const FragmentLists& lists, const RenderTarget& target,
                                  const std::function<void()>& draw_fragments) const;
  Status sort(const Gl& gl, const FragmentLists& lists) const;
  void draw_fullscreen(const Gl& gl, const Program& program) const;

  std::optional<Program> merge_, compose_;  // made when first used
  std::optional<FragmentLists> lists_;      // made when first used, then reused: new memory costs a software GL 50 ms
  VertexArray empty_vertex_array_;          // without attributes, for draw_fullscreen
  std::size_t bytes_;
  std::string failure_;
};

}  // namespace pelage
