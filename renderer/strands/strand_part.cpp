#include "renderer/strands/strand_part.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace pelage {

namespace {

glm::vec3 unit_or(glm::vec3 v, glm::vec3 other) {
  const float square = glm::dot(v, v);
  return square > 1e-24f ? v / std::sqrt(square) : other;
}

glm::vec3 mean_root_colour(const StrandSet& strands) {
  glm::dvec3 sum(0);
  const std::size_t knots = static_cast<std::size_t>(strands.segments) + 1;
  for (std::size_t i = 0; i < strands.count(); ++i) sum += glm::dvec3(unpack_colour(strands.colours[i * knots]));
  return strands.count() ? glm::vec3(sum / static_cast<double>(strands.count())) : glm::vec3(0);
}

/// Makes a ribbon for each segment. Embree shares the points, so the strands must not move in memory.
EmbreeGeometry make_ribbons(RTCDevice device, const StrandSet& strands) {
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_FLAT_LINEAR_CURVE));
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, strands.points.data(), 0,
                             sizeof(StrandPoint), strands.points.size());
  if (!strands.closing.empty()) {
    rtcSetGeometryTimeStepCount(geometry.get(), 2);
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 1, RTC_FORMAT_FLOAT4, strands.closing.data(), 0,
                               sizeof(StrandPoint), strands.closing.size());
  }
  const auto segments = static_cast<std::uint32_t>(strands.segments);
  auto* first = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, sizeof(std::uint32_t), strands.count() * segments));
  if (!first) return nullptr;
  for (std::uint32_t i = 0; i < strands.count(); ++i) {
    for (std::uint32_t k = 0; k < segments; ++k) *first++ = i * (segments + 1) + k;
  }
  return geometry;
}

}  // namespace

bool MemoryBudget::take(std::ptrdiff_t bytes) {
  const std::ptrdiff_t now = used_ += bytes;
  if (bytes <= 0 || static_cast<std::size_t>(now) <= limit_) return true;
  used_ -= bytes;
  return false;
}

void StrandPart::drop() {
  index_.reset();
  budget_.take(-static_cast<std::ptrdiff_t>(strands_.bytes()));
  strands_ = {};
}

bool StrandPart::set(RTCDevice device, StrandSet strands) {
  drop();
  if (!budget_.take(static_cast<std::ptrdiff_t>(strands.bytes()))) return false;
  strands_ = std::move(strands);
  root_colour_ = mean_root_colour(strands_);
  if (strands_.count() == 0) return true;
  const EmbreeGeometry ribbons = make_ribbons(device, strands_);
  if (ribbons) {
    rtcSetGeometryUserData(ribbons.get(), this);
    rtcCommitGeometry(ribbons.get());
    index_.reset(rtcNewScene(device));
    rtcSetSceneFlags(index_.get(), RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    rtcAttachGeometryByID(index_.get(), ribbons.get(), 0);
    run_on_this_thread([&] { rtcCommitScene(index_.get()); });
  }
  const bool indexed = rtcGetDeviceError(device) == RTC_ERROR_NONE && ribbons;
  if (!indexed) drop();
  return indexed;
}

std::size_t StrandPart::first_point(std::uint32_t segment) const {
  const auto segments = static_cast<std::uint32_t>(strands_.segments);
  return segment / segments * (segments + 1) + segment % segments;
}

Hit StrandPart::hit(const Ray& ray, float distance, std::uint32_t segment, float u) const {
  const auto segments = static_cast<std::uint32_t>(strands_.segments);
  const std::uint32_t k = segment % segments;
  const std::size_t at = first_point(segment);
  const StrandPoint* point = &strands_.points[at];
  const auto position = [&](int i) {
    const glm::vec3 opening = point[i].position;
    if (strands_.closing.empty()) return opening;
    return glm::mix(opening, (&strands_.closing[at])[i].position, ray.time);
  };
  const glm::vec3 low = position(0), high = position(1);
  const glm::vec3 along = unit_or(high - low, ray.direction);
  const glm::vec3 before = k > 0 ? unit_or(high - position(-1), along) : along;
  const glm::vec3 after = k + 1 < segments ? unit_or(position(2) - low, along) : along;

  const StrandId strand = strand_of(segment);
  const StrandRoot& root = strands_.roots[strand.strand];
  Hit hit{.kind = HitKind::strand, .distance = distance, .normal = root.normal, .strand = strand};
  hit.tangent = unit_or(glm::mix(before, after, u), along);
  hit.radius = glm::mix(point[0].radius, point[1].radius, u);
  const glm::vec3 off = ray.origin + ray.direction * distance - glm::mix(low, high, u);
  const glm::vec3 aside = unit_or(glm::cross(hit.tangent, -ray.direction), glm::vec3(0));
  hit.offset = std::clamp(glm::dot(off, aside) / std::max(hit.radius, 1e-12f), -1.0f, 1.0f);
  hit.height = root.reach * (static_cast<float>(k) + u) / static_cast<float>(segments);
  hit.colour = glm::mix(unpack_colour(strands_.colours[at]), unpack_colour(strands_.colours[at + 1]), u);
  hit.number = root.number, hit.wetness = root.wetness;
  return hit;
}

glm::vec3 StrandPart::relative_depth(std::uint32_t segment, float u) const {
  const std::size_t at = first_point(segment);
  const glm::vec3 colour = glm::mix(unpack_colour(strands_.colours[at]), unpack_colour(strands_.colours[at + 1]), u);
  return 1.0f - pale_transmittance * glm::sqrt(glm::min(colour, 1.0f));
}

}  // namespace pelage
