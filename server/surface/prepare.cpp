#include "server/surface/prepare.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "base/limits.h"
#include "server/surface/faces.h"
#include "server/surface/materials.h"
#include "server/surface/outliers.h"
#include "server/surface/shading_normals.h"
#include "server/surface/weld.h"

namespace pelage {

namespace {

/// Returns the normal of a triangle, with twice its area as length.
glm::dvec3 area_vector(const Soup& soup, const glm::uvec3& t) {
  return glm::cross(soup.positions[t.y] - soup.positions[t.x], soup.positions[t.z] - soup.positions[t.x]);
}

std::vector<glm::dvec3> vertex_normals(const Soup& soup) {
  constexpr double cancelled = 1e-9;
  std::vector<glm::dvec3> sums(soup.positions.size(), glm::dvec3(0)), first(sums);
  std::vector<double> areas(soup.positions.size(), 0);
  for (const glm::uvec3& t : soup.triangles) {
    const glm::dvec3 vector = area_vector(soup, t);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = t[k];
      if (areas[v] == 0) first[v] = vector;
      sums[v] += vector;
      areas[v] += glm::length(vector);
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const glm::dvec3 sum = glm::length(sums[v]) > cancelled * areas[v] ? sums[v] : first[v];
    const double length = glm::length(sum);
    sums[v] = length > 0 ? sum / length : glm::dvec3(0, 1, 0);
  }
  return sums;
}

// Back sides of open sheets that grow fur on both sides: an ear, a wing, a leaf.

/// Distance between the two sides, in sizes: less than a strand's width, and enough that neither shows through the
/// other.
constexpr double sheet_thickness = 1e-3;

/// Appends a copy of the parts in `numbers`, from 1, with vertices of their own and the opposite winding. Returns the
/// number of vertices before that.
std::size_t add_backs(Soup& soup, const Orientation& orientation, const std::vector<std::uint32_t>& numbers) {
  const std::size_t fronts = soup.positions.size(), triangles = soup.triangles.size();
  std::vector<std::uint32_t> back(fronts, no_position);
  const auto back_of = [&](std::uint32_t v) {
    if (back[v] != no_position) return back[v];
    back[v] = static_cast<std::uint32_t>(soup.positions.size());
    soup.positions.push_back(glm::dvec3(soup.positions[v]));
    soup.sources.push_back(std::uint32_t{soup.sources[v]});
    return back[v];
  };
  for (std::size_t t = 0; t < triangles; ++t) {
    if (std::find(numbers.begin(), numbers.end(), orientation.part_of[t] + 1) == numbers.end()) continue;
    const glm::uvec3 vertices = soup.triangles[t], corners = soup.corners[t];
    soup.add({back_of(vertices.x), back_of(vertices.z), back_of(vertices.y)}, {corners.x, corners.z, corners.y},
             soup.faces[t]);
  }
  return fronts;
}

/// Moves the vertices from `first` on by sheet_thickness along their normals, away from the front sides.
void lift_backs(Mesh& mesh, std::size_t first) {
  for (std::size_t v = first; v < mesh.positions.size(); ++v)
    mesh.positions[v] += static_cast<float>(sheet_thickness) * mesh.normals[v];
}

}  // namespace

glm::dvec3 tailward(glm::dvec3 normal) {
  constexpr double vanishing = 1e-4;
  for (const glm::dvec3 preferred : {glm::dvec3(0, 0, -1), glm::dvec3(0, -1, 0)}) {
    const glm::dvec3 tangent = preferred - glm::dot(preferred, normal) * normal;
    const double length = glm::length(tangent);
    if (length > vanishing) return tangent / length;
  }
  assert(false && "a unit vector is along -Z or along -Y, not both");
  return {1, 0, 0};
}

Frames make_frames(const Soup& soup) {
  Frames frames;
  for (const glm::dvec3& normal : vertex_normals(soup)) {
    frames.normals.emplace_back(normal);
    frames.tangents.emplace_back(tailward(normal));
  }
  return frames;
}

namespace {

Status refusal(std::string message, std::string limit = {}) {
  return failure(Code::invalid, std::move(message), "", std::move(limit));
}

glm::dvec3 direction_of(Axis axis) {
  glm::dvec3 direction(0);
  const int index = static_cast<int>(axis);
  direction[index / 2] = index % 2 == 0 ? 1 : -1;
  return direction;
}

Status check_count(std::size_t triangles) {
  if (triangles <= limits::model_triangles) return {};
  return refusal("The model has " + std::to_string(triangles) + " triangles.",
                 "at most " + std::to_string(limits::model_triangles));
}

Status check_triangle_count(const RawModel& raw) {
  std::size_t triangles = 0;
  for (std::uint32_t corners : raw.face_sizes) triangles += corners > 2 ? corners - 2 : 0;
  return check_count(triangles);
}

/// Checks that the spacing of 32-bit numbers at the largest coordinate is small compared to the model.
Status check_precision(const Placement& placement) {
  const double largest = std::max({std::abs(placement.low.x), std::abs(placement.low.y), std::abs(placement.low.z),
                                   std::abs(placement.high.x), std::abs(placement.high.y), std::abs(placement.high.z)});
  if (largest * 0x1p-23 <= limits::model_precision * placement.size) return {};
  return refusal(
      "precision: the model lies so far from its origin that its 32-bit coordinates are coarser than 1e-4 "
      "of its size; move it to the origin, or send it in a text format.",
      "32-bit steps of at most 1e-4 of the size");
}

struct Count {
  const char* code;
  std::size_t count;
};

void add_repairs(ModelReport& report, std::initializer_list<Count> counts) {
  for (const Count& entry : counts) {
    if (entry.count > 0) report.repairs.push_back({entry.code, entry.count});
  }
}

/// Triangulates all polygons; positions become internal.
Soup split_polygons(const RawModel& raw, const Polygons& polygons, const Placement& placement, ModelReport& report) {
  Soup soup;
  soup.sources = polygons.sources;
  for (const glm::dvec3& p : polygons.positions) soup.positions.push_back(placement.to_internal(p));
  std::vector<std::uint32_t> vertices;
  std::size_t split = 0, degenerate = 0;
  for (const Polygons::Face& face : polygons.faces) {
    vertices.clear();
    for (std::uint32_t i = 0; i < face.size; ++i) vertices.push_back(polygons.vertex[raw.corners[face.begin + i]]);
    const auto triangles = triangulate(vertices, soup.positions);
    for (const auto& [a, b, c] : triangles) {
      soup.add({vertices[a], vertices[b], vertices[c]}, {face.begin + a, face.begin + b, face.begin + c}, face.source);
    }
    if (triangles.empty())
      ++degenerate;
    else if (face.size > 3)
      ++split;
  }
  add_repairs(report, {{"degenerate_faces", degenerate}, {"split_polygons", split}});
  return soup;
}

/// Centres and scales the mesh by the box of the remaining vertices.
void centre_and_scale(Mesh& mesh, const RawModel& raw, const Soup& soup, const glm::dmat3& rotation) {
  std::vector<glm::dvec3> positions;
  for (std::uint32_t source : soup.sources) {
    positions.push_back(rotation * raw.positions[source]);
    mesh.length_scale.push_back(raw.length_scale.empty() ? 1.0f : raw.length_scale[source]);
  }
  const Placement placement = placement_of(positions);
  for (const glm::dvec3& p : positions) mesh.positions.emplace_back(placement.to_internal(p));
  mesh.centre = placement.centre;
  mesh.size = mesh.report.size = placement.size;
  mesh.report.bounds.min = placement.low;
  mesh.report.bounds.max = placement.high;
}

Mesh finish(const RawModel& raw, const Soup& soup, const glm::dmat3& rotation, ModelReport report) {
  Mesh mesh;
  mesh.report = std::move(report);
  centre_and_scale(mesh, raw, soup, rotation);
  Frames frames = make_frames(soup);
  mesh.normals = std::move(frames.normals);
  mesh.tangents = std::move(frames.tangents);
  mesh.triangles = soup.triangles;
  mesh.corners = look_corners(raw, soup);
  if (!mesh.corners.empty()) mesh.images = raw.images;
  mesh.texture_uv = texture_corners(raw, soup);
  name_materials(raw, soup, mesh);
  mesh.report.source_vertices = raw.positions.size();
  mesh.report.source_faces = raw.face_sizes.size();
  mesh.report.vertices = mesh.positions.size();
  mesh.report.triangles = mesh.triangles.size();
  mesh.report.parts = count_parts(soup);
  return mesh;
}

}  // namespace

namespace {

/// Returns the parts for the report with the flag `is_named`, with centres in the file's coordinates.
std::vector<NumberedPart> numbered_parts(const Orientation& orientation, bool OrientedPart::*is_named,
                                         const Placement& placement, const glm::dmat3& rotation) {
  std::vector<NumberedPart> named;
  for (std::size_t i = 0; i < orientation.parts.size(); ++i) {
    const OrientedPart& part = orientation.parts[i];
    if (!(part.*is_named)) continue;
    const glm::dvec3 centre = part.box.centre * placement.size + placement.centre;
    named.push_back({static_cast<int>(i + 1), part.triangles, glm::transpose(rotation) * centre});
  }
  return named;
}

Status check_parts(const Orientation& orientation, const std::vector<std::uint32_t>& numbers, const char* pointer) {
  for (const std::uint32_t part : numbers) {
    if (part >= 1 && part <= orientation.parts.size()) continue;
    return failure(Code::invalid, "The model has no part " + std::to_string(part) + ".", pointer,
                   "[1, " + std::to_string(orientation.parts.size()) + "]");
  }
  return {};
}

Status check_parts(const Orientation& orientation, const PrepareOptions& options) {
  const Status flipped = check_parts(orientation, options.flipped_parts, "/flip");
  return flipped.ok() ? check_parts(orientation, options.two_sided_parts, "/two_sided") : flipped;
}

}  // namespace

Result<Mesh> prepare(const RawModel& raw, const PrepareOptions& options) {
  Result<PreparedMesh> prepared = prepare_with_sources(raw, options);
  if (!prepared) return prepared.status();
  return std::move(prepared->mesh);
}

glm::dmat3 axes_rotation(Axis up, Axis front) {
  const glm::dvec3 y = direction_of(up), z = direction_of(front);
  return glm::transpose(glm::dmat3(glm::cross(y, z), y, z));
}

Axis axis_mapped_to(const glm::dmat3& rotation, Axis to) {
  const glm::dvec3 from = glm::transpose(rotation) * direction_of(to);
  int line = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(from[k]) > std::abs(from[line])) line = k;
  return static_cast<Axis>(2 * line + (from[line] < 0 ? 1 : 0));
}

Result<PreparedMesh> prepare_with_sources(const RawModel& raw, const PrepareOptions& options) {
  const auto [up, front] = std::pair(options.up, options.front);
  if (glm::dot(direction_of(up), direction_of(front)) != 0) {
    return failure(Code::invalid, "up and front lie on the same axis.", "/front", "another axis than up");
  }
  if (Status status = check_triangle_count(raw); !status.ok()) return status;
  const glm::dmat3 rotation = axes_rotation(up, front);
  const Result<Polygons> polygons = weld(raw, rotation);
  if (!polygons.ok()) return polygons.status();
  if (polygons->faces.empty()) return refusal("The model has no face with three finite vertices.");
  const Placement placement = placement_of(polygons->positions);
  if (!(placement.size > 0)) return refusal("All vertices of the model lie on one point.");
  if (options.source_is_32_bit) {
    if (Status status = check_precision(placement); !status.ok()) return status;
  }

  ModelReport report;
  report.up = up, report.front = front, report.pose = raw.pose, report.animations = raw.animations;
  report.repairs = raw.losses;
  add_repairs(report, {{"invalid_faces", polygons->bad(BadFace::corners)},
                       {"bad_indices", polygons->bad(BadFace::vertices)},
                       {"non_finite_faces", polygons->bad(BadFace::numbers)},
                       {"unused_vertices", raw.positions.size() - polygons->used},
                       {"welded_vertices", polygons->used - polygons->positions.size()}});
  Soup soup = split_polygons(raw, *polygons, placement, report);
  const std::size_t repeated = drop_repeated(soup);
  if (soup.triangles.empty()) return refusal("No triangle of the model has an area.");
  drop_unused(soup);
  const Orientation orientation = orient(soup, options.flipped_parts);
  if (Status status = check_parts(orientation, options); !status.ok()) return status;
  report.doubtful_parts = numbered_parts(orientation, &OrientedPart::doubtful, placement, rotation);
  if (orientation.parts.size() > 1)
    report.sheets = numbered_parts(orientation, &OrientedPart::sheet, placement, rotation);
  const Outliers outliers = find_outliers(soup, orientation);
  add_repairs(report, {{"repeated_faces", repeated},
                       {"flipped_triangles", orientation.flipped_triangles},
                       {"one_sided_edges", orientation.one_sided_edges},
                       {"non_manifold_edges", orientation.non_manifold_edges},
                       {"open_edges", orientation.open_edges},
                       {"far_vertices", outliers.far_vertices},
                       {"far_parts", outliers.far_parts},
                       {"tiny_parts", outliers.tiny_parts},
                       {"unusable_uvs", count_unusable_uvs(raw, soup)}});
  const std::size_t fronts = add_backs(soup, orientation, options.two_sided_parts);
  if (Status status = check_count(soup.triangles.size()); !status.ok()) return status;
  Mesh mesh = finish(raw, soup, rotation, std::move(report));
  lift_backs(mesh, fronts);
  mesh.shading_normals = shading_normals(soup.positions, mesh.triangles, mesh.normals, options.crease_degrees);
  for (const std::uint32_t v : grow_over_creases(mesh.triangles, mesh.shading_normals, mesh.normals))
    mesh.tangents[v] = glm::vec3(tailward(glm::normalize(glm::dvec3(mesh.normals[v]))));
  return PreparedMesh{std::move(mesh), std::move(soup.sources), rotation};
}

}  // namespace pelage
