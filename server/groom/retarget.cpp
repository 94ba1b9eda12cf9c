#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <string>

#include "server/fields/field_mix.h"
#include "server/fields/field_set.h"
#include "server/fields/field_writer.h"
#include "server/groom/alignment.h"
#include "server/groom/tools.h"

namespace pelage {

namespace {

using Corners = std::array<MixShare, 3>;

constexpr double far_away = 0.05;  // sizes of the source

/// For each vertex the corners of the source's triangle with its nearest place, and how many of those are far away.
struct Nearest {
  std::vector<Corners> corners;
  std::size_t far = 0;
};

Nearest nearest_corners(const Mesh& mesh, const Surface& source, Alignment align) {
  const Laid laid = lay_over(mesh, source.mesh(), align);
  std::vector<Corners> corners(mesh.positions.size());
  std::atomic<std::size_t> far = 0;
  for_each_run_in_parallel(static_cast<std::uint32_t>(corners.size()), [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t v = begin; v < end; ++v) {
      const glm::dvec3 place = laid.place(glm::dvec3(mesh.positions[v]));
      const SurfacePoint point = source.nearest(place);
      if (glm::distance(source.position(point), place) > far_away) ++far;
      for (std::size_t k = 0; k < 3; ++k) {
        const int corner = static_cast<int>(k);
        corners[v][k] = {source.mesh().triangles[point.triangle][corner], point.barycentric[corner]};
      }
    }
  });
  return {std::move(corners), far};
}

std::string far_warning(std::size_t far, std::size_t vertices) {
  return std::to_string(far) + " of " + std::to_string(vertices) +
         " vertices lie farther than .05 sizes from the model that they take their fur from";
}

/// Whether the command takes the field. The mask chooses where tools work, and goes along only when it is asked for.
bool takes(const Retarget& command, Field field) {
  if (command.fields.empty()) return field != Field::mask;
  return std::count(command.fields.begin(), command.fields.end(), field) > 0;
}

}  // namespace

// (1 - w) V + w S, with S what the source has at its nearest place: at full strength exactly that.
Evaluation run(const Retarget& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  assert(extras.source != nullptr && extras.baseline != nullptr);
  const Surface& source = *extras.source;
  const FieldSet& source_fields = *extras.baseline;
  const Mesh &mesh = surface.mesh(), &other = source.mesh();
  const Nearest found = nearest_corners(mesh, source, command.align);
  const double longer = command.align == Alignment::none ? other.size / mesh.size : 1;
  Evaluation done;
  if (found.far > 0) done.warnings.push_back(far_warning(found.far, found.corners.size()));
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (!takes(command, field) || (fields.at_default(field) && source_fields.at_default(field))) continue;
    const double factor = field == Field::length ? longer : 1;
    const auto put = [&](std::uint32_t v, FieldWriter& writer) {
      const double weight = command.strength * double{fields.number(Field::mask, v)};
      if (weight == 0) return false;
      const glm::dvec4 there =
          to_summable(field, factor * mixed(source_fields, field, found.corners[v], other, mesh, v));
      const glm::dvec4 here = to_summable(field, glm::dvec4(fields.value(field, v)));
      return writer.put(v, from_summable(field, (1 - weight) * here + weight * there));
    };
    done.clamped += write_in_parallel(fields, field, static_cast<std::uint32_t>(fields.size()), done.delta, put);
  }
  return done;
}

}  // namespace pelage
