// Embree's objects as move-only handles.
#pragma once

#include <embree3/rtcore.h>

#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <span>

#include "base/parallel.h"
#include "base/status.h"
#include "renderer/input/fur_scene.h"
#include "renderer/strands/grow.h"

namespace pelage {

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using EmbreeDevice = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;
using EmbreeGeometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseGeometry>;

// What rays hit: the strands, the skin and the eyeballs, in Embree. Strands are ribbons that face the ray, in parts
// with an index each, so that a stroke rebuilds only what it changed.

/// A strand, to be left out by rays that start on it.
struct StrandId {
  std::uint32_t part = ~0u, strand = ~0u;

  bool operator==(const StrandId&) const = default;
};

/// Distance from the skin at which rays start, sizes.
inline constexpr float leave_skin = 1e-5f;

struct Ray {
  glm::vec3 origin{0}, direction{0, 0, 1};  // unit
  float t_max = 1e30f;
  StrandId without = {};
  float time = 0;  // when it is cast, [0, 1]: 0 as the shutter opens, 1 as it closes
};

enum class HitKind { none, strand, skin };

/// Where a ray hits something. Only `kind`, `distance` and `normal` mean something on skin, and `colour`, which is the
/// mean of the roots around.
struct Hit {
  HitKind kind = HitKind::none;
  float distance = 0;         // sizes
  glm::vec3 normal{0, 1, 0};  // of the skin, or of that below the strand; unit
  glm::vec3 tangent{0};       // of the strand, root to tip, unit
  float offset = 0;           // h of the ray across the strand, [-1, 1]
  float radius = 0;           // of the strand there, sizes
  float height = 0;           // s, [0, 1]
  glm::vec3 colour{0};        // linear
  float number = 0, wetness = 0;
  StrandId strand = {};
  std::size_t object = 0;  // what a strand belongs to (fur_scene.h)
};

/// Transmittance of a strand of colour c: t^(1 - .82 sqrt(c)) by channel (science.md 4), where t is that of a black
/// strand.
inline constexpr float pale_transmittance = 0.82f;

class World {
 public:
  explicit World(std::size_t memory);  // bytes that strands and their index may take
  ~World();

  void set_memory(std::size_t memory);  // from the next update on

  struct Change {
    std::size_t grown = 0;  // strands that were grown anew
    std::size_t strands = 0;
  };
  /// Brings strands, skin and eyes up to date. Fails with too_large when memory is not enough, and with unavailable
  /// when `go_on` returned false; what a ray hits is then undefined until an update succeeds.
  Result<Change> update(const FurModel& model, EachCoat<FurFields> fields, const FurFrame& frame,
                        EachCoat<GrowRecipe> recipes, const WorkThreads& workers, const std::function<bool()>& go_on);

  std::size_t bytes() const;  // of strands and index

  /// Rays from beyond 1e18 sizes, of no direction or of numbers that are not finite hit nothing.
  Hit intersect(const Ray& ray) const;
  /// Returns whether anything lies on the ray before t_max.
  bool occluded(const Ray& ray) const;
  /// Transmittance along a ray, by channel: 0 through skin; each strand adds an optical depth of `depth` times what its
  /// colour absorbs; below 1/250 it counts as 0.
  glm::vec3 transmittance(const Ray& ray, float depth) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The status (unavailable) of work that was cancelled.
inline Status not_wanted() { return failure(Code::unavailable, "nobody waits for this picture any more"); }

}  // namespace pelage
