#include "server/scene/scene.h"

#include <chrono>
#include <thread>

#include "server/builtin/builtin.h"
#include "server/history/journal.h"
#include "server/scene/model.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::scene_test {
namespace {

using SceneTest = StoreTest;

TEST_F(SceneTest, ACommandTakesTheNextRevisionAndIsMeasured) {
  const auto scene = make();
  const FieldsHash first = hash(*scene);
  const CommandAnswer answer = execute(*scene, {comb_at(*scene, 5)});
  EXPECT_EQ(answer.revision, 1u);
  EXPECT_NE(answer.fields_hash, first);
  EXPECT_EQ(answer.fields_hash, hash(*scene));
  ASSERT_EQ(answer.results.size(), 1u);
  EXPECT_EQ(answer.results[0].op, "comb");
  EXPECT_GT(answer.results[0].touched, 5u);
  EXPECT_GT(answer.results[0].mean_change, 0);
  EXPECT_GE(answer.results[0].max_change, answer.results[0].mean_change);
  ASSERT_EQ(answer.results[0].fields.size(), 1u);
  EXPECT_EQ(answer.results[0].fields[0].field, "direction");
  EXPECT_EQ(answer.results[0].fields[0].changed, answer.results[0].touched);
}

TEST_F(SceneTest, AStrokeThatMissesMakesNoStep) {
  const auto scene = make();
  const CommandAnswer answer = execute(*scene, {comb_nothing(*scene)});
  EXPECT_EQ(answer.revision, 0u);
  EXPECT_EQ(answer.results[0].touched, 0u);
  EXPECT_EQ(scene->summary().undo_steps, 0u);
  EXPECT_TRUE(scene->log().empty());
  execute(*scene, {SetCoat{}});
  EXPECT_EQ(scene->revision(), 0u) << "the coat that it has already";
}

TEST_F(SceneTest, UndoRedoAndRevertTakeRevisionsOfTheirOwn) {
  const auto scene = make();
  std::vector<FieldsHash> hashes{hash(*scene)};
  for (const std::size_t v : {5u, 90u, 200u}) hashes.push_back(execute(*scene, {comb_at(*scene, v)}).fields_hash);
  const CommandAnswer undone = move(*scene, Undo{2});
  EXPECT_EQ(undone.revision, 4u);
  EXPECT_EQ(undone.fields_hash, hashes[1]);
  EXPECT_EQ(undone.results[0].op, "undo");
  EXPECT_EQ(move(*scene, Redo{1}).fields_hash, hashes[2]);
  const CommandAnswer reverted = move(*scene, Revert{3});
  EXPECT_EQ(reverted.revision, 6u);
  EXPECT_EQ(reverted.fields_hash, hashes[3]);
  EXPECT_EQ(scene->summary().redo_steps, 0u);
  EXPECT_EQ(move(*scene, Undo{1}).fields_hash, hashes[2]);
  EXPECT_EQ(move(*scene, Revert{0}).fields_hash, hashes[0]);
  EXPECT_TRUE(scene->effective_log().empty());
  EXPECT_EQ(scene->log().back().kind, "revert");
}

TEST_F(SceneTest, MovesThatCannotBeAreRefused) {
  const auto scene = make();
  execute(*scene, {comb_at(*scene, 5)});
  EXPECT_EQ(scene->move(Undo{2}).status().pointer, "/steps");
  EXPECT_EQ(scene->move(Redo{1}).status().code, Code::invalid);
  EXPECT_EQ(scene->move(Revert{2}).status().pointer, "/revision");
  EXPECT_EQ(move(*scene, Revert{1}).revision, 1u) << "where it is already";
}

TEST_F(SceneTest, ABatchIsAllOrNothingAndOneStep) {
  const auto scene = make();
  const FieldsHash first = hash(*scene);
  Comb bad = comb_at(*scene, 9);
  bad.stroke->samples[1].position = SurfaceSample{1u << 30, {}};
  const auto refused = scene->execute({comb_at(*scene, 5), bad});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().pointer, "/commands/1/stroke/samples/1/triangle");
  EXPECT_EQ(hash(*scene), first);
  EXPECT_EQ(scene->revision(), 0u);

  SetLook look;
  look.look.ambient = 1;
  const CommandAnswer answer = execute(*scene, {comb_at(*scene, 5), comb_nothing(*scene), look, comb_at(*scene, 6)});
  EXPECT_EQ(answer.revision, 1u);
  EXPECT_EQ(answer.results.size(), 4u);
  EXPECT_EQ(scene->summary().undo_steps, 1u);
  ASSERT_EQ(scene->effective_log().size(), 1u);
  EXPECT_EQ(scene->effective_log()[0].size(), 3u) << "without the one that missed";
  EXPECT_EQ(move(*scene, Undo{1}).fields_hash, first);
  EXPECT_EQ(scene->snapshot()->settings->look.ambient, Look{}.ambient);
}

TEST_F(SceneTest, ABatchGivesWhatItsCommandsGiveOneByOne) {
  const auto whole = make(), single = make();
  execute(*whole, {comb_at(*whole, 5), comb_at(*whole, 6), comb_at(*whole, 5)});
  for (const std::size_t v : {5u, 6u, 5u}) execute(*single, {comb_at(*single, v)});
  EXPECT_EQ(hash(*whole), hash(*single));
}

TEST_F(SceneTest, DryRunChangesNothing) {
  const auto scene = make();
  const FieldsHash first = hash(*scene);
  const CommandAnswer answer = execute(*scene, {comb_at(*scene, 5), comb_at(*scene, 6)}, {.dry_run = true});
  EXPECT_GT(answer.results[1].touched, 0u);
  EXPECT_EQ(answer.revision, 0u);
  EXPECT_EQ(hash(*scene), first);
  execute(*scene, {comb_at(*scene, 5)});
  const FieldsHash combed = hash(*scene);
  ASSERT_TRUE(scene->move(Undo{1}, {.dry_run = true}).ok());
  EXPECT_EQ(hash(*scene), combed);
  EXPECT_EQ(scene->revision(), 1u);
}

TEST_F(SceneTest, IfMatchNamesTheRevision) {
  const auto scene = make();
  EXPECT_EQ(scene->execute({comb_at(*scene, 5)}, {.if_match = 3}).status().code, Code::precondition);
  EXPECT_EQ(execute(*scene, {comb_at(*scene, 5)}, {.if_match = 0}).revision, 1u);
  EXPECT_EQ(scene->move(Undo{1}, {.if_match = 0}).status().code, Code::precondition);
}

TEST_F(SceneTest, PartsOfAStrokeAreOneStepAndTheWholeStroke) {
  const auto live = make(), sent_whole = make();
  Comb whole = comb_at(*live, 5);
  whole.stroke = stroke_at(*live, 5, 12);
  execute(*sent_whole, {whole});
  for (std::uint32_t part = 0; part < 4; ++part) {
    Comb part_command = whole;
    const auto begin = whole.stroke->samples.begin() + 3 * part;
    part_command.stroke->samples.assign(begin, begin + 3);
    part_command.stroke->id = "k7";
    part_command.stroke->part = part;
    part_command.stroke->last = part == 3;
    EXPECT_EQ(execute(*live, {part_command}).revision, part + 1);
  }
  EXPECT_EQ(hash(*live), hash(*sent_whole));
  EXPECT_EQ(live->summary().undo_steps, 1u);
  EXPECT_EQ(live->log()[2].kind, "join");
  ASSERT_EQ(live->effective_log().size(), 1u);
  EXPECT_EQ(stroke_of(live->effective_log()[0][0])->samples.size(), 12u);
  Comb late = whole;
  late.stroke->id = "k7";
  late.stroke->part = 4;
  EXPECT_EQ(live->execute({late}).status().code, Code::conflict);
  const FieldsHash first = hash(*make());
  EXPECT_EQ(move(*live, Undo{1}).fields_hash, first);
}

TEST_F(SceneTest, BatchesTakeWholeStrokes) {
  const auto scene = make();
  Comb part = comb_at(*scene, 5);
  part.stroke->id = "k";
  part.stroke->last = false;
  EXPECT_EQ(scene->execute({comb_at(*scene, 6), part}).status().pointer, "/commands/1/stroke/part");
}

TEST_F(SceneTest, SnapshotsKnowWhatTheLastChangesTouched) {
  const auto scene = make();
  const SnapshotPtr before = scene->snapshot();
  EXPECT_TRUE(before->changes.since(before->changes.number())->empty());
  execute(*scene, {comb_at(*scene, 5)});
  execute(*scene, {comb_at(*scene, 300)});
  const SnapshotPtr after = scene->snapshot();
  const auto touched = after->changes.since(before->changes.number());
  ASSERT_TRUE(touched && !touched->empty());
  for (std::uint32_t v = 0; v < before->fields->size(); ++v) {
    const bool in_a_range =
        std::any_of(touched->begin(), touched->end(), [v](VertexRange r) { return r.begin <= v && v < r.end; });
    EXPECT_TRUE(in_a_range || after->fields->at(v) == before->fields->at(v)) << v;
  }
  EXPECT_FALSE(before->changes.since(after->changes.number())) << "an older snapshot knows nothing of later changes";
}

TEST_F(SceneTest, SnapshotsForgetWhatChangedLongAgo) {
  RecentChanges changes;
  for (std::uint32_t k = 0; k < RecentChanges::max_known + 10; ++k) changes = changes.with({{3 * k, 3 * k + 1}});
  EXPECT_EQ(changes.since(10)->size(), RecentChanges::max_known);
  EXPECT_EQ(changes.since(10)->front().begin, 30u);
  EXPECT_FALSE(changes.since(9));
}

TEST_F(SceneTest, PickTellsWhatLiesUnderAPixel) {
  const auto scene = make(Builtin::sphere, 2000);
  const View view{.camera = {.automatic = AutoView::front}, .width = 300, .height = 300};
  const Result<PickAnswer> hit = scene->pick({view, {150, 150}});
  ASSERT_TRUE(hit.ok());
  EXPECT_TRUE(hit->hit);
  EXPECT_NEAR(hit->normal.z, 1, 1e-2);
  EXPECT_NEAR(hit->length, 0.03, 1e-3);
  EXPECT_NEAR(hit->inclination, 0.45, 0.3);
  EXPECT_NEAR(glm::dot(hit->direction, hit->normal), 0, 1e-9);
  EXPECT_FALSE(scene->pick({view, {1, 1}})->hit);
}

TEST_F(SceneTest, PickFollowsARay) {
  const auto scene = make(Builtin::sphere, 2000);
  const auto hit = [&](glm::dvec3 origin, glm::dvec3 direction) {
    return *scene->pick({.ray = PickRay{origin, direction}});
  };
  EXPECT_NEAR(hit({9, 0, 0}, {-1, 0, 0}).normal.x, 1, 1e-2);
  EXPECT_NEAR(hit({0, 9, 0}, {0, -1e-6, 0}).normal.y, 1, 1e-2);
  EXPECT_FALSE(hit({9, 0, 0}, {1, 0, 0}).hit) << "away from it";
  EXPECT_TRUE(hit({0, 0, 0}, {0, 0, 1e6}).hit) << "from within";
}

TEST_F(SceneTest, PickFindsTheNearestPosition) {
  const auto scene = make(Builtin::sphere, 2000);
  const PickAnswer found = *scene->pick({.nearest = glm::dvec3(0, 0, 40)});
  EXPECT_NEAR(found.normal.z, 1, 1e-2);
  EXPECT_NEAR(glm::distance(found.position, scene->pick({.nearest = found.position})->position), 0, 1e-6);
}

TEST_F(SceneTest, PickFindsTheFarthestPositionInABox) {
  const auto scene = make(Builtin::sphere, 20000);
  const PickAnswer top = *scene->pick({.farthest = PickFarthest{{0, 2, 0}}});
  EXPECT_NEAR(top.normal.y, 1, 1e-2);
  const double radius = top.position.y;
  const glm::dvec3 low(-radius), high(radius, 0.5 * radius, radius);
  const PickAnswer cut = *scene->pick({.farthest = PickFarthest{{0, 1, 0}, low, high}});
  EXPECT_NEAR(cut.position.y, 0.5 * radius, 1e-6) << "on the box's side, within a triangle";
  EXPECT_NEAR(glm::length(cut.position), radius, 0.01 * radius);
  const glm::dvec3 aside(0.2 * radius, -radius, 0);
  const PickAnswer edge = *scene->pick({.farthest = PickFarthest{{0, 1, 0}, aside, glm::dvec3(radius)}});
  EXPECT_NEAR(edge.position.x, aside.x, 1e-6);
  EXPECT_NEAR(edge.position.y, std::sqrt(1 - 0.04) * radius, 0.01 * radius);
  const PickFarthest beside{{0, 1, 0}, glm::dvec3(2 * radius), glm::dvec3(3 * radius)};
  EXPECT_FALSE(scene->pick({.farthest = beside})->hit);
}

TEST_F(SceneTest, PickTellsWhatIsPainted) {
  const auto scene = make(Builtin::sphere, 2000);
  const View view{.camera = {.automatic = AutoView::front}, .width = 300, .height = 300};
  const auto value = [&](Field field) {
    return scene->pick({view, {150, 150}})->painted[static_cast<std::size_t>(field) - first_painted];
  };
  EXPECT_NEAR(value(Field::density).x, 1, 1e-6) << "at its default";
  EXPECT_EQ(value(Field::root_colour), glm::dvec4(0));
  Paint thin{.flood = true, .field = Field::density, .value = 0.25};
  Paint red{.flood = true, .field = Field::root_colour, .value = 0.5, .colour = {0.8f, 0.1f, 0}};
  thin.brush.strength = red.brush.strength = 1;
  execute(*scene, {thin, red});
  EXPECT_NEAR(value(Field::density).x, 0.25, 1e-6);
  EXPECT_NEAR(glm::distance(value(Field::root_colour), glm::dvec4(0.8, 0.1, 0, 0.5)), 0, 1e-5);
  EXPECT_EQ(value(Field::tip_colour), glm::dvec4(0));
}

TEST_F(SceneTest, ANewModelStartsAnEmptyLogAtTheNextRevision) {
  const auto scene = make();
  execute(*scene, {comb_at(*scene, 5)});
  const RawModel raw = make_builtin({Builtin::plane, 200});
  const StoredModel stored{.name = "obj", .raw = {}};
  const auto model = build_model(raw, stored, 77);
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(scene->replace_model(*model, {}, stored, false, {.if_match = 0}).status().code, Code::precondition);
  const auto replaced = scene->replace_model(*model, {.length = 0.1}, stored);
  ASSERT_TRUE(replaced.ok());
  EXPECT_EQ(replaced->revision, 2u);
  EXPECT_EQ(replaced->model, "obj");
  EXPECT_EQ(replaced->undo_steps, 0u);
  EXPECT_TRUE(scene->log().empty());
  EXPECT_EQ(scene->move(Revert{0}).status().code, Code::invalid);
  EXPECT_EQ(execute(*scene, {comb_at(*scene, 5)}).revision, 3u);
}

TEST_F(SceneTest, WaitingEndsWithNewsOrWithTheTime) {
  const auto scene = make();
  EXPECT_EQ(scene->wait_newer(0, 0.01), 0u);
  std::thread artist([&] { execute(*scene, {comb_at(*scene, 5)}); });
  EXPECT_EQ(scene->wait_newer(0, 60), 1u);
  artist.join();
  std::thread remover([&] { EXPECT_TRUE(store_->remove(scene->id()).ok()); });
  EXPECT_EQ(scene->wait_newer(1, 60), 1u);
  remover.join();
  EXPECT_EQ(scene->execute({comb_at(*scene, 5)}).status().code, Code::not_found);
}

TEST_F(SceneTest, ManyArtistsAtOnceLoseNothing) {
  const auto scene = make();
  std::vector<std::thread> artists;
  for (std::size_t a = 0; a < 4; ++a) {
    artists.emplace_back([&, a] {
      for (std::size_t i = 0; i < 10; ++i) execute(*scene, {comb_at(*scene, 37 * a + i)});
    });
  }
  for (std::thread& artist : artists) artist.join();
  EXPECT_EQ(scene->revision(), 40u);
  const FieldsHash combed = hash(*scene);
  const auto again = make();
  for (const auto& step : scene->effective_log()) execute(*again, step);
  EXPECT_EQ(hash(*again), combed);
}

}  // namespace
}  // namespace pelage::scene_test
