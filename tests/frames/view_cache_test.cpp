// Which views the cache keeps.
#include "renderer/frame/view_cache.h"

#include <array>
#include <cmath>

#include "tests/frames/raster_views.h"

namespace pelage::testing::view_cache_test {
namespace {

class CachedViews : public RasterViews {
 protected:
  /// Paints around a vertex: a change that moves no fur does not redraw the whole picture.
  std::vector<DirtyRange> painted(FurredModel& model) {
    const Mesh& mesh = model.model.surface.mesh();
    const glm::vec3 middle = mesh.positions[random() % mesh.positions.size()];
    const float red = std::uniform_real_distribution<float>(0, 1)(random);
    std::vector<DirtyRange> dirty;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
      if (glm::distance(mesh.positions[v], middle) < 0.1f)
        model.fields.set(Field::tip_colour, v, {red, 0.5f, 0.5f, 1}), dirty.push_back({v, v + 1});
    return dirty;
  }
};

// Each view accumulates the changes since it was last drawn itself.
TEST_F(CachedViews, SeveralAreCached) {
  FurredModel model = animal();
  const std::array views{AutoView::front, AutoView::left, AutoView::top};
  const auto from = [&](AutoView view, const std::vector<DirtyRange>& changed) {
    request.camera.automatic = view;
    return drawn(model, changed);
  };
  drawn(model, painted(model));
  for (const AutoView view : views) EXPECT_EQ(from(view, painted(model)).redrawn, 1);
  for (const AutoView view : views) EXPECT_LT(from(view, painted(model)).redrawn, 1);
  std::vector<Image> cached;
  for (const AutoView view : views) cached.push_back(from(view, {}).image);
  raster.clear_view_cache();
  for (std::size_t i = 0; i < views.size(); ++i) EXPECT_EQ(cached[i].rgba, from(views[i], {}).image.rgba) << i;
}

TEST_F(CachedViews, OfSeveralScenes) {
  FurredModel one = animal(), other = animal();
  for (FurredModel* model : {&one, &other}) drawn(*model, painted(*model));
  for (FurredModel* model : {&one, &other}) {
    EXPECT_LT(drawn(*model, painted(*model)).redrawn, 1);
    EXPECT_EQ(drawn(*model).redrawn, 0);
  }
  const Image cached = drawn(one).image;
  EXPECT_EQ(cached.rgba, whole(one).rgba);
}

// Frames of an orbit are not requested again, so they do not evict the view of somebody who grooms meanwhile.
TEST_F(CachedViews, AnOrbitLeavesWhatComesBack) {
  FurredModel model = animal();
  const FrameRequest groomed = request;
  drawn(model, painted(model));
  drawn(model, painted(model));
  for (int frame = 0; frame < 6; ++frame) {
    request.camera.automatic = AutoView::none;
    request.camera.position = {2 * std::sin(0.1 * frame), 0, 2 * std::cos(0.1 * frame)};
    request.camera.target = {0, 0, 0};
    drawn(model);
  }
  request = groomed;
  EXPECT_LT(drawn(model, painted(model)).redrawn, 1);
  request.width = request.height = 2100;  // too large for the cache
  EXPECT_EQ(drawn(model).redrawn, 1);
  EXPECT_EQ(drawn(model).redrawn, 1);
  request = groomed;
  EXPECT_EQ(drawn(model).redrawn, 0);
}

}  // namespace
}  // namespace pelage::testing::view_cache_test
