#include <algorithm>
#include <cmath>

#include "server/fields/field_writer.h"
#include "server/groom/region.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"
#include "server/surface/parallel.h"
#include "server/surface/transport.h"

namespace pelage {

namespace {

/// A neighbour: its share of the mean, and the turn from its frame to the vertex's own.
struct Neighbour {
  std::uint32_t vertex;
  float share;
  glm::vec2 turn{1, 0};  // cosine and sine
};

/// The neighbours of a region's vertices, ready for many passes.
class Ring {
 public:
  Ring(const std::vector<VertexWeight>& region, const Surface& surface) : begin_(region.size() + 1) {
    for (std::size_t i = 0; i < region.size(); ++i)
      begin_[i + 1] = begin_[i] + static_cast<std::uint32_t>(surface.neighbours(region[i].vertex).size());
    neighbours_.resize(begin_.back());
    for_each_run_in_parallel(static_cast<std::uint32_t>(region.size()), [&](std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t i = first; i < end; ++i) fill(region[i].vertex, surface, &neighbours_[begin_[i]]);
    });
  }

  std::span<const Neighbour> of(std::size_t i) const {
    return std::span(neighbours_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }

 private:
  /// Shares are the inverse distances over their sum; welded meshes have no two vertices in one place.
  static void fill(std::uint32_t vertex, const Surface& surface, Neighbour* out) {
    const Mesh& mesh = surface.mesh();
    const auto others = surface.neighbours(vertex);
    const VertexFrame frame = frame_at(mesh, vertex);
    double sum = 0;
    for (const std::uint32_t other : others)
      sum += 1 / glm::distance(glm::dvec3(mesh.positions[other]), glm::dvec3(mesh.positions[vertex]));
    for (const std::uint32_t other : others) {
      const double inverse = 1 / glm::distance(glm::dvec3(mesh.positions[other]), glm::dvec3(mesh.positions[vertex]));
      const VertexFrame from = frame_at(mesh, other);
      const glm::dvec2 turn = frame.tangent_part(transported(from.tangent, from.normal, frame.normal));
      const double length = glm::length(turn);
      *out++ = {other, static_cast<float>(inverse / sum), length > 0 ? glm::vec2(turn / length) : glm::vec2(1, 0)};
    }
  }

  std::vector<std::uint32_t> begin_;
  std::vector<Neighbour> neighbours_;
};

glm::dvec2 turned_by(glm::vec2 turn, glm::dvec2 v) {
  return {turn.x * v.x - turn.y * v.y, turn.y * v.x + turn.x * v.y};
}

/// One field, smoothed over a region, in double between the passes.
class SmoothedField {
 public:
  SmoothedField(const Smooth& command, Field field, const FieldSet& fields)
      : command_(command), field_(field), channels_(shape_of(field).channels), now_(fields.size()) {
    for (std::uint32_t v = 0; v < now_.size(); ++v) now_[v] = glm::dvec4(fields.value(field, v));
    next_.resize(now_.size());
  }

  void pass(const std::vector<VertexWeight>& region, const Ring& ring) {
    const auto count = static_cast<std::uint32_t>(region.size());
    for_each_run_in_parallel(count, [&](std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t i = first; i < end; ++i)
        next_[region[i].vertex] = smoothed(region[i].vertex, command_.t * region[i].weight, ring.of(i));
    });
    for_each_run_in_parallel(count, [&](std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t i = first; i < end; ++i) now_[region[i].vertex] = next_[region[i].vertex];
    });
  }

  std::size_t finish(const std::vector<VertexWeight>& region, const FieldSet& fields, FieldDelta& delta) const {
    FieldWriter writer(fields, field_);
    std::size_t held = 0;
    for (const VertexWeight& place : region) held += writer.put(place.vertex, now_[place.vertex]);
    writer.finish(delta);
    return held;
  }

 private:
  glm::dvec4 smoothed(std::uint32_t v, double t, std::span<const Neighbour> neighbours) const {
    if (neighbours.empty()) return now_[v];
    // Differences and not values: where nothing differs nothing drifts, however the shares are rounded.
    glm::dvec4 change(0);
    for (const Neighbour& other : neighbours) {
      const glm::dvec4 value = now_[other.vertex];
      const glm::dvec4 here =
          field_ == Field::direction ? glm::dvec4(turned_by(other.turn, glm::dvec2(value)), 0, 0) : value;
      change += double{other.share} * (here - now_[v]);
    }
    const glm::dvec4 blended = now_[v] + t * change;
    if (field_ != Field::direction || !command_.keep_inclination) return blended;
    const double length = glm::length(blended);
    return length > no_heading ? blended * (glm::length(now_[v]) / length) : now_[v];
  }

  const Smooth& command_;
  Field field_;
  int channels_;
  std::vector<glm::dvec4> now_, next_;
};

}  // namespace

Evaluation smooth(const Smooth& command, const Surface& surface, const FieldSet& fields) {
  const std::vector<VertexWeight> region = region_of(command.stroke, command.brush, surface, fields);
  Evaluation done;
  if (region.empty() || command.t == 0) return done;
  const Ring ring(region, surface);
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (std::count(command.fields.begin(), command.fields.end(), field) == 0 || fields.at_rest(field)) continue;
    SmoothedField smoothed(command, field, fields);
    for (int pass = 0; pass < command.passes; ++pass) smoothed.pass(region, ring);
    done.clamped += smoothed.finish(region, fields, done.delta);
  }
  return done;
}

}  // namespace pelage
