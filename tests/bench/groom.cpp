// Tables of what grooming costs: dabs and undo by the size of the mesh, bytes in the undo log, floods against a plain
// copy of the same arrays.
// usage: bench_groom [--repetitions N] [--few VERTICES] [--many VERTICES] [--flood VERTICES]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <type_traits>

#include "base/random.h"
#include "server/builtin/builtin.h"
#include "server/groom/evaluate.h"
#include "server/groom/first_groom.h"
#include "server/history/codec.h"
#include "server/history/journal.h"
#include "server/scene/scene.h"
#include "server/surface/prepare.h"
#include "tests/bench/cost.h"

namespace pelage::bench {
namespace {

constexpr double dab_vertices = 1000;

/// A torus, which has half as many vertices as triangles.
Surface torus(int vertices) {
  Result<Mesh> mesh = prepare(make_builtin({Builtin::torus, 2 * vertices}));
  if (!mesh) std::fprintf(stderr, "%s\n", mesh.status().message.c_str()), std::exit(1);
  return Surface(std::move(mesh).value());
}

/// Radius of balls around vertices that hold `wanted` vertices on average.
double radius_for(const Surface& surface, double wanted) {
  constexpr std::size_t balls = 16;
  const std::vector<glm::vec3>& positions = surface.mesh().positions;
  double radius = 1e-4, count = 0;
  for (std::vector<std::uint32_t> found; count < wanted * balls && radius < 1; radius *= 1.02) {
    count = 0;
    for (std::size_t k = 0; k < balls; ++k) {
      surface.vertices_within(glm::dvec3(positions[k * positions.size() / balls]), radius, found);
      count += static_cast<double>(found.size());
    }
  }
  return radius;
}

/// One dab of a tool on a random vertex. Comb needs motion and gets a stroke of two samples, other tools one of one
/// sample.
template <class Tool>
Command dab(const Mesh& mesh, double radius, Random& random) {
  const auto v = static_cast<std::size_t>(random.uniform(0, static_cast<double>(mesh.positions.size())));
  Tool tool;
  tool.brush.radius = radius;
  tool.brush.front_faces_only = false;
  tool.stroke.emplace();
  const glm::dvec3 from(mesh.positions[v]), along(mesh.tangents[v]);
  if (std::is_same_v<Tool, Comb>)
    tool.stroke->samples.push_back({PositionSample{mesh.to_model(from - tool.brush.spacing * radius * along)}});
  tool.stroke->samples.push_back({PositionSample{mesh.to_model(from)}});
  return tool;
}
using Dab = Command (*)(const Mesh&, double, Random&);

/// A scene with a journal in a temporary folder, which is deleted with it.
class JournaledScene {
 public:
  explicit JournaledScene(int vertices) : folder_(std::filesystem::temp_directory_path() / "pelage_bench_groom") {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    auto journal = Journal::open((folder_ / "pelage.sqlite").string());
    if (!journal) std::fprintf(stderr, "%s\n", journal.status().message.c_str()), std::exit(1);
    journal_ = std::move(*journal);
    model_ = std::shared_ptr<const SceneModel>(new SceneModel{torus(vertices), {}, 1, "torus"});
    scene_ = std::make_unique<Scene>("bench", "bench", model_, FirstGroom{}, *journal_);
    if (!journal_->add_scene({"bench", "bench", {}, 0, {}}).ok()) std::exit(1);
  }
  ~JournaledScene() {
    scene_.reset(), journal_.reset();
    std::filesystem::remove_all(folder_);
  }
  JournaledScene(const JournaledScene&) = delete;
  JournaledScene& operator=(const JournaledScene&) = delete;

  Scene& scene() { return *scene_; }
  const Surface& surface() const { return model_->surface; }

 private:
  std::filesystem::path folder_;
  std::unique_ptr<Journal> journal_;
  std::shared_ptr<const SceneModel> model_;
  std::unique_ptr<Scene> scene_;
};

void require(bool good, const char* what) {
  if (!good) std::fprintf(stderr, "%s failed\n", what), std::exit(1);
}

/// Mean costs of one dab, in milliseconds; each is the minimum over the repetitions.
struct DabCosts {
  double touched = 0;
  Cost evaluate, change, scene, undo, redo;
};

/// Each repetition combs other positions, so that little of the mesh is in the CPU caches.
DabCosts dab_costs(JournaledScene& made, Dab dab, int repetitions) {
  constexpr int dab_count = 32;
  const Surface& surface = made.surface();
  FieldSet fields = first_groom(surface.mesh(), {});
  const double radius = radius_for(surface, dab_vertices);
  Random random(1);
  DabCosts costs;
  const auto lower = [](Cost& cost, const Cost& other) {
    cost.lower_to({other.wall / dab_count, other.cpu / dab_count});
  };
  for (int i = 0; i < repetitions; ++i) {
    std::vector<Command> dabs;
    for (int k = 0; k < dab_count; ++k) dabs.push_back(dab(surface.mesh(), radius, random));
    std::vector<FieldDelta> deltas(dab_count);
    const Cost evaluate_cost = measure([&] {
      for (int k = 0; k < dab_count; ++k)
        deltas[std::size_t(k)] = evaluate(*resolve(dabs[std::size_t(k)], surface), surface, fields).delta;
    });
    const Cost change = measure([&] {
      for (const FieldDelta& delta : deltas) fields.apply(delta);
    });
    lower(costs.evaluate, evaluate_cost), lower(costs.change, change);
    for (const FieldDelta& delta : deltas)
      costs.touched += static_cast<double>(delta.vertices().size()) / dab_count / repetitions;
    for (Command& command : dabs) command = dab(surface.mesh(), radius, random);
    lower(costs.scene, measure([&] {
            for (const Command& one : dabs) require(made.scene().execute({one}).ok(), "a dab");
          }));
    lower(costs.undo, measure([&] {
            for (int k = 0; k < dab_count; ++k) require(made.scene().move(Undo{}).ok(), "undo");
          }));
    lower(costs.redo, measure([&] {
            for (int k = 0; k < dab_count; ++k) require(made.scene().move(Redo{}).ok(), "redo");
          }));
  }
  return costs;
}

void print_row(const char* name, std::size_t vertices, const DabCosts& costs) {
  std::printf("| %s | %zu | %.0f |", name, vertices, costs.touched);
  const Cost both{costs.evaluate.wall + costs.change.wall, costs.evaluate.cpu + costs.change.cpu};
  for (const Cost& cost : {costs.evaluate, costs.change, both, costs.scene, costs.undo, costs.redo})
    std::printf(" %.3f (%.3f) |", cost.cpu, cost.wall);
  std::puts("");
  std::fflush(stdout);
}

void print_dabs(int few, int many, int repetitions) {
  std::puts(
      "One dab, CPU ms (wall ms), least of the repetitions' means; scene, undo and redo are synced to the journal\n\n"
      "| tool | vertices | touched | evaluate | apply and hash | both | in a scene | undo | redo |\n"
      "|---|---|---|---|---|---|---|---|---|");
  const std::pair<const char*, Dab> tools[] = {
      {"comb", dab<Comb>}, {"smooth", dab<Smooth>}, {"lift", dab<Lift>}, {"clump", dab<Clump>}};
  for (const int vertices : {few, many}) {
    JournaledScene made(vertices);
    for (const auto& [name, one] : tools)
      print_row(name, made.surface().mesh().positions.size(), dab_costs(made, one, repetitions));
  }
  std::puts("");
}

Stroke stroke_on(const Mesh& mesh) {
  Stroke stroke;
  for (const double step : {0.0, 0.1})
    stroke.samples.push_back({PositionSample{mesh.to_model(glm::dvec3(mesh.positions[0]) + glm::dvec3(0, step, 0))}});
  return stroke;
}

struct NamedTool {
  const char* name;
  Command command;
};

/// Every tool, set up so that it changes all of its fields.
std::vector<NamedTool> tools_on(const Mesh& mesh) {
  const glm::dvec3 position = mesh.to_model(glm::dvec3(mesh.positions[0]));
  const glm::dvec3 above = mesh.to_model(glm::dvec3(mesh.positions[0]) + 0.05 * glm::dvec3(mesh.normals[0]));
  Key key{position, glm::dvec3(0, 1, 0), 0.9, 0.05};
  return {{"comb", Comb{.flood = true, .direction = glm::dvec3(1, 2, 3)}},
          {"blow", Blow{.source = mesh.to_model({0, 2, 0})}},
          {"attract", Attract{.point = above, .radius = 0.06, .duration = 100}},
          {"interpolate", Interpolate{.keys = {key}}},
          {"flow", Flow{.curves = {{position, position + glm::dvec3(0.1, 0.2, 0)}}, .inclination = 0.3}},
          {"smooth", Smooth{.flood = true, .fields = {Field::direction, Field::length}}},
          {"noise", Noise{.flood = true}},
          {"unify", Unify{.flood = true, .direction = glm::dvec3(1, 2, 3)}},
          {"part", Part{.stroke = stroke_on(mesh)}},
          {"length", Length{.flood = true, .mode = LengthMode::scale, .value = 0.5}},
          {"trim", Trim{.flood = true, .shape = 0.001}},
          {"lift", Lift{.flood = true}},
          {"clump", Clump{.stroke = stroke_on(mesh)}},
          {"curl", Curl{.flood = true, .turn_degrees = 30}},
          {"paint, one number", Paint{.flood = true, .field = Field::wetness}},
          {"paint, colour", Paint{.flood = true, .field = Field::root_colour, .colour = {0.2f, 0.3f, 0.4f}}}};
}

void print_undo_bytes(int vertices) {
  const Surface surface = torus(vertices);
  FieldSet fields = first_groom(surface.mesh(), {});
  fields.apply(
      evaluate(Noise{.flood = true, .amount = 0.1, .fields = {Field::direction, Field::length}}, surface, fields)
          .delta);
  std::puts(
      "Undo, bytes for each touched vertex\n\n| tool | touched | fields | in flight | in the undo log "
      "|\n|---|---|---|---|---|");
  for (const auto& [name, command] : tools_on(surface.mesh())) {
    const FieldDelta delta = evaluate(command, surface, fields).delta;
    const double touched = std::max(1.0, static_cast<double>(delta.vertices().size()));
    std::printf("| %s | %.0f | %zu | %.1f | %.1f |\n", name, touched, delta.parts.size(),
                static_cast<double>(delta.bytes()) / touched,
                static_cast<double>(encode_delta(delta).size()) / touched);
  }
  std::puts("");
}

/// Returns a function that copies this many bytes, in blocks about as large as a mesh's arrays.
std::function<void()> plain_copy(std::size_t bytes) {
  static constexpr std::size_t block = std::size_t{8} << 20;
  auto from = std::make_shared<std::vector<char>>(bytes, 1), to = std::make_shared<std::vector<char>>(bytes, 2);
  return [from, to, bytes] {
    for (std::size_t at = 0; at < bytes; at += block)
      std::memcpy(to->data() + at, from->data() + at, std::min(block, bytes - at));
  };
}

struct Flood {
  const char* name;
  Command command;
  std::size_t bytes;  // size of the arrays that it reads and writes, bytes per vertex
};

void print_floods(int vertices, int repetitions) {
  const Surface surface = torus(vertices);
  const Mesh& mesh = surface.mesh();
  const FieldSet fields = first_groom(mesh, {});
  // Bytes per vertex: direction 8, its change 12, normal and tangent 24, position 12, six neighbours 28.
  const Flood floods[] = {{"comb", Comb{.flood = true, .direction = glm::dvec3(1, 2, 3)}, 8 + 12 + 24},
                          {"smooth, 1 pass", Smooth{.flood = true, .passes = 1}, 8 + 12 + 24 + 12 + 28},
                          {"smooth, 3 passes", Smooth{.flood = true, .passes = 3}, 8 + 12 + 24 + 12 + 3 * 28},
                          {"noise", Noise{.flood = true}, 8 + 12 + 24 + 12},
                          {"noise with features", Noise{.flood = true, .feature_size = 0.05}, 8 + 12 + 24 + 12},
                          {"unify to a value", Unify{.flood = true, .direction = glm::dvec3(1, 2, 3)}, 8 + 12 + 24},
                          {"unify to the mean", Unify{.flood = true, .mean = {Field::direction}}, 2 * (8 + 24) + 12}};
  std::printf(
      "Floods of %d vertices, ms, against copying the arrays that they read and write\n\n"
      "| flood | bytes a vertex | wall | CPU | copy, wall | ratio | CPU ratio |\n|---|---|---|---|---|---|---|\n",
      vertices);
  for (const Flood& flood : floods) {
    const auto costs =
        measure_alternating({[&] { require(!evaluate(flood.command, surface, fields).delta.empty(), flood.name); },
                             plain_copy(flood.bytes * fields.size())},
                            repetitions);
    std::printf("| %s | %zu | %.1f | %.1f | %.1f | %.1f | %.1f |\n", flood.name, flood.bytes, costs[0].wall,
                costs[0].cpu, costs[1].wall, costs[0].wall / costs[1].wall, costs[0].cpu / costs[1].cpu);
    std::fflush(stdout);
  }
  std::puts("");
}

void print_interpolation(int vertices, int repetitions) {
  const Surface surface = torus(vertices);
  const Mesh& mesh = surface.mesh();
  const FieldSet fields = first_groom(mesh, {});
  Random random(2);
  Interpolate command;
  for (int k = 0; k < 16; ++k) {
    const auto v = static_cast<std::size_t>(random.uniform(0, static_cast<double>(mesh.positions.size())));
    command.keys.push_back(
        {mesh.to_model(glm::dvec3(mesh.positions[v])), glm::dvec3(random.uniform(-1, 1), 1, 0), 0.5, 0.03});
  }
  Cost cost;
  for (int i = 0; i < repetitions; ++i)
    cost.lower_to(measure([&] { require(!evaluate(command, surface, fields).delta.empty(), "interpolate"); }));
  std::printf("interpolate, 16 keys, %d vertices: %.2f s, CPU %.2f s\n\n", vertices, cost.wall / 1e3, cost.cpu / 1e3);
}

int main(int count, char** arguments) {
  const auto number = [&](const char* name, int fallback) { return argument(count, arguments, name, fallback); };
  const int repetitions = number("--repetitions", 5), flood = number("--flood", 1'000'000);
  print_dabs(number("--few", 50'000), number("--many", 1'000'000), repetitions);
  print_undo_bytes(std::min(flood, 50'000));
  print_floods(flood, repetitions);
  print_interpolation(flood, std::min(repetitions, 3));
  return 0;
}

}  // namespace
}  // namespace pelage::bench

int main(int count, char** arguments) { return pelage::bench::main(count, arguments); }
