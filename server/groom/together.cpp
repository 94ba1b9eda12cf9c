#include "server/groom/together.h"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "server/fields/field_writer.h"

namespace pelage {

namespace {

constexpr std::uint32_t no_vertex = 0xffffffff;

/// Reads one image's change of a field, vertex by vertex in rising order.
class Reading {
 public:
  Reading(const FieldDelta::Part& part, const FieldSet& fields)
      : part_(part), fields_(fields), channels_(shape_of(part.field).channels) {}

  std::uint32_t vertex() const { return next_ < part_.vertices.size() ? part_.vertices[next_] : no_vertex; }
  /// Returns the change of the value at the vertex, in summable form, and moves on to the next vertex.
  glm::dvec4 take() {
    const glm::vec4 before = fields_.value(part_.field, vertex());
    glm::vec4 after = before;
    for (int c = 0; c < channels_; ++c) {
      const std::uint32_t flips =
          part_.flips[next_ * static_cast<std::size_t>(channels_) + static_cast<std::size_t>(c)];
      after[c] = std::bit_cast<float>(std::bit_cast<std::uint32_t>(before[c]) ^ flips);
    }
    ++next_;
    return to_summable(part_.field, after) - to_summable(part_.field, before);
  }

 private:
  const FieldDelta::Part& part_;
  const FieldSet& fields_;
  int channels_;
  std::size_t next_ = 0;
};

void add_field(Field field, std::vector<Reading> readings, const FieldSet& fields, FieldDelta& delta) {
  FieldWriter writer(fields, field);
  const auto next_vertex = [&] {
    std::uint32_t next = no_vertex;
    for (const Reading& reading : readings) next = std::min(next, reading.vertex());
    return next;
  };
  for (std::uint32_t vertex = next_vertex(); vertex != no_vertex; vertex = next_vertex()) {
    glm::dvec4 sum(0);
    double lengths = 0;
    for (Reading& reading : readings) {
      if (reading.vertex() != vertex) continue;
      const glm::dvec4 change = reading.take();
      const double length = glm::length(change);
      sum += length * change, lengths += length;
    }
    const glm::dvec4 now = to_summable(field, fields.value(field, vertex));
    writer.put(vertex, from_summable(field, lengths > 0 ? now + sum / lengths : now));
  }
  writer.finish(delta);
}

}  // namespace

FieldDelta combine_symmetry_images(std::span<const FieldDelta> images, const FieldSet& fields) {
  if (images.size() == 1) return images.front();
  FieldDelta delta;
  for (std::size_t f = 0; f < field_count; ++f) {
    std::vector<Reading> readings;
    for (const FieldDelta& image : images)
      if (const FieldDelta::Part* part = image.part(field_at(f), visible_sheet, fields.owner(field_at(f))))
        readings.emplace_back(*part, fields);
    add_field(field_at(f), std::move(readings), fields, delta);
  }
  return delta;
}

}  // namespace pelage
