#include "renderer/quality/view_features.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "protocol/base/colour_space.h"

namespace pelage {

namespace {

constexpr std::size_t max_triangles = 16384;  // that are looked at
constexpr double furthest_back_facing =
    -0.6;                                    // cosine from which on fur is drawn, as in renderer/visibility/shell_lod.h
constexpr double nearest = 1e-3;             // distance along the view, sizes
constexpr int cells = 32;                    // of the picture, along each side
constexpr int max_places = 16;               // along a triangle's side
constexpr double near_fur = 0.05;            // depth that still counts as the same part of a body, sizes
constexpr double max_depth_complexity = 16;  // of skin over the picture
constexpr std::size_t max_parts = 6;         // of ViewFeatures::places

/// A place on a triangle inside the picture.
struct Place {
  std::size_t cell = 0;
  double depth = 0;  // along the view, sizes
  double area = 0;   // pixels
  double reach = 0;  // of the fur, sizes
};

class Looker {
 public:
  Looker(const FurFrame& frame, const FurredSkin& skin) : frame_(frame), skin_(skin) {
    focal_ = frame.height / (2.0 * std::max(1e-6, static_cast<double>(frame.camera.tan_half_fov)));
  }

  void look(const glm::uvec3& triangle);
  ViewFeatures features(double stride) const;

 private:
  glm::dvec3 seen(std::uint32_t vertex, double length) const;
  void spread(const std::array<glm::dvec3, 3>& corners, double area, double side, double reach, double bending);
  double share_behind() const;
  std::vector<glm::vec2> spread_places(std::span<const bool> touched) const;

  const FurFrame& frame_;
  const FurredSkin& skin_;
  double focal_ = 1;  // pixels
  double visible_ = 0, edges_ = 0, area_ = 0, fur_ = 0, strand_ = 0, bending_ = 0;
  std::vector<Place> places_;
};

/// Column and row in pixels, and the depth; the middle of the fur's height.
glm::dvec3 Looker::seen(std::uint32_t vertex, double length) const {
  const glm::dvec3 normal(skin_.normals[vertex]);
  const glm::dvec3 offset =
      glm::dvec3(skin_.positions[vertex]) + 0.5 * length * normal - glm::dvec3(frame_.camera.position);
  const double depth = std::max(nearest, glm::dot(offset, glm::dvec3(frame_.camera.forward)));
  return {frame_.width / 2.0 + focal_ * glm::dot(offset, glm::dvec3(frame_.camera.right)) / depth,
          frame_.height / 2.0 - focal_ * glm::dot(offset, glm::dvec3(frame_.camera.up)) / depth, depth};
}

void Looker::look(const glm::uvec3& t) {
  const glm::dvec3 a(skin_.positions[t.x]), b(skin_.positions[t.y]), c(skin_.positions[t.z]);
  const glm::dvec3 normal = glm::cross(b - a, c - a),
                   to_camera = glm::dvec3(frame_.camera.position) - (a + b + c) / 3.0;
  const double size = glm::length(normal) * glm::length(to_camera);
  if (!(size > 0) || glm::dot(normal, to_camera) <= furthest_back_facing * size) return;
  visible_ += 1;
  const double length = (double{skin_.length[t.x]} + skin_.length[t.y] + skin_.length[t.z]) / 3;
  const std::array<glm::dvec3, 3> corners{seen(t.x, length), seen(t.y, length), seen(t.z, length)};
  if (std::max({corners[0].z, corners[1].z, corners[2].z}) <= nearest) return;
  const glm::dvec2 first(corners[1] - corners[0]), second(corners[2] - corners[0]);
  const double area = std::abs(first.x * second.y - first.y * second.x) / 2;
  const double side = glm::length(first) + glm::length(second) + glm::length(glm::dvec2(corners[2] - corners[1]));
  const double turn = glm::distance(skin_.normals[t.x], skin_.normals[t.y]) +
                      double{glm::distance(skin_.normals[t.y], skin_.normals[t.z])};
  const double bending = turn * length / std::max(1e-9, glm::distance(a, b) + glm::distance(b, c));
  spread(corners, area, side, length, std::min(bending, 10.0));
}

void Looker::spread(const std::array<glm::dvec3, 3>& corners, double area, double side, double reach, double bending) {
  const double cell = std::sqrt(double(frame_.width) * frame_.height) / cells;
  const int n = static_cast<int>(std::clamp(std::ceil(std::sqrt(area) / cell), 1.0, double{max_places}));
  const double part = 1.0 / (n * n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < 2 * (n - i) - 1; ++j) {  // the middles of n x n equal triangles
      const double third = j % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
      const double u = (i + third) / n, v = (j / 2 + third) / n;
      const glm::dvec3 at = corners[0] * (1 - u - v) + corners[1] * u + corners[2] * v;
      if (!(at.x >= 0 && at.x < frame_.width && at.y >= 0 && at.y < frame_.height)) continue;
      const int column = static_cast<int>(at.x * cells / frame_.width),
                row = static_cast<int>(at.y * cells / frame_.height);
      const double weight = area * part, pixel = focal_ / at.z;
      places_.push_back({static_cast<std::size_t>(row * cells + column), at.z, weight, reach});
      area_ += weight, edges_ += side * part;
      fur_ += weight * reach * pixel, strand_ += weight * frame_.coat.width_root * pixel, bending_ += weight * bending;
    }
  }
}

double Looker::share_behind() const {
  std::array<double, std::size_t{cells} * cells> front;
  front.fill(1e30);
  for (const Place& place : places_) front[place.cell] = std::min(front[place.cell], place.depth);
  double behind = 0;
  for (const Place& place : places_) {
    if (place.depth > front[place.cell] + near_fur + place.reach) behind += place.area;
  }
  return area_ > 0 ? behind / area_ : 0;
}

/// Along a curve that fills the picture (Morton 1966), so that neighbours in a list of cells are neighbours in the
/// picture.
std::size_t along_curve(std::size_t cell) {
  std::size_t place = 0;
  for (int bit = 0; (1 << bit) < cells; ++bit) {
    place |= (cell % cells >> bit & 1) << (2 * bit);
    place |= (cell / cells >> bit & 1) << (2 * bit + 1);
  }
  return place;
}

std::vector<glm::vec2> Looker::spread_places(std::span<const bool> touched) const {
  std::vector<std::size_t> seen;
  for (std::size_t cell = 0; cell < touched.size(); ++cell) {
    if (touched[cell]) seen.push_back(cell);
  }
  std::sort(seen.begin(), seen.end(), [](std::size_t a, std::size_t b) { return along_curve(a) < along_curve(b); });
  std::vector<glm::vec2> places;
  const std::size_t count = std::min(max_parts, seen.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double in_share =
        std::fmod(0.3 + 0.618034 * static_cast<double>(i), 1.0);  // middles would line up on the curve
    const auto at = static_cast<std::size_t>((static_cast<double>(i) + in_share) * static_cast<double>(seen.size()) /
                                             static_cast<double>(count));
    const std::size_t cell = seen[std::min(at, seen.size() - 1)];
    const glm::vec2 middle(static_cast<float>(cell % cells) + 0.5f, static_cast<float>(cell / cells) + 0.5f);
    places.push_back(middle / float{cells} * glm::vec2(frame_.width, frame_.height));
  }
  return places;
}

double lightness_of(const Coat& coat) {
  double sum = 0;
  for (const RampStop& stop : coat.ramp) sum += double{luminance(stop.colour)};
  return coat.ramp.empty() ? 0 : std::clamp(sum / static_cast<double>(coat.ramp.size()), 0.0, 1.0);
}

ViewFeatures Looker::features(double stride) const {
  ViewFeatures view;
  view.pixels = double(frame_.width) * frame_.height;
  view.visible = visible_ * stride * skin_.pieces;
  const double limit = max_depth_complexity * view.pixels;
  view.area = std::min(area_ * stride * skin_.pieces, limit);
  view.edges = std::min(edges_ * stride * skin_.pieces, limit);
  std::array<bool, std::size_t{cells} * cells> touched{};
  for (const Place& place : places_) touched[place.cell] = true;
  const double touched_share = static_cast<double>(std::count(touched.begin(), touched.end(), true)) / (cells * cells);
  view.covered = std::min(touched_share * view.pixels, area_ * stride);
  view.behind = share_behind();
  view.places = spread_places(touched);
  const double weight = area_ > 0 ? 1 / area_ : 0;
  view.fur_pixels = std::min(fur_ * weight, 1e6), view.strand_pixels = std::min(strand_ * weight, 1e6);
  view.bending = bending_ * weight;
  return view;
}

}  // namespace

ViewFeatures view_features(const FurFrame& frame, const FurredSkin& skin) {
  const std::size_t stride = skin.triangles.size() / max_triangles + 1;
  Looker looker(frame, skin);
  std::size_t looked = 0;
  for (std::size_t i = 0; i < skin.triangles.size(); i += stride, ++looked) looker.look(skin.triangles[i]);
  const double count = static_cast<double>(skin.triangles.size());
  ViewFeatures view = looker.features(looked ? count / static_cast<double>(looked) : 1);
  view.triangles = count * skin.pieces;
  view.lightness = lightness_of(frame.coat);
  view.lights = static_cast<double>(frame.lights.size());
  view.scatters = frame.look.shading != ShadingModel::kajiya && frame.look.shading != ShadingModel::lengyel;
  view.varies = skin.painted || frame.coat.tufts.gather > 0 || frame.coat.pattern.kind != PatternKind::none ||
                !(frame.coat.variation == Variation{});
  return view;
}

int window_side(int width, int height) { return std::clamp(std::min(width, height) / 8, 40, 64); }

FurFrame fur_alone(FurFrame frame) {
  frame.background = Background::transparent;
  frame.ground.reset(), frame.overlay = Overlay::none, frame.difference.clear();
  return frame;
}

FurFrame window_of(const FurFrame& frame, glm::vec2 place, int side) {
  assert(side > 0);
  const FurCamera& whole = frame.camera;
  const glm::vec2 size(frame.width, frame.height);
  const glm::vec2 off = (place - 0.5f * size) * (2 * whole.tan_half_fov / size.y);  // over the distance along the view
  FurFrame window = fur_alone(frame);
  FurCamera& camera = window.camera;
  camera.forward = glm::normalize(whole.forward + off.x * whole.right - off.y * whole.up);
  camera.right = glm::normalize(glm::cross(camera.forward, whole.up));
  camera.up = glm::cross(camera.right, camera.forward);
  // A pixel off the axis spans a smaller angle: by the cosine across, by its square along.
  const float cosine = 1 / std::sqrt(1 + glm::dot(off, off));
  camera.tan_half_fov = whole.tan_half_fov * static_cast<float>(side) / size.y * cosine * std::sqrt(cosine);
  window.width = window.height = side;
  return window;
}

}  // namespace pelage
