// Areas of a picture that are worked on one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/gl/handles.h"

namespace pelage {

/// Pixels, from the left and the top.
struct Area {
  int left = 0, top = 0, width = 0, height = 0;

  double pixels() const { return static_cast<double>(width) * height; }
  bool operator==(const Area&) const = default;
};

/// The two halves of an area of at least two pixels, cut across its longer side.
std::vector<Area> halves(const Area& area);

/// Cuts an area in halves until each has at most `most` pixels, or only one. Together they are the area.
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

  /// Whether fragment shaders of this context can write as many buffers as the lists take.
  static bool possible(const Gl& gl);

  /// Room for as many fragments as fit into `bytes` and into what the GL allows for one buffer; at least 1.
  FragmentLists(const Gl& gl, std::size_t bytes);

  bool complete() const { return complete_; }
  std::uint32_t capacity() const { return capacity_; }
  /// Empties the lists, for the pixels of an area, and binds the buffers.
  void begin(const Gl& gl, const Area& area) const;
  /// Waits for what was drawn.
  Header header(const Gl& gl) const;
  void clear_unsorted(const Gl& gl) const;

 private:
  Buffer firsts_, links_, colours_;
  std::uint32_t capacity_ = 0;
  bool complete_ = false;
};

}  // namespace pelage
