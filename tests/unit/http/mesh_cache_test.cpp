#include "server/http/mesh_cache.h"

#include <gtest/gtest.h>

#include <thread>

#include "server/builtin/builtin.h"
#include "server/patches/patches.h"
#include "server/surface/prepare.h"

namespace pelage {
namespace {

std::shared_ptr<const SceneModel> ball(std::uint64_t id, int triangles = 1000) {
  Mesh mesh = *prepare(make_sphere(triangles));
  return std::shared_ptr<const SceneModel>(new SceneModel{Surface(std::move(mesh)), PatchMap{}, id, "sphere"});
}

TEST(MeshCache, TheSameMeshIsMadeOnce) {
  MeshCache cache;
  const auto model = ball(1), other = ball(2);
  const auto first = cache.mesh(model, 200);
  ASSERT_TRUE(first.ok());
  EXPECT_EQ(*cache.mesh(model, 200), *first);
  EXPECT_NE(*cache.mesh(model, 300), *first);
  EXPECT_NE(*cache.mesh(other, 200), *first);
  EXPECT_EQ(*cache.mesh(model, 5000), *cache.mesh(model, 6000)) << "both are the whole model";
}

TEST(MeshCache, TheLastEightAreKept) {
  MeshCache cache;
  const auto model = ball(1);
  const auto first = *cache.mesh(model, 100), second = *cache.mesh(model, 101);
  for (int triangles = 102; triangles < 108; ++triangles) EXPECT_TRUE(cache.mesh(model, triangles).ok());
  EXPECT_EQ(*cache.mesh(model, 100), first);
  EXPECT_TRUE(cache.mesh(model, 108).ok());
  EXPECT_EQ(*cache.mesh(model, 100), first) << "it was asked for since";
  EXPECT_NE(*cache.mesh(model, 101), second);
}

TEST(MeshCache, DropsTheMeshesOfAModelThatIsGone) {
  MeshCache cache;
  const auto model = ball(1);
  auto gone = ball(2);
  const std::weak_ptr<const ProxyMesh> file = *cache.mesh(gone, 200);
  EXPECT_FALSE(file.expired());
  gone.reset();
  EXPECT_TRUE(cache.mesh(model, 200).ok());
  EXPECT_TRUE(file.expired());
}

SceneSnapshot scene_of(const std::shared_ptr<const SceneModel>& model, Revision revision = 0) {
  SceneSnapshot scene;
  scene.model = model, scene.revision = revision;
  return scene;
}

TEST(MeshCache, TagsAreOfModelTrianglesAndProcess) {
  const MeshCache cache;
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const MeshCache later;
  const SceneSnapshot scene = scene_of(ball(1)), other = scene_of(ball(2)), changed = scene_of(scene.model, 1);
  const std::string tag = cache.etag_of(scene, {200});
  EXPECT_EQ(cache.etag_of(changed, {200}), tag);
  for (const std::string& different :
       {cache.etag_of(scene, {201}), cache.etag_of(other, {200}), later.etag_of(scene, {200})}) {
    EXPECT_NE(different, tag);
  }
  EXPECT_EQ(cache.etag_of(scene, {5000}), cache.etag_of(scene, {6000}));
}

TEST(MeshCache, TagsOfFurAreOfTheRevisionToo) {
  const MeshCache cache;
  const SceneSnapshot scene = scene_of(ball(1)), changed = scene_of(scene.model, 1);
  const MeshRequest wanted{200, true};
  EXPECT_EQ(cache.etag_of(scene, wanted), cache.etag_of(scene_of(scene.model), wanted));
  EXPECT_NE(cache.etag_of(scene, wanted), cache.etag_of(changed, wanted));
  EXPECT_NE(cache.etag_of(scene, wanted), cache.etag_of(scene, {200}));
}

TEST(MeshCache, ClientsThatAskTogetherGetOneMesh) {
  MeshCache cache;
  const auto model = ball(1, 20'000);
  std::vector<MeshCache::MeshPtr> meshes(6);
  std::vector<std::thread> clients;
  for (MeshCache::MeshPtr& mesh : meshes) clients.emplace_back([&] { mesh = *cache.mesh(model, 500); });
  for (std::thread& client : clients) client.join();
  for (const MeshCache::MeshPtr& mesh : meshes) EXPECT_EQ(mesh, meshes.front());
}

}  // namespace
}  // namespace pelage
