// The scene that rays are traced in: strands, skin and eyeballs in Embree, whose objects are held by move-only handles.
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

// Strands are flat ribbons that face the ray. They are divided into parts with an index each, so that a stroke rebuilds
// only the parts that it changed.

/// Identifies a strand, so that rays that start on it can ignore it.
struct StrandId {
  std::uint32_t part = ~0u, strand = ~0u;

  bool operator==(const StrandId&) const = default;
};

/// Offset from the skin at which rays start, sizes; avoids self-intersection.
inline constexpr float ray_offset = 1e-5f;

struct Ray {
  glm::vec3 origin{0}, direction{0, 0, 1};  // unit
  float t_max = 1e30f;
  StrandId ignored = {};
  float time = 0;  // shutter time, [0, 1]: 0 as the shutter opens, 1 as it closes
};

enum class HitKind { none, strand, skin };

/// The hit of a ray. On skin only `kind`, `distance`, `normal` and `colour` are set; `colour` is then the mean colour
/// of the strands' roots around.
struct Hit {
  HitKind kind = HitKind::none;
  float distance = 0;         // sizes
  glm::vec3 normal{0, 1, 0};  // of the skin, or of the skin at the strand's root; unit
  glm::vec3 tangent{0};       // of the strand, from root to tip; unit
  float offset = 0;           // position h of the ray across the strand, [-1, 1]
  float radius = 0;           // of the strand there, sizes
  float height = 0;           // height s in the fur, [0, 1]
  glm::vec3 colour{0};        // linear
  float number = 0, wetness = 0;
  StrandId strand = {};
  std::size_t object = 0;  // object number of the strand's coat or of the curves (fur_scene.h)
};

/// A strand of colour c has the transmittance t^(1 - .82 sqrt(c)) in each channel (science.md 4), where t is that of a
/// black strand.
inline constexpr float pale_transmittance = 0.82f;

class World {
 public:
  explicit World(std::size_t memory);  // memory limit for strands and their index, bytes
  ~World();

  void set_memory(std::size_t memory);  // takes effect at the next update

  struct Change {
    std::size_t grown = 0;  // strands that were grown anew
    std::size_t strands = 0;
  };
  /// Updates strands, skin and eyes. Fails with too_large if memory does not suffice, and with unavailable if `go_on`
  /// returned false; until an update succeeds again, ray queries are undefined.
  Result<Change> update(const FurModel& model, EachCoat<FurFields> fields, const FurFrame& frame,
                        EachCoat<GrowRecipe> recipes, const WorkThreads& workers, const std::function<bool()>& go_on);

  std::size_t bytes() const;  // of strands and index, in use

  /// Returns the nearest hit. Rays that start beyond 1e18 sizes, have no direction, or have components that are not
  /// finite hit nothing.
  Hit intersect(const Ray& ray) const;
  /// Returns true if anything is hit before t_max.
  bool occluded(const Ray& ray) const;
  /// Returns the transmittance along a ray, by channel: 0 through skin; each strand adds an optical depth of `depth`
  /// times StrandPart::relative_depth; below 1/250 it counts as 0.
  glm::vec3 transmittance(const Ray& ray, float depth) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The status (unavailable) of work that was cancelled.
inline Status cancelled_status() { return failure(Code::unavailable, "nobody waits for this picture any more"); }

}  // namespace pelage
