#include "server/builtin/implicit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pelage {
namespace {

glm::dvec3 flattened(const RoundCone& cone, glm::dvec3 offset) {
  return offset + (cone.flatten - 1) * glm::dot(offset, cone.flat_axis) * cone.flat_axis;
}

glm::dvec3 unit_or(glm::dvec3 v, glm::dvec3 otherwise) {
  const double length = glm::length(v);
  return length > 1e-300 ? v / length : otherwise;
}

/// The smaller of two distances with a quadratic fillet `width` wide.
DistanceSample smooth_min(const DistanceSample& p, const DistanceSample& q, double width) {
  const bool p_is_less = p.distance < q.distance;
  const DistanceSample& less = p_is_less ? p : q;
  const DistanceSample& more = p_is_less ? q : p;
  const double overlap = std::max(0.0, 1 - (more.distance - less.distance) / width);
  return {less.distance - 0.25 * width * overlap * overlap, glm::mix(less.gradient, more.gradient, 0.5 * overlap)};
}

DistanceSample negated(const DistanceSample& s) { return {-s.distance, -s.gradient}; }

}  // namespace

ImplicitSurface::Piece ImplicitSurface::make_piece(const RoundCone& cone) {
  assert(cone.flatten >= 1);
  Piece piece;
  piece.cone = cone;
  const glm::dvec3 span = flattened(cone, cone.b - cone.a);
  piece.length = glm::length(span);
  if (piece.length > 0) {
    piece.axis = span / piece.length;
    piece.sine = (cone.radius_a - cone.radius_b) / piece.length;
    assert(std::abs(piece.sine) < 1);
    piece.cosine = std::sqrt(1 - piece.sine * piece.sine);
  }
  piece.hull = {0.5 * (cone.a + cone.b), 0.5 * glm::distance(cone.a, cone.b) + std::max(cone.radius_a, cone.radius_b)};
  return piece;
}

ImplicitSurface::Part ImplicitSurface::make_part(const Volume& volume) {
  assert(!volume.cones.empty() && volume.width > 0 && volume.joint_width > 0);
  Part part{{}, volume.width, volume.joint_width, volume.blend, 1, {}};
  for (const RoundCone& cone : volume.cones) {
    part.pieces.push_back(make_piece(cone));
    part.most_flat = std::max(part.most_flat, cone.flatten);
    part.hull.centre += part.pieces.back().hull.centre / static_cast<double>(volume.cones.size());
  }
  for (const Piece& piece : part.pieces) {
    const double reach = glm::distance(piece.hull.centre, part.hull.centre) + piece.hull.radius + volume.joint_width;
    part.hull.radius = std::max(part.hull.radius, reach);
  }
  return part;
}

ImplicitSurface::ImplicitSurface(const std::vector<Volume>& volumes) {
  assert(!volumes.empty() && volumes.front().blend == Blend::add);
  lower_ = upper_ = volumes.front().cones.front().a;
  for (const Volume& volume : volumes) {
    parts_.push_back(make_part(volume));
    if (volume.blend == Blend::add) extend_box(volume);
  }
}

void ImplicitSurface::extend_box(const Volume& volume) {
  // A fillet swells a surface by at most a quarter of its width.
  const double swell = 0.25 * (volume.width + volume.joint_width);
  for (const RoundCone& cone : volume.cones) {
    lower_ = glm::min(lower_, glm::min(cone.a - cone.radius_a, cone.b - cone.radius_b) - swell);
    upper_ = glm::max(upper_, glm::max(cone.a + cone.radius_a, cone.b + cone.radius_b) + swell);
  }
}

DistanceSample ImplicitSurface::sample_piece(const Piece& piece, glm::dvec3 position) {
  const RoundCone& cone = piece.cone;
  const glm::dvec3 offset = flattened(cone, position - cone.a);
  const double along = glm::dot(offset, piece.axis);
  const glm::dvec3 across = offset - along * piece.axis;
  const double radial = glm::length(across);
  const double slant = piece.cosine * along - piece.sine * radial;

  DistanceSample flat;
  if (slant <= 0) {
    flat = {glm::length(offset) - cone.radius_a, unit_or(offset, piece.axis)};
  } else if (slant >= piece.cosine * piece.length) {
    const glm::dvec3 from_b = offset - piece.length * piece.axis;
    flat = {glm::length(from_b) - cone.radius_b, unit_or(from_b, piece.axis)};
  } else {
    flat = {piece.cosine * radial + piece.sine * along - cone.radius_a,
            piece.cosine * unit_or(across, glm::dvec3(0)) + piece.sine * piece.axis};
  }
  // Dividing by the gradient's length makes a distance again, exact at the surface.
  const glm::dvec3 gradient = flattened(cone, flat.gradient);
  const double slope = std::max(glm::length(gradient), 1e-3);
  return {flat.distance / slope, gradient / slope};
}

DistanceSample ImplicitSurface::sample_part(const Part& part, glm::dvec3 position) {
  DistanceSample sum = sample_piece(part.pieces.front(), position);
  for (std::size_t i = 1; i < part.pieces.size(); ++i) {
    const Piece& piece = part.pieces[i];
    const double gap = glm::distance(position, piece.hull.centre) - piece.hull.radius;
    if (gap / part.most_flat > sum.distance + part.joint_width) continue;
    sum = smooth_min(sum, sample_piece(piece, position), part.joint_width);
  }
  return sum;
}

DistanceSample ImplicitSurface::sample(glm::dvec3 position) const {
  DistanceSample sum = sample_part(parts_.front(), position);
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    const bool adds = part.blend == Blend::add;
    // A part too far away for its fillet changes nothing. Flattening may make a distance come out that much smaller.
    const double gap = (glm::distance(position, part.hull.centre) - part.hull.radius) / part.most_flat;
    if (gap > (adds ? sum.distance : -sum.distance) + part.width) continue;
    const DistanceSample other = sample_part(part, position);
    sum = adds ? smooth_min(sum, other, part.width) : negated(smooth_min(negated(sum), other, part.width));
  }
  return sum;
}

glm::dvec3 ImplicitSurface::project(glm::dvec3 position, double reach) const {
  for (int step = 0; step < 3; ++step) {
    const DistanceSample at = sample(position);
    const double slope = glm::length(at.gradient);
    if (slope < 0.1 || std::abs(at.distance) < 1e-9) break;
    position -= std::clamp(at.distance / slope, -reach, reach) / slope * at.gradient;
  }
  return position;
}

}  // namespace pelage
