// Subdivision, retargeting of other scenes' fields, and logs for other models, across restarts.
#include <cmath>

#include "server/builtin/builtin.h"
#include "server/import/import.h"
#include "server/scene/model.h"
#include "server/scene/scene.h"
#include "tests/support/textured.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::subdivide_scene_test {
namespace {

class SubdivideSceneTest : public StoreTest {
 protected:
  SceneSummary subdivide(Scene& scene, const Subdivide& how = {}) {
    const auto summary = store_->subdivide(scene, how);
    EXPECT_TRUE(summary.ok()) << summary.status().message;
    return summary.ok() ? *summary : SceneSummary{};
  }
  CommandAnswer run(Scene& scene, const std::vector<Command>& commands) const {
    const auto answer = store_->execute(scene, commands);
    EXPECT_TRUE(answer.ok()) << answer.status().message << " " << answer.status().pointer;
    return answer.ok() ? *answer : CommandAnswer{};
  }
  static std::uint64_t model_id(const Scene& scene) { return scene.model()->id; }
  static Paint paint_mask(const Scene& scene, std::size_t vertex) {
    Paint paint;
    paint.stroke = stroke_at(scene, vertex);
    paint.field = Field::mask, paint.value = 0;
    paint.brush.radius = 0.2, paint.brush.strength = 1, paint.brush.falloff = Falloff::constant;
    return paint;
  }
};

TEST_F(SubdivideSceneTest, FieldsSettingsAndRootsStayAndTheLogBeginsAnew) {
  const auto scene = make(Builtin::creature, 800);
  SetCoat coat;
  coat.coat.count = 123;
  run(*scene, {comb_at(*scene, 5), coat, Checkpoint{"combed", {}}});
  const SceneSummary before = scene->summary();
  const auto old = scene->model();
  const GroomSource combed = *scene->groom({});
  const SceneSummary after = subdivide(*scene);
  EXPECT_EQ(after.report.triangles, 4 * before.report.triangles);
  EXPECT_EQ(after.revision, before.revision + 1);
  EXPECT_EQ(after.undo_steps, 0u);
  EXPECT_NE(model_id(*scene), old->id);
  const SnapshotPtr now = scene->snapshot();
  const SceneView view = now->view();
  EXPECT_EQ(view.settings.coats[0].coat.count, 123);
  EXPECT_EQ(view.settings.eyes.size(), 2u);
  EXPECT_TRUE(view.settings.checkpoints.empty());
  for (std::uint32_t v = 0; v < combed.fields->size(); ++v) ASSERT_EQ(view.fields.at(v), combed.fields->at(v));
  EXPECT_EQ(view.model.subdivisions.size(), 1u);
  EXPECT_FALSE(scene->move(Undo{1}).ok()) << "undo does not reach over it";
}

TEST_F(SubdivideSceneTest, ARestartSubdividesAgain) {
  const auto scene = make(Builtin::knot, 600);
  run(*scene, {comb_at(*scene, 5), paint_mask(*scene, 40)});
  run(*scene, {ChangeMask{.action = MaskAction::invert}});
  subdivide(*scene, {.masked = true});
  run(*scene, {comb_at(*scene, 9)});
  subdivide(*scene, {.levels = 2, .masked = true});
  run(*scene, {comb_at(*scene, 40)});
  const SceneSummary before = scene->summary();
  const auto finer = scene->model();
  EXPECT_LT(before.report.triangles, 64u * 600);
  const std::string id = scene->id();
  open();
  const auto again = *store_->find(id);
  EXPECT_EQ(again->summary().fields_hash, before.fields_hash);
  EXPECT_EQ(again->revision(), before.revision);
  EXPECT_EQ(again->model()->subdivisions.size(), 3u);
  EXPECT_EQ(again->model()->subdivisions, finer->subdivisions);
  EXPECT_EQ(again->model()->surface.mesh().positions, finer->surface.mesh().positions);
  EXPECT_EQ(again->model()->surface.mesh().triangles, finer->surface.mesh().triangles);
  EXPECT_EQ(again->model()->patches.points.size(), finer->patches.points.size());
  EXPECT_EQ(again->effective_log().size(), 1u);
  move(*again, Undo{1});
  EXPECT_EQ(again->summary().undo_steps, 0u);
}

TEST_F(SubdivideSceneTest, AMaskThatChoosesNothingChangesNothing) {
  const auto scene = make(Builtin::torus, 400);
  run(*scene, {ChangeMask{.action = MaskAction::invert}});
  const SceneSummary before = scene->summary(), after = subdivide(*scene, {.levels = 3, .masked = true});
  EXPECT_EQ(after.revision, before.revision);
  EXPECT_EQ(after.report.triangles, before.report.triangles);
  EXPECT_EQ(after.undo_steps, 1u);
}

TEST_F(SubdivideSceneTest, TooManyTrianglesAreRefused) {
  const auto scene = make(Builtin::sphere, 8000);
  const auto refused = store_->subdivide(*scene, {.levels = 5});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().code, Code::invalid);
  EXPECT_EQ(refused.status().pointer, "/levels");
  EXPECT_EQ(store_->subdivide(*scene, {}, {.if_match = 7}).status().code, Code::precondition);
  EXPECT_EQ(scene->revision(), 0u);
}

TEST_F(SubdivideSceneTest, APictureStaysOnTheModel) {
  const auto scene = make(Builtin::plane, 100);
  const RawModel raw = testing::with_planar_uvs(make_builtin({Builtin::sphere, 300}));
  const StoredModel stored{.name = "obj", .raw = encode_raw_model(raw)};
  ASSERT_TRUE(scene->replace_model(*build_model(raw, stored, 1000), {}, stored).ok());
  ASSERT_TRUE(store_->store_skin_texture(*scene, testing::red_and_blue()).ok());
  subdivide(*scene);
  const auto bytes = [](const Scene& of) {
    std::vector<std::uint8_t> found;
    const SnapshotPtr now = of.snapshot();
    const SceneView view = now->view();
    if (view.skin_texture) found = view.skin_texture->rgba;
    return found;
  };
  EXPECT_EQ(bytes(*scene), testing::red_and_blue().rgba);
  const std::string id = scene->id();
  open();
  EXPECT_EQ(bytes(**store_->find(id)), testing::red_and_blue().rgba);
}

TEST_F(SubdivideSceneTest, AnotherScenesFieldsAreOneStepAndStay) {
  const auto source = make(Builtin::torus, 1500), target = make(Builtin::knot, 900);
  run(*source, {comb_at(*source, 5)});
  const Retarget take{.scene = source->id()};
  const CommandAnswer dry = *store_->execute(*target, {take}, {.dry_run = true});
  EXPECT_GT(dry.results[0].touched, 0u);
  EXPECT_EQ(target->revision(), 0u);
  const FieldsHash first = hash(*target);
  const CommandAnswer answer = run(*target, {take});
  EXPECT_EQ(answer.results[0].touched, dry.results[0].touched);
  EXPECT_EQ(answer.revision, 1u);
  const auto logged = std::get<Retarget>(target->effective_log()[0][0]);
  EXPECT_EQ(logged.revision, source->revision()) << "what was taken is in the log";
  run(*source, {comb_at(*source, 90)});
  move(*target, Undo{1});
  EXPECT_EQ(hash(*target), first);
  EXPECT_EQ(run(*target, {logged}).fields_hash, answer.fields_hash) << "the log replays";
  const std::string id = target->id(), other = source->id();
  ASSERT_TRUE(store_->remove(other).ok());
  open();
  EXPECT_EQ(hash(**store_->find(id)), answer.fields_hash) << "a restart does not need the source";
  const auto gone = store_->execute(**store_->find(id), {logged});
  EXPECT_EQ(gone.status().pointer, "/scene");
}

TEST_F(SubdivideSceneTest, TheSameSceneAtAnotherRevisionGivesTheBitsBack) {
  const auto scene = make(Builtin::creature, 900);
  const FieldsHash combed = run(*scene, {comb_at(*scene, 5)}).fields_hash;
  run(*scene, {comb_at(*scene, 90)});
  Retarget back{.scene = scene->id(), .revision = 1};
  EXPECT_EQ(run(*scene, {back}).fields_hash, combed);
  EXPECT_EQ(run(*scene, {Retarget{.scene = scene->id()}}).results[0].touched, 0u);
}

TEST_F(SubdivideSceneTest, SourcesHaveToBeThere) {
  const auto scene = make(), other = make();
  const auto refusal = [&](const std::vector<Command>& commands) { return store_->execute(*scene, commands).status(); };
  EXPECT_EQ(refusal({Retarget{.scene = "none"}}).pointer, "/scene");
  EXPECT_EQ(refusal({comb_at(*scene, 5), Retarget{.scene = "none"}}).pointer, "/commands/1/scene");
  EXPECT_EQ(refusal({Retarget{.scene = other->id(), .revision = 7}}).pointer, "/revision");
  EXPECT_EQ(scene->execute({Retarget{.scene = other->id()}}).status().pointer, "/scene");
  EXPECT_EQ(scene->revision(), 0u);
}

TEST_F(SubdivideSceneTest, ALogIsTransferredToAnotherModel) {
  const auto source = make(Builtin::torus, 1000), same = make(Builtin::torus, 1000), other = make(Builtin::knot, 1000);
  run(*source, {comb_at(*source, 5)});
  run(*source, {comb_at(*source, 50), ChangeMask{.shape = MaskSphere{vertex_position(*source, 3), 0.3, 0.2}}});
  const auto identical = source->effective_log_for(*same->model());
  ASSERT_TRUE(identical.ok());
  for (const std::vector<Command>& step : *identical) run(*same, step);
  EXPECT_EQ(hash(*same), hash(*source));
  const auto transferred = source->effective_log_for(*other->model());
  ASSERT_TRUE(transferred.ok());
  std::size_t touched = 0;
  for (const std::vector<Command>& step : *transferred) touched += run(*other, step).results[0].touched;
  EXPECT_GT(touched, 10u);
  run(*source, {ChangeMask{.shape = MaskVertices{{1, 2}}}});
  const auto refused = source->effective_log_for(*other->model());
  EXPECT_EQ(refused.status().pointer, "/vertices");
  EXPECT_NE(refused.status().message.find("step 3"), std::string::npos) << refused.status().message;
}

}  // namespace
}  // namespace pelage::subdivide_scene_test
