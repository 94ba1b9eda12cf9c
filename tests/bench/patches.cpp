// Quality and cost of patches on the built-in models and on those of the shared folder, as a table in Markdown.
// usage: bench_patches [FILE...]
#include "server/patches/patches.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <numeric>
#include <span>

#include "base/random.h"
#include "base/stopwatch.h"
#include "server/builtin/builtin.h"
#include "server/surface/surface.h"
#include "tests/unit/surface/shared_models.h"

namespace pelage {
namespace {

double seconds_of(const std::function<void()>& work) {
  const Stopwatch passed;
  work();
  return passed.seconds();
}

glm::dvec3 corner(const Mesh& mesh, std::uint32_t triangle, int k) {
  return glm::dvec3(mesh.positions[mesh.triangles[triangle][k]]);
}

double area_of(const Mesh& mesh, std::uint32_t t) {
  const glm::dvec3 a = corner(mesh, t, 0);
  return 0.5 * glm::length(glm::cross(corner(mesh, t, 1) - a, corner(mesh, t, 2) - a));
}

double surface_area(const Mesh& mesh) {
  double sum = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) sum += area_of(mesh, t);
  return sum;
}

/// Weighted mean, and the 95th percentile by weight.
struct Spread {
  double mean = 0, high = 0;
};

Spread spread_of(std::vector<std::pair<double, double>> values) {
  std::sort(values.begin(), values.end());
  double total = 0, sum = 0, below = 0;
  for (const auto& [value, weight] : values) total += weight, sum += value * weight;
  Spread spread{sum / total, 0};
  for (const auto& [value, weight] : values) {
    if (below <= 0.95 * total) spread.high = value;
    below += weight;
  }
  return spread;
}

/// Positions on the surface, each with its normal.
struct Points {
  std::vector<glm::vec3> positions, normals;

  void add(const Mesh& mesh, std::uint32_t t, glm::dvec3 b) {
    glm::dvec3 position(0), normal(0);
    for (int k = 0; k < 3; ++k) {
      position += b[k] * corner(mesh, t, k);
      normal += b[k] * glm::dvec3(mesh.normals[mesh.triangles[t][k]]);
    }
    positions.emplace_back(position), normals.emplace_back(normal);
  }
};

glm::dvec3 random_barycentric(Random& random) {
  const double root = std::sqrt(random.uniform()), v = random.uniform();
  return {1 - root, root * (1 - v), root * v};
}

/// Random points spread evenly over the surface, `density` per unit of area.
Points even_points(const Mesh& mesh, double density, std::uint64_t seed) {
  Points points;
  Random random(seed);
  double due = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (due += density * area_of(mesh, t); due > 1; due -= 1) points.add(mesh, t, random_barycentric(random));
  }
  return points;
}

/// Random roots of a periodic tile, in a grid for fast lookup.
class Tile {
 public:
  static constexpr double side = 0.12;
  static constexpr int count = 9000, cells = 64;

  Tile() : grid_(cells * cells) {
    Random random(5);
    for (std::uint32_t i = 0; i < count; ++i) {
      roots_.emplace_back(random.uniform(), random.uniform());
      const glm::ivec2 cell(roots_.back() * double(cells));
      grid_[static_cast<std::size_t>(cell.y * cells + cell.x)].push_back(i);
    }
  }

  /// Visits each root between `low` and `high` (in tiles) with its position there and its index.
  template <class Visit>
  void visit(glm::dvec2 low, glm::dvec2 high, const Visit& visit) const {
    const glm::ivec2 first(glm::floor(low * double(cells))), last(glm::floor(high * double(cells)));
    for (int y = first.y; y <= last.y; ++y) {
      for (int x = first.x; x <= last.x; ++x) {
        const glm::ivec2 cell((x % cells + cells) % cells, (y % cells + cells) % cells);
        const glm::dvec2 shift = glm::dvec2(x - cell.x, y - cell.y) / double(cells);
        const std::vector<std::uint32_t>& roots = grid_[static_cast<std::size_t>(cell.y * cells + cell.x)];
        for (const std::uint32_t i : roots) visit(roots_[i] + shift, i);
      }
    }
  }

 private:
  std::vector<glm::dvec2> roots_;
  std::vector<std::vector<std::uint32_t>> grid_;
};

/// The strands of the map: the tile's roots in each patch triangle, thinned by its weight.
Points strands_of(const Mesh& mesh, const PatchMap& map) {
  const Tile tile;
  Points points;
  for (const PatchTriangle& patch_triangle : map.patch_triangles) {
    std::array<glm::dvec2, 3> uv;
    glm::dvec3 weight;
    for (int k = 0; k < 3; ++k) {
      const PatchPoint& point = map.points[patch_triangle.points[k]];
      uv[static_cast<std::size_t>(k)] = glm::dvec2(point.uv) / Tile::side;
      weight[k] = double{point.weight};
    }
    const glm::dvec2 d1 = uv[1] - uv[0], d2 = uv[2] - uv[0];
    const double determinant = d1.x * d2.y - d1.y * d2.x;
    if (determinant == 0) continue;
    const glm::dvec2 low = glm::min(glm::min(uv[0], uv[1]), uv[2]), high = glm::max(glm::max(uv[0], uv[1]), uv[2]);
    tile.visit(low, high, [&](glm::dvec2 at, std::uint32_t i) {
      const glm::dvec2 d = at - uv[0];
      const double v = (d.x * d2.y - d.y * d2.x) / determinant, w = (d1.x * d.y - d1.y * d.x) / determinant;
      if (v < 0 || w < 0 || v + w > 1) return;
      const glm::dvec3 b(1 - v - w, v, w);
      const glm::i64vec2 whole(glm::floor(at));
      Random random(mix_bits(i + 1) ^ mix_bits(static_cast<std::uint64_t>(whole.x * 4096 + whole.y)),
                    patch_triangle.patch);
      if (random.uniform() < glm::dot(b, weight)) points.add(mesh, patch_triangle.triangle, b);
    });
  }
  return points;
}

/// Standard deviation over mean of the strands per unit of area, over discs that hold 200 strands on average. A disc is
/// the part of the surface that lies in a ball and faces the same side as its centre. Its area is measured with evenly
/// spread points; discs cut off by a border are left out.
double density_variation(const Mesh& mesh, const PatchMap& map) {
  constexpr double density = Tile::count / (Tile::side * Tile::side), wanted = 200, oversampling = 8;
  constexpr int discs = 2000;
  const Points strands = strands_of(mesh, map), even = even_points(mesh, oversampling * density, 6);
  const Points centres = even_points(mesh, discs / surface_area(mesh), 7);
  const PointTree strand_tree(strands.positions), even_tree(even.positions);
  const double radius = std::sqrt(wanted / density / 3.14159265358979);
  std::vector<std::uint32_t> found;
  const auto count = [&](const Points& points, const PointTree& tree, std::size_t c) {
    found.clear();
    tree.find_within(points.positions, glm::dvec3(centres.positions[c]), radius, found);
    return static_cast<double>(std::count_if(found.begin(), found.end(), [&](std::uint32_t i) {
      return glm::dot(points.normals[i], centres.normals[c]) > 0;
    }));
  };
  double n = 0, sum = 0, squares = 0;
  for (std::size_t c = 0; c < centres.positions.size(); ++c) {
    const double area = count(even, even_tree, c) / oversampling;
    if (area < 0.7 * wanted) continue;
    const double value = count(strands, strand_tree, c) / area;
    n += 1, sum += value, squares += value * value;
  }
  return n > 1 ? std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n))) / (sum / n) : 0;
}

void print_row(const std::string& name, const Mesh& mesh) {
  PatchMap map;
  const double seconds = seconds_of([&] { map = lay_patches(mesh); });
  std::vector<std::pair<double, double>> areas, angles;
  double patch_triangle_area = 0, flipped = 0;
  for (const PatchTriangle& patch_triangle : map.patch_triangles) {
    const Stretch stretch = stretch_of(mesh, map, patch_triangle);
    const double area = area_of(mesh, patch_triangle.triangle);
    areas.emplace_back(std::max(stretch.area(), 1 / std::max(stretch.area(), 1e-6)), area);
    angles.emplace_back(stretch.large / std::max(stretch.small, 1e-6), area);
    patch_triangle_area += area;
    flipped += stretch.flipped ? area : 0;
  }
  const Spread area = spread_of(areas), angle = spread_of(angles);
  std::printf("| %s | %zu | %u | %.2f | %.2f | %.3f / %.3f | %.3f / %.3f | %.4f | %.3f | %.3f | %.2f |\n", name.c_str(),
              mesh.triangles.size(), map.patches, double(map.patch_triangles.size()) / double(mesh.triangles.size()),
              patch_triangle_area / surface_area(mesh), area.mean, area.high, angle.mean, angle.high,
              flipped / patch_triangle_area, density_variation(mesh, map),
              density_variation(mesh, with_hard_borders(map)), seconds);
  std::fflush(stdout);
}

void print_builtins() {
  const std::pair<const char*, BuiltinModel> models[] = {
      {"torus", {Builtin::torus, 567}},         {"knot", {Builtin::knot, 2880}},
      {"sphere", {Builtin::sphere, 5000}},      {"plane", {Builtin::plane, 2000}},
      {"cloth", {Builtin::cloth, 1401}},        {"creature", {Builtin::creature, 5000}},
      {"creature", {Builtin::creature, 40'000}}};
  for (const auto& [name, model] : models) {
    const Result<Mesh> mesh = prepare(make_builtin(model));
    if (mesh.ok()) print_row(name, *mesh);
  }
}

void print_file(const std::string& path) {
  const Result<Mesh> mesh = shared_models::load_file(path);
  const std::string name = std::filesystem::path(path).filename().string();
  if (mesh.ok())
    print_row(name, *mesh);
  else
    std::printf("| %s | refused: %s |\n", name.c_str(), mesh.status().message.c_str());
}

std::vector<std::string> shared_files() {
  std::vector<std::string> files;
  if (shared_models::folder().empty()) return files;
  for (const auto& entry : std::filesystem::directory_iterator(shared_models::folder())) {
    if (shared_models::format_of(entry.path().string())) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace
}  // namespace pelage

int main(int count, char** arguments) {
  using namespace pelage;
  std::puts(
      "| model | triangles | patches | patch triangles / triangles | area factor | area stretch, mean / 95% | "
      "angle stretch, mean / 95% | flipped | spread of density | with hard borders | seconds |");
  std::puts("|---|---|---|---|---|---|---|---|---|---|---|");
  const std::vector<std::string> named(arguments + 1, arguments + count);
  if (named.empty()) print_builtins();
  for (const std::string& file : named.empty() ? shared_files() : named) print_file(file);
}
