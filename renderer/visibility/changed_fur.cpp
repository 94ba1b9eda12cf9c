#include "renderer/visibility/changed_fur.h"

#include <algorithm>
#include <cassert>

#include "protocol/base/lean_curve.h"
#include "protocol/commands/coat.h"

namespace pelage {

namespace {

constexpr std::size_t max_noted = 1 << 18;  // 4 MiB
constexpr int box_count = 4;                // of a strand; between their ends it bends by no more than
constexpr float bend_of_a_part = 0.03f;     // of its length

class StrandBoxes {
 public:
  StrandBoxes(const GroomedMesh& mesh, const Coat& coat, const glm::mat4& to_clip)
      : mesh_(mesh), coat_(coat), balls_(to_clip), stretch_(1 + static_cast<float>(coat.variation.length)) {}

  ClipBox of(std::uint32_t vertex, glm::vec3 groom) const {
    const glm::vec3 root = mesh_.positions[vertex];
    const float length = stretch_ * groom.z;
    if (coat_.variation.lean > 0) return balls_.of(root, length);
    const glm::vec3 normal = mesh_.normals[vertex];
    const auto [inclination, lean] = lean_of(glm::vec2(groom), normal, mesh_.tangents[vertex]);
    ClipBox box = balls_.of(root, bend_of_a_part * length);
    for (int i = 1; i <= box_count; ++i) {
      const LeanPoint at =
          lean_point(coat_.lean_curve, inclination, coat_.root_share, static_cast<double>(i) / box_count);
      const glm::vec3 way = static_cast<float>(at.across) * lean + static_cast<float>(at.up) * normal;
      box = union_of(box, balls_.of(root + length * way, bend_of_a_part * length));
    }
    return box;
  }

 private:
  const GroomedMesh& mesh_;
  const Coat& coat_;
  BallBoxes balls_;
  float stretch_;
};

}  // namespace

void ChangedFur::note(std::uint32_t vertex, glm::vec3 groom) {
  if (noted_.size() == max_noted) {
    noted_.erase(noted_.begin(), noted_.begin() + max_noted / 2);
    forgotten_ += max_noted / 2;
  }
  noted_.push_back({vertex, groom});
}

std::optional<ClipBox> ChangedFur::box(const GroomedMesh& mesh, const Coat& coat, const glm::mat4& to_clip,
                                       std::uint64_t since) const {
  assert(since <= count());
  if (since < forgotten_) return ClipBox{};
  const std::span<const Noted> changed = std::span(noted_).subspan(static_cast<std::size_t>(since - forgotten_));
  if (changed.empty()) return {};
  const StrandBoxes strands(mesh, coat, to_clip);
  std::vector<std::optional<ClipBox>> reached(mesh.positions.size());
  for (const Noted& each : changed)
    reached[each.vertex] = union_of(reached[each.vertex], strands.of(each.vertex, each.groom));
  std::optional<ClipBox> all;
  for (const glm::uvec3& t : mesh.triangles) {
    if (!reached[t.x] && !reached[t.y] && !reached[t.z]) continue;
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t v = t[corner];
      all = union_of(all, reached[v] ? *reached[v] : strands.of(v, mesh.groom[v]));
    }
  }
  return all;
}

}  // namespace pelage
