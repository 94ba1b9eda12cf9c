// Measures what strands cost to grow: one preparation for each state of the fields, then chunk by chunk on one core.
// usage: bench_grow [--repetitions N] [--triangles N] [--count STRANDS_OF_THE_TILE]
#include "renderer/strands/grow.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "server/frames/fur_view.h"
#include "tests/bench/cost.h"
#include "tests/support/furred_model.h"

namespace pelage::bench {
namespace {

constexpr double strands_each = 8000;

struct Case {
  std::string name;
  Coat coat;
  bool painted = false;
};

std::vector<Case> cases(int count) {
  std::vector<Case> all{{"plain", {}}, {"curly", {}},     {"wet", {}},
                        {"tufts", {}}, {"patterned", {}}, {"painted", {}, true}};
  for (Case& one : all) one.coat.count = count;
  all[1].coat.curl = 0.12;
  all[2].coat.wetness = 0.7;
  all[3].coat.tufts.gather = 0.6;
  all[4].coat.pattern.kind = PatternKind::rosettes, all[4].coat.variation.lightness = 0.3;
  return all;
}

void measure_case(const Case& one, const testing::FurredModel& furred, int repetitions) {
  const Mesh& mesh = furred.model.surface.mesh();
  const FurTriangles patch_triangles = make_fur_triangles(mesh, furred.model.patches);
  const FurModel model{
      1, mesh.positions, mesh.normals, mesh.tangents, patch_triangles.triangles, patch_triangles.corners, {}, true};
  FurFields fields{furred.fields.direction(), furred.fields.length(), {}};
  const std::vector<float> half(mesh.positions.size(), 0.5f);
  const std::vector<glm::vec4> colour(mesh.positions.size(), glm::vec4(0.5f));
  if (one.painted) {
    fields.paint.clump = fields.paint.wetness = fields.paint.width = half;
    fields.paint.root_colour = fields.paint.tip_colour = colour;
  }
  const GrowRecipe recipe{one.coat, true};
  const std::vector<StrandChunk> chunks = make_chunks(model, one.coat, strands_each);
  const Grower grower(model, fields, recipe);
  std::size_t strands = 0, bytes = 0;
  const auto grow_all = [&] {
    strands = bytes = 0;
    for (const StrandChunk& chunk : chunks) {
      const StrandSet set = grower.grow(chunk);
      strands += set.count(), bytes += set.bytes();
    }
  };
  std::uint64_t sum = 0;
  const auto fingerprints = [&] {
    for (const StrandChunk& chunk : chunks) sum ^= grower.fingerprint(chunk);
  };
  const std::vector<Cost> costs = measure_alternating({[&] { Grower(model, fields, recipe); }, grow_all, fingerprints,
                                                       [&] { make_chunks(model, one.coat, strands_each); }},
                                                      repetitions);
  std::printf(
      "%-10s %8zu strands %3d bytes each  prepare %6.1f ms  grow %7.1f ms  %6.2f million/s  "
      "chunk %5.1f ms  fingerprints %5.1f ms  chunks %5.1f ms\n",
      one.name.c_str(), strands, static_cast<int>(bytes / std::max<std::size_t>(strands, 1)), costs[0].cpu,
      costs[1].cpu, static_cast<double>(strands) / costs[1].cpu / 1e3,
      costs[1].cpu / static_cast<double>(chunks.size()), costs[2].cpu, costs[3].cpu);
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) {
  using namespace pelage;
  const int repetitions = bench::argument(count, arguments, "--repetitions", 3);
  const int triangles = bench::argument(count, arguments, "--triangles", 20000);
  const int strands = bench::argument(count, arguments, "--count", 9000);
  const testing::FurredModel creature = testing::furred(BuiltinModel{Builtin::creature, triangles});
  for (const bench::Case& one : bench::cases(strands)) bench::measure_case(one, creature, repetitions);
}
