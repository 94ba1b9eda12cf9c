#include <algorithm>
#include <type_traits>

#include "base/parallel.h"
#include "server/fields/field_set.h"
#include "server/fields/field_writer.h"
#include "server/groom/brush.h"
#include "server/groom/tools.h"
#include "server/groom/vertex_frame.h"
#include "server/surface/geodesics.h"

namespace pelage {

namespace {

/// The vertices that smoothing a region reads: its own and their neighbours. A small region renumbers them, so that the
/// cost of a dab does not grow with the mesh; a large one uses the mesh's numbers.
class Neighbourhood {
 public:
  Neighbourhood(const std::vector<VertexWeight>& region, const Surface& surface)
      : region_(region), surface_(surface), all_(region.size() >= surface.mesh().positions.size() / 8) {
    if (all_) return;
    begin_.push_back(0);
    for (const VertexWeight& entry : region) {
      const auto others = surface.neighbours(entry.vertex);
      vertices_.push_back(entry.vertex);
      vertices_.insert(vertices_.end(), others.begin(), others.end());
      begin_.push_back(begin_.back() + static_cast<std::uint32_t>(others.size()));
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    for (const VertexWeight& entry : region) {
      for (const std::uint32_t other : surface.neighbours(entry.vertex)) others_.push_back(number_of(other));
      numbers_.push_back(number_of(entry.vertex));
    }
  }

  std::size_t size() const { return all_ ? surface_.mesh().positions.size() : vertices_.size(); }
  std::uint32_t vertex(std::uint32_t number) const { return all_ ? number : vertices_[number]; }
  /// Return the numbers of the region's i-th vertex and of its neighbours.
  std::uint32_t number(std::size_t i) const { return all_ ? region_[i].vertex : numbers_[i]; }
  std::span<const std::uint32_t> others(std::size_t i) const {
    return all_ ? surface_.neighbours(region_[i].vertex)
                : std::span(others_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }

 private:
  std::uint32_t number_of(std::uint32_t vertex) const {
    return static_cast<std::uint32_t>(std::lower_bound(vertices_.begin(), vertices_.end(), vertex) - vertices_.begin());
  }

  const std::vector<VertexWeight>& region_;
  const Surface& surface_;
  bool all_;
  std::vector<std::uint32_t> vertices_;  // by number, rising
  std::vector<std::uint32_t> numbers_, begin_, others_;
};

/// The contribution of a neighbour to a mean: a share, for directions combined with the rotation from the neighbour's
/// frame to the vertex's own, as a complex number whose magnitude is the share.
using Share = float;
using TurnedShare = glm::vec2;

template <class Value>
Value shared(Share share, const Value& value) {
  return double{share} * value;
}
glm::dvec2 shared(TurnedShare turn, glm::dvec2 v) { return {turn.x * v.x - turn.y * v.y, turn.y * v.x + turn.x * v.y}; }

double size_of(Share share) { return double{share}; }
double size_of(TurnedShare turn) { return glm::length(glm::dvec2(turn)); }

void put_share(Share& share, double part, const Mesh&, const VertexFrame&, std::uint32_t) {
  share = static_cast<float>(part);
}
void put_share(TurnedShare& share, double part, const Mesh& mesh, const VertexFrame& frame, std::uint32_t other) {
  const glm::dvec3 normal(mesh.normals[other]), tangent(mesh.tangents[other]);
  const glm::dvec2 turn = frame.tangent_part(transported(tangent, normal, frame.normal));
  const double length = glm::length(turn);
  share = length > 0 ? TurnedShare(turn * (part / length)) : TurnedShare(part, 0);
}

/// Computes the shares: inverse distances, normalized. Welded meshes have no two vertices at one position.
template <class AnyShare>
void put_shares(std::uint32_t vertex, const Surface& surface, std::vector<double>& inverses, AnyShare* shares) {
  const Mesh& mesh = surface.mesh();
  const auto others = surface.neighbours(vertex);
  const VertexFrame frame = frame_at(mesh, vertex);
  inverses.clear();
  double sum = 0;
  for (const std::uint32_t other : others) {
    inverses.push_back(1 / glm::distance(glm::dvec3(mesh.positions[other]), glm::dvec3(mesh.positions[vertex])));
    sum += inverses.back();
  }
  for (std::size_t k = 0; k < others.size(); ++k) put_share(shares[k], inverses[k] / sum, mesh, frame, others[k]);
}

/// The shares of all neighbours of a region's vertices. They are stored if there are several passes, else computed on
/// demand.
template <class AnyShare>
class Ring {
 public:
  Ring(const std::vector<VertexWeight>& region, const Surface& surface, bool keep)
      : region_(region), surface_(surface) {
    if (!keep) return;
    begin_.resize(region.size() + 1);
    for (std::size_t i = 0; i < region.size(); ++i)
      begin_[i + 1] = begin_[i] + static_cast<std::uint32_t>(surface.neighbours(region[i].vertex).size());
    shares_.resize(begin_.back());
    for_each_range_in_parallel(static_cast<std::uint32_t>(region.size()), [&](std::uint32_t first, std::uint32_t end) {
      std::vector<double> inverses;
      for (std::uint32_t i = first; i < end; ++i) put_shares(region[i].vertex, surface, inverses, &shares_[begin_[i]]);
    });
  }

  /// Scratch memory for the shares of one vertex.
  struct Scratch {
    std::vector<double> inverses;
    std::vector<AnyShare> shares;
  };
  std::span<const AnyShare> of(std::size_t i, Scratch& scratch) const {
    if (!begin_.empty()) return std::span(shares_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
    scratch.shares.resize(surface_.neighbours(region_[i].vertex).size());
    put_shares(region_[i].vertex, surface_, scratch.inverses, scratch.shares.data());
    return scratch.shares;
  }

 private:
  const std::vector<VertexWeight>& region_;
  const Surface& surface_;
  std::vector<std::uint32_t> begin_;
  std::vector<AnyShare> shares_;
};

glm::dvec4 wide(double value) { return {value, 0, 0, 0}; }
glm::dvec4 wide(glm::dvec2 value) { return {value, 0, 0}; }
glm::dvec4 wide(const glm::dvec4& value) { return value; }

void narrow(const glm::dvec4& from, double& to) { to = from.x; }
template <class Value>
void narrow(const glm::dvec4& from, Value& to) {
  to = Value(from);
}

/// Smooths one field of a region; values stay in double between the passes.
template <class Value, class AnyShare>
class SmoothedField {
 public:
  SmoothedField(const Smooth& command, Field field, const std::vector<VertexWeight>& region, const Neighbourhood& near,
                const Surface& surface, const FieldSet& fields, const Cancel& cancel)
      : command_(command),
        field_(field),
        region_(region),
        near_(near),
        fields_(fields),
        cancel_(cancel),
        share_(strand_share(command.brush, field)),
        ring_(region, surface, command.passes > 1),
        now_(near.size()) {
    for_each_range_in_parallel(static_cast<std::uint32_t>(now_.size()), [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t n = begin; n < end; ++n)
        narrow(to_summable(field, glm::dvec4(fields.value(field, near.vertex(n)))), now_[n]);
    });
    next_ = now_;
  }

  std::size_t smooth(FieldDelta& delta) {
    const auto count = static_cast<std::uint32_t>(region_.size());
    for (int pass = 0; pass < command_.passes; ++pass) {
      cancel_.check();
      for_each_range_in_parallel(count, [&](std::uint32_t begin, std::uint32_t end) {
        typename Ring<AnyShare>::Scratch scratch;
        for (std::uint32_t i = begin; i < end; ++i) next_[near_.number(i)] = smoothed(i, scratch);
      });
      now_.swap(next_);
    }
    return write_in_parallel(fields_, field_, count, delta, [&](std::uint32_t i, FieldWriter& writer) {
      return writer.put(region_[i].vertex, from_summable(field_, wide(now_[near_.number(i)])));
    });
  }

 private:
  Value smoothed(std::size_t i, typename Ring<AnyShare>::Scratch& scratch) const {
    const Value& own = now_[near_.number(i)];
    const auto others = near_.others(i);
    if (others.empty()) return own;
    const auto shares = ring_.of(i, scratch);
    // Sums differences and not values, so that a constant field does not drift, however the shares are rounded.
    Value change(0);
    for (std::size_t k = 0; k < others.size(); ++k)
      change += shared(shares[k], now_[others[k]]) - size_of(shares[k]) * own;
    const Value blended = own + command_.t * share_ * region_[i].weight * change;
    if constexpr (std::is_same_v<AnyShare, TurnedShare>) {
      const double length = glm::length(blended);
      if (command_.keep_inclination) return length > no_heading ? blended * (glm::length(own) / length) : own;
    }
    return blended;
  }

  const Smooth& command_;
  Field field_;
  const std::vector<VertexWeight>& region_;
  const Neighbourhood& near_;
  const FieldSet& fields_;
  const Cancel& cancel_;
  const double share_;
  Ring<AnyShare> ring_;
  std::vector<Value> now_, next_;
};

}  // namespace

Evaluation run(const Smooth& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  const std::vector<VertexWeight> region = region_of(command.stroke, command.brush, surface, fields, extras);
  Evaluation done;
  if (region.empty() || command.t == 0) return done;
  const Neighbourhood near(region, surface);
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (std::count(command.fields.begin(), command.fields.end(), field) == 0 || fields.at_default(field)) continue;
    if (field == Field::direction)
      done.clamped +=
          SmoothedField<glm::dvec2, TurnedShare>(command, field, region, near, surface, fields, extras.cancel)
              .smooth(done.delta);
    else if (shape_of(field).channels == 1)
      done.clamped +=
          SmoothedField<double, Share>(command, field, region, near, surface, fields, extras.cancel).smooth(done.delta);
    else
      done.clamped += SmoothedField<glm::dvec4, Share>(command, field, region, near, surface, fields, extras.cancel)
                          .smooth(done.delta);
  }
  return done;
}

}  // namespace pelage
