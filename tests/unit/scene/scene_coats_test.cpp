// Coats in a scene: grooming one of several, undo, restarts, the log, subdivided and turned models.
#include "server/fields/coats.h"
#include "server/scene/scene.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::scene_coats_test {
namespace {

class SceneCoatsTest : public StoreTest {
 protected:
  static SetCoats with_mane(CoatRegion region = CoatRegion::all) {
    return {{{.name = "fur"}, {.name = "mane", .begins = CoatBeginning{.region = region}}}};
  }
  static Comb comb_of(const Scene& scene, std::size_t vertex, const std::string& coat) {
    Comb comb = comb_at(scene, vertex);
    comb.coats = {coat};
    return comb;
  }
  static std::vector<NamedCoat> coats(const Scene& scene) { return scene.settings()->settings.coats; }
  /// The largest difference of a coat's direction between two scenes of one model.
  static double turned(const Scene& a, const Scene& b, CoatId coat) {
    double largest = 0;
    const FieldSet one = a.snapshot()->fields->of_coat(coat), two = b.snapshot()->fields->of_coat(coat);
    for (std::uint32_t v = 0; v < one.size(); ++v)
      largest =
          std::max(largest, double{glm::distance(one.value(Field::direction, v), two.value(Field::direction, v))});
    return largest;
  }
};

TEST_F(SceneCoatsTest, AToolChangesTheCoatsThatItNames) {
  const auto scene = make(), untouched = make();
  execute(*scene, {with_mane()}), execute(*untouched, {with_mane()});
  execute(*scene, {comb_of(*scene, 5, "mane")});
  EXPECT_EQ(turned(*scene, *untouched, 0), 0);
  EXPECT_GT(turned(*scene, *untouched, 1), 0.1);
  execute(*scene, {comb_at(*scene, 5)});
  EXPECT_GT(turned(*scene, *untouched, 0), 0.1) << "all of them unless named";
}

TEST_F(SceneCoatsTest, AllCoatsThatWereAlikeStayAlikeAndWhatTheyShareChangesOnce) {
  const auto plain = make(), scene = make();
  execute(*scene, {with_mane()});
  for (const auto& one : {plain, scene}) {
    execute(*one, {comb_at(*one, 5)});
    Paint bare;
    bare.field = Field::bare, bare.value = 1, bare.flood = true, bare.brush.strength = 1;
    execute(*one, {bare});
  }
  EXPECT_EQ(turned(*plain, *scene, 0), 0);
  const FieldSet mane = scene->snapshot()->fields->of_coat(1), fur = plain->snapshot()->fields->of_coat(0);
  for (std::uint32_t v = 0; v < fur.size(); ++v) {
    ASSERT_EQ(mane.value(Field::direction, v), fur.value(Field::direction, v));
    ASSERT_EQ(mane.number(Field::bare, v), fur.number(Field::bare, v));
  }
  EXPECT_EQ(mane.number(Field::bare, 0), 1);
}

TEST_F(SceneCoatsTest, UndoRedoARestartAndTheLogGiveTheSame) {
  const auto scene = make(), replayed = make();
  const FieldsHash first = hash(*scene);
  execute(*scene, {with_mane(CoatRegion::none)});
  execute(*scene, {comb_of(*scene, 9, "mane"), comb_of(*scene, 40, "fur")});
  execute(*scene, {SetCoats{{{.name = "ruff", .id = 1}, {.name = "fur", .muted = true}}}});
  const FieldsHash last = hash(*scene);
  const std::vector<NamedCoat> named = coats(*scene);
  EXPECT_EQ(named[0].name, "ruff");
  move(*scene, Undo{3});
  EXPECT_EQ(hash(*scene), first);
  EXPECT_EQ(coats(*scene).size(), 1u);
  move(*scene, Redo{3});
  EXPECT_EQ(hash(*scene), last);
  EXPECT_EQ(coats(*scene), named);
  for (const std::vector<Command>& step : scene->effective_log()) execute(*replayed, step);
  EXPECT_EQ(hash(*replayed), last);
  EXPECT_EQ(coats(*replayed), named);
  const std::string id = scene->id();
  open();
  EXPECT_EQ(hash(**store_->find(id)), last);
  EXPECT_EQ(coats(**store_->find(id)), named);
}

TEST_F(SceneCoatsTest, ThatAreMutedAreNotGroomed) {
  const auto scene = make();
  execute(*scene, {with_mane()});
  execute(*scene, {SetCoats{{{.name = "fur"}, {.name = "mane", .muted = true}}}});
  const FieldSet before = scene->snapshot()->fields->of_coat(1);
  execute(*scene, {comb_at(*scene, 5)});
  const FieldSet after = scene->snapshot()->fields->of_coat(1);
  for (std::uint32_t v = 0; v < before.size(); ++v)
    ASSERT_EQ(before.value(Field::direction, v), after.value(Field::direction, v));
  const auto refused = scene->execute({comb_of(*scene, 5, "mane")});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().pointer, "/coats/0");
}

TEST_F(SceneCoatsTest, ACoatStaysAsItIsWhereItWasNotThereYet) {
  const auto scene = make();
  execute(*scene, {with_mane(CoatRegion::none)});
  execute(*scene, {comb_at(*scene, 5)});
  const FieldSet mane = scene->snapshot()->fields->of_coat(1);
  const auto erased = scene->execute({Erase{.flood = true, .brush = {.strength = 1}}});
  ASSERT_TRUE(erased.ok());
  ASSERT_EQ(erased->results[0].warnings.size(), 1u);
  EXPECT_NE(erased->results[0].warnings[0].find("mane"), std::string::npos);
  EXPECT_EQ(turned(*scene, *make(), 0), 0) << "the first coat is as it was";
  const FieldSet after = scene->snapshot()->fields->of_coat(1);
  for (std::uint32_t v = 0; v < mane.size(); ++v) {
    ASSERT_EQ(after.value(Field::direction, v), mane.value(Field::direction, v));
    ASSERT_EQ(after.number(Field::density, v), 0);
  }
}

TEST_F(SceneCoatsTest, AnEditLayerOfACoatStoresItsChangesAlone) {
  const auto scene = make(), untouched = make();
  execute(*scene, {with_mane()}), execute(*untouched, {with_mane()});
  execute(*scene, {ChangeEditLayer{.name = "swept", .coat = "mane"}});
  Comb comb = comb_at(*scene, 5);
  comb.edit_layer = "swept";
  execute(*scene, {comb});
  EXPECT_EQ(turned(*scene, *untouched, 0), 0);
  EXPECT_GT(turned(*scene, *untouched, 1), 0.1);
  execute(*scene, {SetCoats{{{.name = "fur"}, {.name = "ruff", .id = 1}}}});
  EXPECT_EQ(scene->summary().edit_layers[0].coat, "ruff");
  const auto unknown = scene->execute({ChangeEditLayer{.name = "other", .coat = "beard"}});
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.status().pointer, "/coat");
}

TEST_F(SceneCoatsTest, GoAlongWhenTheModelIsSplitOrTurned) {
  const auto scene = make();
  execute(*scene, {with_mane()});
  execute(*scene, {comb_of(*scene, 5, "mane")});
  const FieldSet before = scene->snapshot()->fields->of_coat(1);
  ASSERT_TRUE(scene->subdivide({.levels = 1}, 1000).ok());
  const FieldSet after = scene->snapshot()->fields->of_coat(1);
  ASSERT_GT(after.size(), before.size());
  for (std::uint32_t v = 0; v < before.size(); ++v)
    ASSERT_EQ(after.value(Field::direction, v), before.value(Field::direction, v));
  EXPECT_EQ(coats(*scene)[1].name, "mane");
}

TEST_F(SceneCoatsTest, AStrandOfTheOutermostCoatIsWhatAPixelMeets) {
  const auto scene = make(Builtin::sphere);
  execute(*scene, {Length{.flood = true, .brush = {.strength = 1}, .value = 0.02}});
  SetCoats longer = with_mane();
  longer.coats[1].begins->length = 10;
  execute(*scene, {longer});
  Comb comb;
  comb.brush.radius = 0.01;
  comb.stroke.emplace().samples = {{.position = ScreenSample{{200, 11}}}, {.position = ScreenSample{{210, 11}}}};
  comb.stroke->view = View{.camera = {.automatic = AutoView::front}, .width = 400, .height = 400};
  const auto touched = [&] { return scene->execute({comb}, {.dry_run = true})->results[0].touched; };
  const std::size_t with_long = touched();
  execute(*scene, {SetCoats{{{.name = "fur"}, {.name = "mane", .muted = true}}}});
  EXPECT_GT(with_long, 0u) << "above the ball there is the mane";
  EXPECT_EQ(touched(), 0u) << "or nothing";
}

}  // namespace
}  // namespace pelage::scene_coats_test
