// Culled triangles have no rows of data, and nothing may read them, not even for pixels next to visible ones.
#include <gtest/gtest.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "server/builtin/builtin.h"
#include "tests/support/furred_model.h"
#include "tests/support/textured.h"

namespace pelage::testing {
namespace {

/// Fills newly allocated memory with NaN.
class PoisonedMemory {
 public:
  PoisonedMemory() { poison(256); }  // the allocator writes 255 minus the lowest byte
  ~PoisonedMemory() { poison(0); }

 private:
  static void poison([[maybe_unused]] int byte) {
#ifdef __GLIBC__
    mallopt(M_PERTURB, byte);
#endif
  }
};

TEST(UnwrittenMemory, IsNotReadForTexturesOfWhatIsCulled) {
  FurredModel model = furred(with_planar_uvs(make_builtin({Builtin::sphere, 3000})));
  model.skin_texture = red_and_blue();
  model.settings.skin_texture = "0123456789abcdef0123456789abcdef";
  FrameRequest request = small_frame(AutoView::none, 160);
  const Mesh& mesh = model.model.surface.mesh();
  for (const glm::dvec3 direction : {glm::dvec3(1, 0, 0), glm::dvec3(0, 0.2, 1), glm::dvec3(-1, -0.4, 0)}) {
    request.camera.position = mesh.to_model(0.9 * direction), request.camera.target = mesh.to_model({0, 0.25, 0});
    Renderer plain{RendererOptions{}};
    const Image expected = draw(plain, model, request);
    const PoisonedMemory poisoned;
    Renderer renderer{RendererOptions{}};
    EXPECT_EQ(largest_difference(draw(renderer, model, request), expected), 0);
  }
}

}  // namespace
}  // namespace pelage::testing
