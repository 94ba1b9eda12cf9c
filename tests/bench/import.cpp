// Measures what a large model costs on its way into a scene: the confined worker reads it, then it is prepared, covered
// by patches, indexed and given its first groom.
// usage: bench_import [--triangles N]
#include "server/import/import.h"

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

#include "server/builtin/builtin.h"
#include "server/fields/field_set.h"
#include "server/groom/first_groom.h"
#include "server/patches/patches.h"
#include "server/surface/prepare.h"
#include "server/surface/surface.h"
#include "tests/bench/cost.h"

namespace pelage::bench {
namespace {

template <class Number>
void put(std::string& text, Number number) {
  text.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Encodes the model as a binary PLY.
std::string ply_of(const RawModel& model) {
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(model.positions.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(model.face_sizes.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const glm::dvec3 p : model.positions) put(text, float(p.x)), put(text, float(p.y)), put(text, float(p.z));
  std::size_t corner = 0;
  for (const std::uint32_t size : model.face_sizes) {
    put(text, static_cast<unsigned char>(size));
    for (std::uint32_t k = 0; k < size; ++k) put(text, static_cast<std::int32_t>(model.corners[corner++]));
  }
  return text;
}

template <class T>
T value_of(Result<T> result) {
  if (!result) std::fprintf(stderr, "%s\n", result.status().message.c_str()), std::exit(1);
  return std::move(result).value();
}

double seconds(const char* what, const std::function<void()>& work) {
  const Cost cost = measure(work);
  std::printf("| %s | %.2f | %.2f |\n", what, cost.wall / 1e3, cost.cpu / 1e3);
  std::fflush(stdout);
  return cost.wall / 1e3;
}

void run(const char* name, Builtin shape, int triangles) {
  const std::string ply = ply_of(make_builtin({shape, triangles}));
  std::printf("%s, %d triangles\n\n| step | wall, s | CPU, s |\n|---|---|---|\n", name, triangles);
  const double before = resident_bytes();
  std::optional<RawModel> raw;
  std::optional<Mesh> mesh;
  std::optional<Surface> surface;
  std::optional<PatchMap> patches;
  std::optional<FieldSet> fields;
  double sum = seconds("worker and its answer", [&] {
    raw = value_of(import_model(PELAGE_IMPORT, ModelFormat::ply, std::as_bytes(std::span(ply))));
  });
  sum += seconds("prepare", [&] { mesh = value_of(prepare(*raw, {.source_is_32_bit = raw->is_32_bit})); });
  raw.reset();
  sum += seconds("patches", [&] { patches = lay_patches(*mesh); });
  sum += seconds("surface", [&] { surface.emplace(std::move(*mesh)); });
  sum += seconds("first groom", [&] { fields = first_groom(surface->mesh(), {}); });
  const auto vertices = static_cast<double>(fields->size());
  std::printf("| all | %.2f | |\n\nin memory after it: %.0f bytes a vertex (%.0f vertices)\n\n", sum,
              (resident_bytes() - before) / vertices, vertices);
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) {
  using namespace pelage;
  const int triangles = bench::argument(count, arguments, "--triangles", 1'000'000);
  bench::run("torus", Builtin::torus, triangles);
  bench::run("creature", Builtin::creature, triangles);
  return 0;
}
