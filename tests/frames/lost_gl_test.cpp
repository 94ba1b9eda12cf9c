// If the GL is reset, nothing of a scene is lost, and its frame is still drawn.
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <atomic>

#include "server/frames/frame_service.h"
#include "tests/frames/drawn.h"
#include "tests/support/furred_model.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::testing::lost_gl_test {
namespace {

std::atomic<int> resets = 0;  // resets left to report; global, since glGetGraphicsResetStatus has no argument

GLenum APIENTRY reset_status() {
  if (resets <= 0) return GL_NO_ERROR;
  --resets;
  return GL_UNKNOWN_CONTEXT_RESET;
}

/// OSMesa with a faked reset status.
class ResetContext final : public Context {
 public:
  static Result<std::unique_ptr<Context>> open() {
    auto made = std::make_unique<ResetContext>();
    Result<std::unique_ptr<Context>> mesa = open_osmesa();
    if (!mesa) return mesa.status();
    made->mesa_ = std::move(*mesa);
    void* library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    const auto find = reinterpret_cast<decltype(&OSMesaGetProcAddress)>(dlsym(library, "OSMesaGetProcAddress"));
    const Status proved = made->prove("OSMesa", [find](const char* name) {
      const bool of_resets = std::string_view(name) == "glGetGraphicsResetStatus";
      return reinterpret_cast<void*>(of_resets ? reinterpret_cast<OSMESAproc>(reset_status) : find(name));
    });
    if (!proved.ok()) return proved;
    return std::unique_ptr<Context>(std::move(made));
  }

 private:
  std::unique_ptr<Context> mesa_;
};

class LostGl : public StoreTest {
 protected:
  void SetUp() override {
    StoreTest::SetUp();
    resets = 0;
    const ContextSource source = [this] {
      ++opened_;
      return opened_ > 1 && !again_ ? without_gl() : ResetContext::open();
    };
    auto started = FrameService::start(source, 2, gate_);
    ASSERT_TRUE(started.ok()) << started.status().message;
    frames_ = std::move(*started);
    scene_ = make();
    execute(*scene_, {SetCoat{.coat = coarse(Coat())}});
  }
  void TearDown() override {
    frames_.reset(), scene_.reset();
    StoreTest::TearDown();
  }

  Result<FrameAnswer> draw(Method method) {
    FrameRequest request;
    request.width = request.height = 64;
    request.knobs.method = method, request.knobs.shells.count = 4;
    return drawn_frame(*frames_, scene_, request);
  }

  std::atomic<int> opened_ = 0;
  std::atomic<bool> again_ = true;  // whether a second GL can be opened
  YieldGate gate_;
  std::unique_ptr<FrameService> frames_;
  std::shared_ptr<Scene> scene_;
};

TEST_F(LostGl, TheFrameIsDrawnByAnother) {
  const std::string before = draw(Method::shells)->bytes;
  execute(*scene_, {comb_at(*scene_, 5)});
  const std::string combed = draw(Method::shells)->bytes;
  ASSERT_NE(combed, before);
  resets = 1;
  const Result<FrameAnswer> after = draw(Method::shells);
  ASSERT_TRUE(after.ok()) << after.status().message;
  EXPECT_EQ(after->bytes, combed);
  EXPECT_EQ(opened_, 2);
  EXPECT_EQ(frames_->lost_contexts(), 1u);
  EXPECT_TRUE(frames_->healthy());
}

TEST_F(LostGl, AFrameThatLosesTwoIsRefusedAndTheNextIsDrawn) {
  const std::string before = draw(Method::shells)->bytes;
  resets = 2;
  const Result<FrameAnswer> refused = draw(Method::shells);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().code, Code::unavailable);
  EXPECT_EQ(opened_, 3);
  EXPECT_TRUE(frames_->healthy());
  const Result<FrameAnswer> next = draw(Method::shells);
  ASSERT_TRUE(next.ok()) << next.status().message;
  EXPECT_EQ(next->bytes, before);
}

TEST_F(LostGl, WithoutAnotherStrandsAreDrawnAsBefore) {
  const std::string strands = draw(Method::raster)->bytes;
  EXPECT_NE(frames_->description().find("shells by OSMesa"), std::string::npos) << frames_->description();
  again_ = false, resets = 1;
  EXPECT_EQ(draw(Method::shells).status().pointer, "/quality/method");
  EXPECT_EQ(draw(Method::raster)->bytes, strands);
  EXPECT_TRUE(frames_->healthy());
  EXPECT_EQ(draw(Method::shells).status().pointer, "/quality/method");
  EXPECT_EQ(opened_, 2);
  EXPECT_EQ(frames_->description().find("shells"), std::string::npos) << frames_->description();
}

}  // namespace
}  // namespace pelage::testing::lost_gl_test
