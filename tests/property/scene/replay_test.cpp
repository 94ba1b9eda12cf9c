#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "protocol/base/random.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage {
namespace {

/// Drives a scene with a random mix of everything that changes it, as an artist's client would.
class Script {
 public:
  /// Without edit layers any step can be left out: no later one names what it made.
  enum class Layers { some, none };

  Script(Scene& scene, std::uint64_t seed, Layers layers = Layers::some)
      : scene_(scene), random_(seed), layers_(layers) {
    scene.read([&](const SceneView& view) {
      const Mesh& mesh = view.model.surface.mesh();
      for (const glm::vec3 p : mesh.positions) places_.push_back(mesh.to_model(glm::dvec3(p)));
      triangles_ = mesh.triangles.size();
    });
  }

  /// One accepted request (or more, for a stroke in parts).
  void act() {
    const double kind = random_.uniform();
    if (layers_ == Layers::some && chance(0.06))
      send({edit_layer_change()});
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

  /// Changes, leaves out or replaces a step, and gives the list of steps as it is to be from then on.
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
  /// A revision of each step that is in effect, found by trying: what the log marks can be amended, and nothing else.
  std::vector<std::pair<Revision, std::size_t>> revisions_in_effect() {
    std::vector<std::pair<Revision, std::size_t>> known;
    const std::size_t steps = scene_.effective_log().size();
    bool in_stroke = false;  // of parts the first one counts
    for (const LogEntry& entry : scene_.log()) {
      const bool joins = entry.kind == "join";
      EXPECT_EQ(scene_.amend({entry.revision, {}}, {.dry_run = true}).ok(), entry.in_effect) << entry.revision;
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
    const glm::dvec3 start = places_[static_cast<std::size_t>(below(static_cast<int>(places_.size())))];
    const glm::dvec2 pixel(random_.uniform(60, 260), random_.uniform(40, 160));
    for (int i = 0, n = 2 + below(12); i < n; ++i) {
      StrokeSample sample;
      if (stroke.view) {
        sample.place = ScreenSample{pixel + glm::dvec2(4.0 * i, 3.0 * i)};
      } else if (chance(0.2)) {
        sample.place = SurfaceSample{static_cast<std::uint32_t>(below(static_cast<int>(triangles_))), {0.2, 0.3, 0.5}};
      } else {
        sample.place = PositionSample{start + 0.02 * i * glm::dvec3(1, 0.4, -0.3)};
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
  /// The name of an edit layer that tools may change, or of none.
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
  Command tool() {
    Command tool = tool_of_the_groom();
    std::visit(
        [&](auto& t) {
          if constexpr (requires { t.edit_layer; }) t.edit_layer = layer();
        },
        tool);
    return tool;
  }
  Command tool_of_the_groom() {
    const int kind = below(6);
    if (kind == 0) {
      Blow blow;
      blow.source = 3.0 * places_[static_cast<std::size_t>(below(static_cast<int>(places_.size())))];
      blow.direction = -blow.source;
      blow.cone_degrees = random_.uniform(2, 12);
      if (chance(0.5)) blow.stroke = stroke();
      return blow;
    }
    if (kind == 1) {
      Attract attract;
      attract.point = 1.2 * places_[static_cast<std::size_t>(below(static_cast<int>(places_.size())))];
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
      curves.groups.push_back({.curves = {{places_[0], 1.1 * places_[0]}}, .spread = random_.uniform()});
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
      Comb piece = whole;
      piece.stroke->id = id;
      piece.stroke->part = static_cast<std::uint32_t>(part);
      piece.stroke->last = finished && part + 1 == parts;
      piece.stroke->samples.assign(whole.stroke->samples.begin() + static_cast<std::ptrdiff_t>(at),
                                   whole.stroke->samples.begin() + static_cast<std::ptrdiff_t>(end));
      at = end;
      send({piece});
    }
  }

  Scene& scene_;
  Random random_;
  Layers layers_;
  std::vector<glm::dvec3> places_;
  std::size_t triangles_ = 0;
  int strokes_ = 0;
};

std::string settings_text(const Scene& scene) {
  std::string text;
  scene.read([&](const SceneView& view) {
    text = encode(std::vector<Command>{SetCoat{view.settings.coat}, SetLook{view.settings.look},
                                       SetLights{view.settings.lights}, SetEyes{view.settings.eyes},
                                       SetCurves{view.settings.curves}, SetSkin{view.settings.skin}});
  });
  return text;
}

std::string lines_of(const std::vector<std::vector<Command>>& steps) {
  std::string text;
  for (const std::vector<Command>& step : steps) text += encode(step) + "\n";
  return text;
}

class ReplayTest : public StoreTest, public ::testing::WithParamInterface<std::uint64_t> {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) / ("pelage_replay_" + std::to_string(GetParam()));
    std::filesystem::remove_all(folder_);
    open();
  }
};

// The effective log goes through text, as a client would send it.
void replay(const std::vector<std::vector<Command>>& log, Scene& scene) {
  for (const std::vector<Command>& step : log) {
    const auto commands = decode_commands(encode(step));
    ASSERT_TRUE(commands.ok()) << commands.status().message << commands.status().pointer;
    const auto answer = scene.execute(*commands);
    ASSERT_TRUE(answer.ok()) << answer.status().message << answer.status().pointer;
  }
}

TEST_P(ReplayTest, AnyScriptReplaysUndoesAndSurvivesARestart) {
  const auto scene = make(Builtin::torus, 600);
  const FieldsHash first = hash(*scene);
  const std::string first_settings = settings_text(*scene);
  Script script(*scene, GetParam());
  while (scene->revision() < 260 && !HasFatalFailure()) script.act();

  const auto anew = make(Builtin::torus, 600);
  replay(scene->effective_log(), *anew);
  EXPECT_EQ(hash(*anew), hash(*scene));
  EXPECT_EQ(settings_text(*anew), settings_text(*scene));

  const SceneSummary before = scene->summary();
  const std::string log = encode(scene->log()), settings = settings_text(*scene);
  open();
  const auto restarted = *store_->find(before.id);
  const SceneSummary after = restarted->summary();
  EXPECT_EQ(after.revision, before.revision);
  EXPECT_EQ(after.fields_hash, before.fields_hash);
  EXPECT_EQ(after.undo_steps, before.undo_steps);
  EXPECT_EQ(after.redo_steps, before.redo_steps);
  EXPECT_EQ(encode(restarted->log()), log);
  EXPECT_EQ(settings_text(*restarted), settings);

  const int steps = static_cast<int>(after.undo_steps);
  ASSERT_GT(steps, 0);
  EXPECT_EQ(move(*restarted, Undo{steps}).fields_hash, first);
  EXPECT_EQ(settings_text(*restarted), first_settings);
  EXPECT_TRUE(restarted->effective_log().empty());
  EXPECT_EQ(move(*restarted, Redo{steps}).fields_hash, before.fields_hash);
  EXPECT_EQ(settings_text(*restarted), settings);
}

TEST_P(ReplayTest, AnyRevisionCanBeGoneBackTo) {
  const auto scene = make(Builtin::torus, 600);
  Script script(*scene, GetParam() + 1000);
  std::vector<std::pair<Revision, FieldsHash>> seen;
  while (scene->revision() < 60 && !HasFatalFailure()) {
    seen.emplace_back(scene->revision(), hash(*scene));
    script.act();
  }
  for (const auto& [revision, expected] : seen) {
    ASSERT_EQ(move(*scene, Revert{revision}).fields_hash, expected) << revision;
    if (revision % 7 != 0) continue;
    const auto anew = make(Builtin::torus, 600);
    replay(scene->effective_log(), *anew);
    ASSERT_EQ(hash(*anew), expected) << revision;
    ASSERT_TRUE(store_->remove(anew->id()).ok());
  }
}

/// The hashes that one undo after the other leads through, and then the redos.
std::vector<FieldsHash> way_back_and_forth(Scene& scene) {
  std::vector<FieldsHash> hashes;
  const std::size_t steps = scene.summary().undo_steps;
  const auto go = [&](const HistoryMove& move) {
    const auto answer = scene.move(move);
    ASSERT_TRUE(answer.ok()) << answer.status().message;
    hashes.push_back(answer->fields_hash);
  };
  for (std::size_t i = 0; i < steps; ++i) go(Undo{});
  for (std::size_t i = 0; i < steps; ++i) go(Redo{});
  return hashes;
}

TEST_P(ReplayTest, StepsBeyondTheUndoMemoryComeBackFromTheJournal) {
  const auto run = [&](std::size_t undo_bytes) {
    open(undo_bytes);
    const auto scene = make(Builtin::torus, 600);
    const FieldsHash first = hash(*scene);
    Script script(*scene, GetParam() + 2000);
    while (scene->revision() < 100 && !HasFatalFailure()) script.act();
    const FieldsHash last = hash(*scene);
    std::vector<FieldsHash> way = way_back_and_forth(*scene);
    const int steps = static_cast<int>(scene->summary().undo_steps);
    EXPECT_EQ(move(*scene, Undo{steps}).fields_hash, first);
    EXPECT_EQ(move(*scene, Redo{steps}).fields_hash, last);
    way.insert(way.end(), {first, last});
    return way;
  };
  const std::vector<FieldsHash> all_in_memory = run(limits::undo_bytes);
  EXPECT_EQ(run(0), all_in_memory);
  EXPECT_EQ(run(4000), all_in_memory) << "some steps in memory, some not";
}

// The model of an amendment: its edited list, replayed into a fresh scene.
TEST_P(ReplayTest, AmendmentsAndBranchesAreWhatTheirListsSay) {
  open(4000);  // some steps in memory, some not
  auto scene = make(Builtin::torus, 600);
  Script script(*scene, GetParam() + 3000, Script::Layers::none);
  std::vector<std::string> ids;
  for (int round = 0; round < 6 && !HasFatalFailure(); ++round) {
    for (int i = 0; i < 8; ++i) script.act();
    const SceneSummary before = scene->summary();
    const std::string settings = settings_text(*scene);
    const auto steps = script.amend();
    const auto anew = make(Builtin::torus, 600);
    replay(steps, *anew);
    ASSERT_EQ(hash(*scene), hash(*anew)) << round;
    ASSERT_EQ(settings_text(*scene), settings_text(*anew)) << round;
    ASSERT_EQ(lines_of(scene->effective_log()), lines_of(anew->effective_log())) << round;
    ASSERT_TRUE(store_->remove(anew->id()).ok());

    if (scene->revision() == before.revision) continue;  // there was nothing to amend
    const auto side = store_->branch(*scene, {});
    ASSERT_TRUE(side.ok());
    const FieldsHash amended = hash(*scene);
    ASSERT_EQ(move(**side, Undo{}).fields_hash, before.fields_hash) << round;
    ASSERT_EQ(settings_text(**side), settings) << round;
    ASSERT_EQ(move(**side, Redo{}).fields_hash, amended) << round;
    const auto back = store_->branch(*scene, {"back", before.revision});
    ASSERT_TRUE(back.ok());
    ASSERT_EQ(hash(**back), before.fields_hash) << round;
    ids.push_back((*side)->id()), ids.push_back((*back)->id());
  }
  EXPECT_GE(ids.size(), 6u) << "most rounds amend something";
  ids.push_back(scene->id());
  std::vector<std::pair<FieldsHash, std::string>> known;
  for (const std::string& id : ids) known.emplace_back(hash(**store_->find(id)), encode((*store_->find(id))->log()));
  scene.reset();
  open();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto again = *store_->find(ids[i]);
    EXPECT_EQ(hash(*again), known[i].first);
    EXPECT_EQ(encode(again->log()), known[i].second);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ReplayTest, ::testing::Range<std::uint64_t>(1, 5));

using PartsTest = StoreTest;

/// Sends one stroke whole to one scene and in random parts to another.
void send_whole_and_in_parts(Random random, Scene& sent_whole, Scene& live, Comb whole) {
  const glm::dvec3 start = std::get<PositionSample>(whole.stroke->samples[0].place).position;
  whole.stroke->samples.clear();
  for (int i = 0; i < 20; ++i) {
    StrokeSample sample;
    const double away = random.uniform() < 0.2 ? 5 : 0;  // now and then the pointer leaves the model
    sample.place = PositionSample{start + 0.02 * i * glm::dvec3(1, 0.5, -0.4) + away};
    whole.stroke->samples.push_back(sample);
  }
  RC_ASSERT(sent_whole.execute({whole}).ok());
  std::size_t at = 0;
  for (std::uint32_t part = 0; at < whole.stroke->samples.size(); ++part) {
    const std::size_t end = std::min(at + 1 + static_cast<std::size_t>(random.uniform(0, 6)), std::size_t{20});
    Comb piece = whole;
    piece.stroke->id = "pen";
    piece.stroke->part = part;
    piece.stroke->last = end == 20;
    piece.stroke->samples.assign(whole.stroke->samples.begin() + static_cast<std::ptrdiff_t>(at),
                                 whole.stroke->samples.begin() + static_cast<std::ptrdiff_t>(end));
    RC_ASSERT(live.execute({piece}).ok());
    at = end;
  }
}

TEST_F(PartsTest, AnyPartsOfAStrokeGiveTheWhole) {
  const bool held = rc::check([this](std::uint64_t seed) {
    Random random(seed);
    const auto live = make(Builtin::torus, 400), sent_whole = make(Builtin::torus, 400);
    const auto anew = make(Builtin::torus, 400);
    const Comb whole = comb_at(*live, static_cast<std::size_t>(random.uniform(0, 200)));
    send_whole_and_in_parts(random, *sent_whole, *live, whole);
    RC_ASSERT(hash(*live) == hash(*sent_whole));
    RC_ASSERT(live->summary().undo_steps == sent_whole->summary().undo_steps);
    for (const auto& step : live->effective_log()) RC_ASSERT(anew->execute(step).ok());
    RC_ASSERT(hash(*anew) == hash(*live));
    for (const auto& scene : {live, sent_whole, anew}) RC_ASSERT(store_->remove(scene->id()).ok());
  });
  EXPECT_TRUE(held);
}

}  // namespace
}  // namespace pelage
