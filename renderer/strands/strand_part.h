// A part of the traced strands, which are grown and indexed together, with its Embree scene and memory budget.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

#include "renderer/strands/strand_set.h"
#include "renderer/strands/world.h"

namespace pelage {

/// Counts bytes in use against a limit. Safe to share between threads.
class MemoryBudget {
 public:
  explicit MemoryBudget(std::size_t limit) : limit_(limit) {}

  void set_limit(std::size_t limit) { limit_ = limit; }
  /// Reserves bytes, or releases them if `bytes` is negative. Returns false and reserves nothing if that would exceed
  /// the limit.
  bool take(std::ptrdiff_t bytes);
  std::size_t used() const { return static_cast<std::size_t>(used_.load()); }
  std::size_t left() const {
    const std::size_t limit = limit_;
    return limit - std::min(used(), limit);
  }

 private:
  std::atomic<std::size_t> limit_;
  std::atomic<std::ptrdiff_t> used_{0};
};

/// A part of the strands with its Embree scene (the index). It cannot be moved, because Embree keeps its address and
/// that of its strands.
class StrandPart {
 public:
  StrandPart(std::uint32_t number, MemoryBudget& budget) : number_(number), budget_(budget) {}
  ~StrandPart() { drop(); }
  StrandPart(const StrandPart&) = delete;
  StrandPart& operator=(const StrandPart&) = delete;

  /// Replaces the strands and builds their index. Returns false if memory does not suffice; the part is then empty.
  bool set(RTCDevice device, StrandSet strands);
  void drop();

  std::uint32_t number() const { return number_; }
  const StrandSet& strands() const { return strands_; }
  RTCScene index() const { return index_.get(); }         // null without strands
  glm::vec3 root_colour() const { return root_colour_; }  // mean, linear

  /// Returns the hit of a ray on a segment, at `distance` along the ray and at `u` in [0, 1] along the segment.
  Hit hit(const Ray& ray, float distance, std::uint32_t segment, float u) const;
  /// Returns the strand's optical depth by channel over that of a black strand, at `u` along a segment: [1 -
  /// pale_transmittance, 1].
  glm::vec3 relative_depth(std::uint32_t segment, float u) const;
  StrandId strand_of(std::uint32_t segment) const {
    return {number_, segment / static_cast<std::uint32_t>(strands_.segments)};
  }

 private:
  std::size_t first_point(std::uint32_t segment) const;

  std::uint32_t number_;
  MemoryBudget& budget_;
  StrandSet strands_;
  EmbreeScene index_;
  glm::vec3 root_colour_{0};
};

}  // namespace pelage
