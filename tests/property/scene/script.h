// Makes random changes of a scene.
#pragma once

#include <gtest/gtest.h>

#include <set>

#include "base/random.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage {

/// Drives a scene with a random mix of all kinds of changes, as an artist's client would.
class Script {
 public:
  /// Without edit layers any step can be left out, since no later step names what it made.
  enum class Layers { some, none };

  Script(Scene& scene, std::uint64_t seed, Layers layers = Layers::some)
      : scene_(scene), random_(seed), layers_(layers) {
    const SnapshotPtr now = scene.snapshot();
    const SceneView view = now->view();
    const Mesh& mesh = view.model.surface.mesh();
    for (const glm::vec3 p : mesh.positions) positions_.push_back(mesh.to_model(glm::dvec3(p)));
    triangles_ = mesh.triangles.size();
  }

  /// Sends one accepted request, or several for a stroke in parts.
  void act() {
    const double kind = random_.uniform();
    if (layers_ == Layers::some && chance(0.06))
      send({edit_layer_change()});
    else if (layers_ == Layers::some && chance(0.06))
      send({coats_change()});
    else if (kind < 0.40)
      send({tool()});
    else if (kind < 0.50)
      send({tool(), tool(), setting()});
    else if (kind < 0.58)
      send({setting()});
    else if (kind < 0.72)
      send_in_parts();
    else if (kind < 0.84)
      move(Undo{std::min<int>(1 + below(3), static_cast<int>(scene_.summary().undo_steps))});
    else if (kind < 0.94)
      move(Redo{std::min<int>(1 + below(3), static_cast<int>(scene_.summary().redo_steps))});
    else
      move(Revert{static_cast<Revision>(below(static_cast<int>(scene_.revision()) + 1))});
  }

  /// Amends a step: replaces or removes its commands. Returns the expected list of steps.
  std::vector<std::vector<Command>> amend() {
    std::vector<std::vector<Command>> steps = scene_.effective_log();
    std::vector<std::pair<Revision, std::size_t>> known = revisions_in_effect();
    if (known.empty()) return steps;
    const auto [revision, number] = known[static_cast<std::size_t>(below(static_cast<int>(known.size())))];
    const double kind = random_.uniform();
    if (kind < 0.4)
      steps[number] = {tool()};
    else if (kind < 0.6)
      steps[number] = {tool(), setting(), tool()};
    else
      steps[number].clear();
    const auto answer = scene_.amend({revision, steps[number]});
    EXPECT_TRUE(answer.ok()) << answer.status().message << answer.status().pointer;
    std::erase_if(steps, [](const auto& step) { return step.empty(); });
    return steps;
  }

 private:
  /// For each step in effect its revision and index. Checks that exactly the entries marked in the log can be amended.
  std::vector<std::pair<Revision, std::size_t>> revisions_in_effect() {
    std::vector<std::pair<Revision, std::size_t>> known;
    const std::size_t steps = scene_.effective_log().size();
    bool in_stroke = false;  // only the first part of a stroke counts
    std::set<Revision> numbers;
    for (const LogEntry& entry : scene_.log())
      if (entry.in_effect) numbers.insert(entry.step);
    for (const LogEntry& entry : scene_.log()) {
      const bool joins = entry.kind == "join";
      const bool known_step = entry.in_effect || numbers.contains(entry.revision);
      EXPECT_EQ(scene_.amend({entry.revision, {}}, {.dry_run = true}).ok(), known_step) << entry.revision;
      if (entry.in_effect && !(joins && in_stroke)) known.emplace_back(entry.revision, known.size());
      in_stroke = joins || entry.kind == "do";
    }
    EXPECT_EQ(known.size(), steps);
    return known.size() == steps ? known : decltype(known){};
  }
  int below(int limit) { return static_cast<int>(random_.uniform(0, limit)); }
  bool chance(double share) { return random_.uniform() < share; }

  void send(const std::vector<Command>& commands) {
    const auto answer = scene_.execute(commands);
    ASSERT_TRUE(answer.ok()) << answer.status().message << answer.status().pointer;
  }
  void move(const HistoryMove& move) {
    if (const auto* undo = std::get_if<Undo>(&move); undo && undo->steps == 0) return;
    if (const auto* redo = std::get_if<Redo>(&move); redo && redo->steps == 0) return;
    const auto answer = scene_.move(move);
    ASSERT_TRUE(answer.ok()) << answer.status().message;
  }

  Stroke stroke() {
    Stroke stroke;
    if (chance(0.3)) stroke.view = View{.camera = {.automatic = AutoView::three_quarter}, .width = 320, .height = 200};
    const glm::dvec3 start = positions_[static_cast<std::size_t>(below(static_cast<int>(positions_.size())))];
    const glm::dvec2 pixel(random_.uniform(60, 260), random_.uniform(40, 160));
    for (int i = 0, n = 2 + below(12); i < n; ++i) {
      StrokeSample sample;
      if (stroke.view) {
        sample.position = ScreenSample{pixel + glm::dvec2(4.0 * i, 3.0 * i)};
      } else if (chance(0.2)) {
        sample.position =
            SurfaceSample{static_cast<std::uint32_t>(below(static_cast<int>(triangles_))), {0.2, 0.3, 0.5}};
      } else {
        sample.position = PositionSample{start + 0.02 * i * glm::dvec3(1, 0.4, -0.3)};
      }
      sample.pressure = random_.uniform(0.3, 1);
      stroke.samples.push_back(sample);
    }
    return stroke;
  }
  Brush brush() {
    return {.radius = random_.uniform(0.02, 0.15),
            .falloff = static_cast<Falloff>(below(5)),
            .strength = random_.uniform(),
            .front_faces_only = chance(0.5),
            .invert = chance(0.2)};
  }
  /// The name of a random edit layer that tools may change, or "".
  std::string layer() {
    const std::vector<EditLayer> layers = scene_.summary().edit_layers;
    if (layers.empty() || chance(0.4)) return "";
    const EditLayer& layer = layers[static_cast<std::size_t>(below(static_cast<int>(layers.size())))];
    return layer.muted || std::abs(layer.weight) < limits::min_groomed_weight ? "" : layer.name;
  }
  Command edit_layer_change() {
    const std::vector<EditLayer> layers = scene_.summary().edit_layers;
    ChangeEditLayer change;
    change.name = std::to_string(scene_.revision()), change.weight = random_.uniform(-2, 3);
    if (layers.size() < 2 || (layers.size() < limits::edit_layers && chance(0.3))) return change;
    const auto at = static_cast<std::size_t>(below(static_cast<int>(layers.size())));
    change.name = layers[at].name;
    const int kind = below(4);
    if (kind == 0)
      change.action = EditLayerAction::move, change.above = at == 0 ? layers.back().name : "";
    else if (kind == 1 && !layers[at].muted && (at == 0 || !layers[at - 1].muted))
      change.action = EditLayerAction::merge_down;
    else if (kind == 2)
      change.action = EditLayerAction::remove;
    else
      change.action = EditLayerAction::set, change.muted = chance(0.3);
    return change;
  }
  std::vector<NamedCoat> coats() const { return scene_.settings()->settings.coats; }
  /// Adds, mutes, renames, reorders or removes coats; the first one stays and stays visible.
  Command coats_change() {
    SetCoats change;
    for (const NamedCoat& coat : coats()) change.coats.push_back({.name = coat.name, .id = coat.id});
    const std::size_t count = change.coats.size();
    for (std::size_t k = 1; k < count; ++k) change.coats[k].muted = chance(0.2);
    const int kind = below(4);
    if (count > 1 && kind == 0)
      change.coats.pop_back();
    else if (count > 2 && kind == 1)
      std::swap(change.coats[1], change.coats[2]);
    else if (count > 1 && kind == 2)
      change.coats[1].name += "'";
    else if (count < 4)
      change.coats.push_back(
          {.name = "coat " + std::to_string(scene_.revision()),
           .begins = CoatBeginning{.region = static_cast<CoatRegion>(below(3)), .length = random_.uniform(0.5, 2)}});
    return change;
  }
  /// Names of some visible coats, or none.
  std::vector<std::string> some_coats() {
    std::vector<std::string> names;
    for (const NamedCoat& coat : coats())
      if (!coat.muted && chance(0.4)) names.push_back(coat.name);
    return names;
  }
  Command tool() {
    Command tool = tool_of_the_groom();
    std::visit(
        [&](auto& t) {
          if constexpr (requires { t.edit_layer; }) t.edit_layer = layer(), t.coats = some_coats();
        },
        tool);
    return tool;
  }
  Command tool_of_the_groom() {
    const int kind = below(6);
    if (kind == 0) {
      Blow blow;
      blow.source = 3.0 * positions_[static_cast<std::size_t>(below(static_cast<int>(positions_.size())))];
      blow.direction = -blow.source;
      blow.cone_degrees = random_.uniform(2, 12);
      if (chance(0.5)) blow.stroke = stroke();
      return blow;
    }
    if (kind == 1) {
      Attract attract;
      attract.point = 1.2 * positions_[static_cast<std::size_t>(below(static_cast<int>(positions_.size())))];
      attract.radius = random_.uniform(0.05, 0.3);
      attract.strength = random_.uniform();
      if (chance(0.3)) attract.stroke = stroke();
      return attract;
    }
    Comb comb;
    comb.brush = brush();
    comb.flood = chance(0.1);
    if (comb.flood)
      comb.direction = glm::dvec3(random_.uniform(-1, 1), 0.5, random_.uniform(-1, 1));
    else
      comb.stroke = stroke();
    return comb;
  }
  Command setting() {
    const int kind = below(5);
    if (kind == 0) {
      SetCoat coat;
      coat.coat.curl = random_.uniform(0, 0.5);
      coat.coat.ramp[0].colour = {static_cast<float>(random_.uniform()), 0.25f, 0.125f};
      return coat;
    }
    if (kind == 1) {
      SetLook look;
      look.look.ambient = random_.uniform();
      return look;
    }
    if (kind == 2) {
      SetEyes eyes;
      eyes.eyes.resize(1 + static_cast<std::size_t>(below(2)));
      eyes.eyes[0].radius = random_.uniform(0.01, 0.1);
      return eyes;
    }
    if (kind == 3) {
      SetCurves curves;
      curves.groups.push_back({.curves = {{positions_[0], 1.1 * positions_[0]}}, .spread = random_.uniform()});
      return curves;
    }
    if (kind == 4) {
      SetSkin skin;
      skin.regions.resize(1 + static_cast<std::size_t>(below(3)));
      skin.regions[0].softness = random_.uniform(0, 2);
      return skin;
    }
    SetLights lights;
    lights.lights = default_lights();
    lights.lights[0].intensity = random_.uniform(0, 10);
    return lights;
  }
  void send_in_parts() {
    Comb whole;
    whole.brush = brush();
    whole.stroke = stroke();
    const std::size_t parts = std::min<std::size_t>(whole.stroke->samples.size(), 4);
    const bool finished = chance(0.8);
    const std::string id = "k" + std::to_string(below(3)) + "_" + std::to_string(strokes_++);
    for (std::size_t part = 0, at = 0; part < parts; ++part) {
      const std::size_t end = whole.stroke->samples.size() * (part + 1) / parts;
      Comb part_command = whole;
      part_command.stroke->id = id;
      part_command.stroke->part = static_cast<std::uint32_t>(part);
      part_command.stroke->last = finished && part + 1 == parts;
      part_command.stroke->samples.assign(whole.stroke->samples.begin() + static_cast<std::ptrdiff_t>(at),
                                          whole.stroke->samples.begin() + static_cast<std::ptrdiff_t>(end));
      at = end;
      send({part_command});
    }
  }

  Scene& scene_;
  Random random_;
  Layers layers_;
  std::vector<glm::dvec3> positions_;
  std::size_t triangles_ = 0;
  int strokes_ = 0;
};

}  // namespace pelage
