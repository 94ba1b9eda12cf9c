#include "renderer/gl/handles.h"

#include "renderer/gl/program.h"
#include "tests/gl/backends.h"

namespace pelage::testing::handles_test {
namespace {

class Handles : public OnBackend {};

template <class Object, class... Arguments>
void lives_moves_and_dies(const Gl& gl, Arguments... arguments) {
  Object first(gl, arguments...);
  const GLuint id = first.id();
  EXPECT_NE(id, 0u);
  Object second(std::move(first));
  EXPECT_EQ(second.id(), id);
  EXPECT_EQ(first.id(), 0u);  // NOLINT: what is left after a move is part of the contract
  Object third;
  EXPECT_FALSE(third);
  third = std::move(second);
  EXPECT_EQ(third.id(), id);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(Handles, LiveMoveAndDie) {
  lives_moves_and_dies<Buffer>(gl());
  lives_moves_and_dies<VertexArray>(gl());
  lives_moves_and_dies<Framebuffer>(gl());
  lives_moves_and_dies<Renderbuffer>(gl());
  lives_moves_and_dies<Texture>(gl(), GLenum{GL_TEXTURE_2D});
}

TEST_P(Handles, StorageIsCountedUntilItIsGivenBack) {
  const std::size_t before = gl().storage_bytes();
  {
    const Buffer buffer(gl());
    gl().NamedBufferData(buffer.id(), 1000, nullptr, GL_STATIC_DRAW);
    gl().NamedBufferData(buffer.id(), 400, nullptr, GL_STATIC_DRAW);
    EXPECT_EQ(gl().bytes_of_buffer(buffer.id()), 400u);
    const Texture texture(gl(), GLenum{GL_TEXTURE_2D_ARRAY});
    gl().TextureStorage3D(texture.id(), 3, GL_RGBA8, 4, 4, 5);
    EXPECT_EQ(gl().bytes_of_texture(texture.id()), 4u * 5 * (16 + 4 + 1));
    EXPECT_EQ(gl().storage_bytes() - before, 400u + 420);
    const RenderTarget target(gl(), GL_RGBA32F, 8, 2, true);
    EXPECT_EQ(gl().storage_bytes() - before, 400u + 420 + 16 * (16 + 4));
  }
  EXPECT_EQ(gl().storage_bytes(), before);
}

TEST_P(Handles, TargetsOfEveryKindAreComplete) {
  for (const GLenum colour : {GL_RGBA8, GL_RGBA16F, GL_RGBA32F}) {
    const RenderTarget target(gl(), colour, 17, 5, true);
    EXPECT_TRUE(target.complete()) << std::hex << colour;
    EXPECT_TRUE(target.matches(colour, 17, 5));
    EXPECT_FALSE(target.matches(colour, 17, 6));
  }
}

TEST_P(Handles, BrokenShaderSaysWhy) {
  const Program program(gl(), "#version 450 core\nvoid main() { gl_Position = nonsense; }\n",
                        "#version 450 core\nvoid main() {}\n");
  EXPECT_EQ(program.id(), 0u);
  EXPECT_NE(program.log().find("nonsense"), std::string::npos) << program.log();
}

INSTANTIATE_TEST_SUITE_P(Gl, Handles, all_contexts(), name_of);

}  // namespace
}  // namespace pelage::testing::handles_test
