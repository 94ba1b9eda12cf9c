// Cost of a comb dab against the size of the mesh, and of a flood against a plain copy of the fields.
#include <benchmark/benchmark.h>

#include <memory>

#include "server/groom/evaluate.h"
#include "server/surface/builtin.h"
#include "server/surface/prepare.h"

namespace pelage {
namespace {

struct Furry {
  Surface surface;
  FieldSet fields;
};

Furry furry(int triangles) {
  Result<Mesh> mesh = prepare(make_builtin({Builtin::torus, triangles}), Axis::plus_y, Axis::plus_z, false);
  FieldSet fields = first_groom(*mesh, {});
  return {Surface(std::move(mesh).value()), std::move(fields)};
}

Command stroke_over(const Mesh& mesh, double radius) {
  Comb comb;
  comb.stroke.emplace();
  const glm::dvec3 at = mesh.to_model(glm::dvec3(mesh.positions[0]));
  for (const double step : {0.0, 0.5}) {
    comb.stroke->samples.push_back({PositionPlace{at + glm::dvec3(step * radius * mesh.size, 0, 0)}});
  }
  comb.brush.radius = radius;
  comb.brush.front_faces_only = false;
  return comb;
}

void stroke_on_mesh(benchmark::State& state) {
  const Furry model = furry(static_cast<int>(state.range(0)));
  // The radius falls as the mesh gets finer, so that about as many vertices are touched.
  const Command command = stroke_over(model.surface.mesh(), 0.05 * std::sqrt(10000.0 / static_cast<double>(state.range(0))));
  std::size_t touched = 0;
  for (auto _ : state) touched = evaluate(command, model.surface, model.fields).delta.vertices().size();
  state.counters["touched"] = static_cast<double>(touched);
}
BENCHMARK(stroke_on_mesh)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMicrosecond);

void flood(benchmark::State& state) {
  const Furry model = furry(100000);
  Comb comb;
  comb.flood = true;
  comb.direction = glm::dvec3(0, -1, 0);
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(comb, model.surface, model.fields).delta.vertices().size());
}
BENCHMARK(flood)->Unit(benchmark::kMicrosecond);

void plain_copy(benchmark::State& state) {
  const Furry model = furry(100000);
  for (auto _ : state) benchmark::DoNotOptimize(std::make_unique<FieldSet>(model.fields)->size());
}
BENCHMARK(plain_copy)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pelage

BENCHMARK_MAIN();
