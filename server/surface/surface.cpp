#include "server/surface/surface.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "base/parallel.h"

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

struct PointTree::Ball {
  glm::dvec3 centre;
  double radius;

  bool contains(glm::dvec3 point) const { return distance(centre, point) <= radius; }
  bool may_intersect(glm::dvec3 low, glm::dvec3 high) const { return contains(glm::clamp(centre, low, high)); }
};

struct PointTree::Capsule {
  glm::dvec3 from, along;  // along = to - from
  double radius;

  bool contains(glm::dvec3 point) const {
    const double square = glm::dot(along, along);
    const double share = square > 0 ? std::clamp(glm::dot(point - from, along) / square, 0.0, 1.0) : 0;
    return distance(from + share * along, point) <= radius;
  }
  /// Returns whether the segment intersects the box enlarged by the radius.
  bool may_intersect(glm::dvec3 low, glm::dvec3 high) const {
    double enters = 0, leaves = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const double before = low[axis] - radius - from[axis], beyond = high[axis] + radius - from[axis];
      if (along[axis] == 0) {
        if (before > 0 || beyond < 0) return false;
        continue;
      }
      const auto [near, far] = std::minmax({before / along[axis], beyond / along[axis]});
      enters = std::max(enters, near), leaves = std::min(leaves, far);
    }
    return enters <= leaves;
  }
};

void PointTree::find_within(std::span<const glm::vec3> points, glm::dvec3 centre, double radius,
                            std::vector<std::uint32_t>& found) const {
  if (radius >= 0 && !points.empty()) search(points, Ball{centre, radius}, 0, 0, points.size(), found);
}

void PointTree::find_along(std::span<const glm::vec3> points, glm::dvec3 from, glm::dvec3 to, double radius,
                           std::vector<std::uint32_t>& found) const {
  if (radius >= 0 && !points.empty()) search(points, Capsule{from, to - from, radius}, 0, 0, points.size(), found);
}

template <class Shape>
void PointTree::search(std::span<const glm::vec3> points, const Shape& shape, std::size_t node, std::size_t begin,
                       std::size_t end, std::vector<std::uint32_t>& found) const {
  const Box& box = boxes_[node];
  if (!shape.may_intersect(glm::dvec3(box.low), glm::dvec3(box.high))) return;
  if (end - begin <= leaf_size) {
    for (std::size_t i = begin; i < end; ++i) {
      if (shape.contains(glm::dvec3(points[order_[i]]))) found.push_back(order_[i]);
    }
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  search(points, shape, 2 * node + 1, begin, middle, found);
  search(points, shape, 2 * node + 2, middle, end, found);
}

namespace {

TrianglePoint at(const std::array<glm::dvec3, 3>& corners, glm::dvec3 position, glm::dvec3 barycentric) {
  const glm::dvec3 point = barycentric.x * corners[0] + barycentric.y * corners[1] + barycentric.z * corners[2];
  return {barycentric, glm::length(position - point)};
}

/// Returns the nearest point on the side from corner `from` to corner `to`.
TrianglePoint nearest_on_side(const std::array<glm::dvec3, 3>& corners, glm::dvec3 position, int from, int to) {
  const glm::dvec3 start = corners[static_cast<std::size_t>(from)];
  const glm::dvec3 side = corners[static_cast<std::size_t>(to)] - start;
  const double squared = glm::dot(side, side);
  const double t = squared > 0 ? std::clamp(glm::dot(position - start, side) / squared, 0.0, 1.0) : 0.0;
  glm::dvec3 barycentric(0);
  barycentric[from] = 1 - t;
  barycentric[to] = t;
  return at(corners, position, barycentric);
}

}  // namespace

TrianglePoint nearest_on_triangle(const std::array<glm::dvec3, 3>& corners, glm::dvec3 position) {
  const glm::dvec3 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0], p = position - corners[0];
  const glm::dvec3 normal = glm::cross(e1, e2);
  const double squared = glm::dot(normal, normal);
  if (squared > 0) {
    const double v = glm::dot(glm::cross(p, e2), normal) / squared;
    const double w = glm::dot(glm::cross(e1, p), normal) / squared;
    if (v >= 0 && w >= 0 && v + w <= 1) return at(corners, position, {1 - v - w, v, w});
  }
  TrianglePoint best = nearest_on_side(corners, position, 0, 1);
  for (const auto& [from, to] : {std::pair{1, 2}, std::pair{2, 0}}) {
    const TrianglePoint other = nearest_on_side(corners, position, from, to);
    if (other.distance < best.distance) best = other;
  }
  return best;
}

namespace {

/// Owns one Embree object.
template <class Handle, void (*release)(Handle)>
struct Releaser {
  void operator()(std::remove_pointer_t<Handle>* handle) const { release(handle); }
};
using Device = std::unique_ptr<RTCDeviceTy, Releaser<RTCDevice, rtcReleaseDevice>>;
using Scene = std::unique_ptr<RTCSceneTy, Releaser<RTCScene, rtcReleaseScene>>;

/// Settings of the Embree device: one instruction set on every CPU, because hits differ between them. The number of
/// threads is not set, because that would limit oneTBB in the whole process; scenes are built on the caller's thread
/// instead.
constexpr const char* device_settings = "isa=sse4.2,set_affinity=0,hugepages=0";

/// Copies the mesh into Embree's buffers. Embree reads 16 bytes from each vertex, and pads the buffers that it
/// allocates.
void fill_geometry(RTCGeometry geometry, const Mesh& mesh) {
  auto* positions = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.positions.size()));
  auto* triangles = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), mesh.triangles.size()));
  if (!positions || !triangles) throw std::bad_alloc();
  std::copy(mesh.positions.begin(), mesh.positions.end(), positions);
  std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
  rtcCommitGeometry(geometry);
}

/// Makes a device that keeps `bytes` at its current memory use.
Device make_device(std::atomic<std::ptrdiff_t>& bytes) {
  Device device(rtcNewDevice(device_settings));
  if (!device) throw std::bad_alloc();
  const auto count = [](void* counter, std::ptrdiff_t change, bool) {
    *static_cast<std::atomic<std::ptrdiff_t>*>(counter) += change;
    return true;
  };
  rtcSetDeviceMemoryMonitorFunction(device.get(), count, &bytes);
  return device;
}

std::size_t bytes_of(const Mesh& mesh) {
  const auto array = [](const auto& values) { return values.capacity() * sizeof(values[0]); };
  std::size_t bytes = array(mesh.positions) + array(mesh.normals) + array(mesh.tangents) + array(mesh.triangles) +
                      array(mesh.corners) + array(mesh.texture_uv) + array(mesh.length_scale);
  for (const RawImage& image : mesh.images) bytes += array(image.rgba);
  return bytes;
}

Scene make_scene(RTCDevice device, const Mesh& mesh) {
  Scene scene(rtcNewScene(device));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  fill_geometry(geometry, mesh);
  rtcAttachGeometry(scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  run_on_this_thread([&] { rtcCommitScene(scene.get()); });
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (error != RTC_ERROR_NONE) throw std::runtime_error("Embree cannot index the model");
  return scene;
}

std::array<glm::dvec3, 3> corners_of(const Mesh& mesh, std::uint32_t triangle) {
  const glm::uvec3 t = mesh.triangles[triangle];
  return {glm::dvec3(mesh.positions[t.x]), glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z])};
}

struct Nearest {
  const Mesh* mesh;
  glm::dvec3 position;
  double slack;  // maximum error of a distance from rounding the position to 32 bits
  double distance = std::numeric_limits<double>::infinity();
  SurfacePoint point;
};

/// Embree's callback for each triangle within the query radius. Of equally near triangles the one with the lower number
/// wins.
bool visit_triangle(RTCPointQueryFunctionArguments* arguments) {
  Nearest& best = *static_cast<Nearest*>(arguments->userPtr);
  const TrianglePoint candidate = nearest_on_triangle(corners_of(*best.mesh, arguments->primID), best.position);
  const bool nearer = candidate.distance < best.distance ||
                      (candidate.distance == best.distance && arguments->primID < best.point.triangle);
  if (!nearer) return false;
  best.distance = candidate.distance;
  best.point = {arguments->primID, candidate.barycentric};
  arguments->query->radius = static_cast<float>(best.distance * (1 + 1e-5) + best.slack);
  return true;
}

/// Returns where the part of the ray near the model begins; nothing if the ray misses the model's surroundings. The
/// origin is moved along the ray in double, because Embree's rays are 32-bit and end the process when a square
/// overflows.
std::optional<glm::dvec3> start_near_model(glm::dvec3 origin, glm::dvec3 direction) {
  // The model's box lies in the ball of radius 1/2 around the origin of the internal coordinates.
  const double closest = -glm::dot(origin, direction);
  const glm::dvec3 start = closest > 1 ? origin + direction * (closest - 1) : origin;
  if (glm::length(start) <= 2) return start;  // false for NaN too
  return std::nullopt;
}

/// Normalizes a direction; returns nothing if it is 0 or not finite.
std::optional<glm::dvec3> unit_of(glm::dvec3 direction) {
  const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
  if (!is_finite(direction) || largest == 0) return std::nullopt;
  return glm::normalize(direction / largest);  // its square neither overflows nor underflows
}

}  // namespace

struct Surface::Impl {
  explicit Impl(Mesh m)
      : mesh(std::move(m)),
        device(make_device(embree_bytes)),
        scene(make_scene(device.get(), mesh)),
        points(mesh.positions),
        neighbours(vertex_neighbours(mesh.triangles, mesh.positions.size())) {}

  Mesh mesh;
  std::atomic<std::ptrdiff_t> embree_bytes{0};  // counted by the device, so it must outlive the device
  Device device;
  Scene scene;
  PointTree points;
  Adjacency neighbours;
};

Surface::Surface(Mesh mesh) : impl_(std::make_unique<Impl>(std::move(mesh))) {}
Surface::~Surface() = default;
Surface::Surface(Surface&&) noexcept = default;
Surface& Surface::operator=(Surface&&) noexcept = default;

const Mesh& Surface::mesh() const { return impl_->mesh; }

std::size_t Surface::bytes() const {
  const Adjacency& adjacency = impl_->neighbours;
  return sizeof(Impl) + bytes_of(impl_->mesh) +
         static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, impl_->embree_bytes)) + impl_->points.bytes() +
         (adjacency.begin.capacity() + adjacency.others.capacity()) * sizeof(std::uint32_t);
}

std::optional<SurfacePoint> Surface::raycast(glm::dvec3 origin, glm::dvec3 direction) const {
  const std::optional<glm::dvec3> unit = unit_of(direction);
  const std::optional<glm::dvec3> near = unit ? start_near_model(origin, *unit) : std::nullopt;
  if (!near) return std::nullopt;
  const glm::vec3 start(*near), towards(*unit);
  RTCRayHit query{};
  query.ray = {start.x, start.y, start.z, 0, towards.x, towards.y, towards.z, 0, std::numeric_limits<float>::infinity(),
               ~0u,     0,       0};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(impl_->scene.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const double v = std::clamp<double>(query.hit.u, 0, 1), w = std::clamp<double>(query.hit.v, 0, 1 - v);
  return SurfacePoint{query.hit.primID, {1 - v - w, v, w}};
}

SurfacePoint Surface::nearest(glm::dvec3 position) const {
  constexpr double far_away = 1e6;  // farther away only the direction matters; keeps 32-bit squares finite
  assert(is_finite(position));
  const double distance = glm::length(position);
  if (distance > far_away) position *= far_away / distance;
  Nearest best{&impl_->mesh, position, 1e-6 * (1 + glm::length(position)), std::numeric_limits<double>::infinity(), {}};
  const glm::vec3 at(position);
  RTCPointQuery query{at.x, at.y, at.z, 0, std::numeric_limits<float>::infinity()};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(impl_->scene.get(), &query, &context, visit_triangle, &best);
  return best.point;
}

void Surface::vertices_within(glm::dvec3 centre, double radius, std::vector<std::uint32_t>& found) const {
  found.clear();
  impl_->points.find_within(impl_->mesh.positions, centre, radius, found);
  std::sort(found.begin(), found.end());
}

void Surface::vertices_along(glm::dvec3 from, glm::dvec3 to, double radius, std::vector<std::uint32_t>& found) const {
  found.clear();
  impl_->points.find_along(impl_->mesh.positions, from, to, radius, found);
  std::sort(found.begin(), found.end());
}

std::span<const std::uint32_t> Surface::neighbours(std::uint32_t vertex) const { return impl_->neighbours.of(vertex); }

const Adjacency& Surface::adjacency() const { return impl_->neighbours; }

glm::dvec3 Surface::position(const SurfacePoint& point) const {
  const auto corners = corners_of(impl_->mesh, point.triangle);
  return point.barycentric.x * corners[0] + point.barycentric.y * corners[1] + point.barycentric.z * corners[2];
}

glm::dvec3 Surface::normal(const SurfacePoint& point) const {
  const glm::uvec3 t = impl_->mesh.triangles[point.triangle];
  const auto& normals = impl_->mesh.normals;
  const glm::dvec3 sum = point.barycentric.x * glm::dvec3(normals[t.x]) +
                         point.barycentric.y * glm::dvec3(normals[t.y]) +
                         point.barycentric.z * glm::dvec3(normals[t.z]);
  const double length = glm::length(sum);
  return length > 1e-12 ? sum / length : glm::normalize(glm::dvec3(normals[t.x]));
}

}  // namespace pelage
