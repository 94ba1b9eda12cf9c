#include "server/surface/nearest.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace pelage {

namespace {

constexpr std::size_t leaf_size = 8;

double distance(glm::dvec3 a, glm::dvec3 b) { return glm::length(a - b); }

int longest_axis(glm::vec3 extent) {
  if (extent.x >= extent.y && extent.x >= extent.z) return 0;
  return extent.y >= extent.z ? 1 : 2;
}

}  // namespace

PointTree::PointTree(std::span<const glm::vec3> points) : order_(points.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  if (!points.empty()) build(points, 0, 0, points.size());
}

void PointTree::build(std::span<const glm::vec3> points, std::size_t node, std::size_t begin, std::size_t end) {
  Box box{points[order_[begin]], points[order_[begin]]};
  for (std::size_t i = begin; i < end; ++i) {
    box.low = glm::min(box.low, points[order_[i]]);
    box.high = glm::max(box.high, points[order_[i]]);
  }
  if (boxes_.size() <= node) boxes_.resize(node + 1);
  boxes_[node] = box;
  if (end - begin <= leaf_size) return;
  const int axis = longest_axis(box.high - box.low);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(points[a][axis], a) < std::tie(points[b][axis], b);
  });
  build(points, 2 * node + 1, begin, middle);
  build(points, 2 * node + 2, middle, end);
}

void PointTree::find_within(std::span<const glm::vec3> points, glm::dvec3 centre, double radius,
                            std::vector<std::uint32_t>& found) const {
  if (radius >= 0 && !points.empty()) search(points, {centre, radius}, 0, 0, points.size(), found);
}

void PointTree::search(std::span<const glm::vec3> points, const Ball& ball, std::size_t node, std::size_t begin,
                       std::size_t end, std::vector<std::uint32_t>& found) const {
  const Box& box = boxes_[node];
  const glm::dvec3 low(box.low), high(box.high);
  if (!(distance(ball.centre, glm::clamp(ball.centre, low, high)) <= ball.radius)) return;
  if (end - begin <= leaf_size) {
    for (std::size_t i = begin; i < end; ++i) {
      if (distance(ball.centre, glm::dvec3(points[order_[i]])) <= ball.radius) found.push_back(order_[i]);
    }
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  search(points, ball, 2 * node + 1, begin, middle, found);
  search(points, ball, 2 * node + 2, middle, end, found);
}

namespace {

TrianglePoint at(const std::array<glm::dvec3, 3>& corners, glm::dvec3 place, glm::dvec3 barycentric) {
  const glm::dvec3 point = barycentric.x * corners[0] + barycentric.y * corners[1] + barycentric.z * corners[2];
  return {barycentric, glm::length(place - point)};
}

/// Nearest on the side from corner `from` to corner `to`.
TrianglePoint nearest_on_side(const std::array<glm::dvec3, 3>& corners, glm::dvec3 place, int from, int to) {
  const glm::dvec3 start = corners[static_cast<std::size_t>(from)];
  const glm::dvec3 side = corners[static_cast<std::size_t>(to)] - start;
  const double squared = glm::dot(side, side);
  const double t = squared > 0 ? std::clamp(glm::dot(place - start, side) / squared, 0.0, 1.0) : 0.0;
  glm::dvec3 barycentric(0);
  barycentric[from] = 1 - t;
  barycentric[to] = t;
  return at(corners, place, barycentric);
}

}  // namespace

TrianglePoint nearest_on_triangle(const std::array<glm::dvec3, 3>& corners, glm::dvec3 place) {
  const glm::dvec3 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0], p = place - corners[0];
  const glm::dvec3 normal = glm::cross(e1, e2);
  const double squared = glm::dot(normal, normal);
  if (squared > 0) {
    const double v = glm::dot(glm::cross(p, e2), normal) / squared;
    const double w = glm::dot(glm::cross(e1, p), normal) / squared;
    if (v >= 0 && w >= 0 && v + w <= 1) return at(corners, place, {1 - v - w, v, w});
  }
  TrianglePoint best = nearest_on_side(corners, place, 0, 1);
  for (const auto& [from, to] : {std::pair{1, 2}, std::pair{2, 0}}) {
    const TrianglePoint other = nearest_on_side(corners, place, from, to);
    if (other.distance < best.distance) best = other;
  }
  return best;
}

}  // namespace pelage
