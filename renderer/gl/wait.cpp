#include "renderer/gl/wait.h"

namespace pelage {

namespace {

constexpr GLuint64 idle_timeout = 60'000'000'000;  // nanoseconds

}  // namespace

Status wait_for(const Gl& gl) {
  const GLsync fence = gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  const GLenum answer = gl.ClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, idle_timeout);
  gl.DeleteSync(fence);
  const bool given_up = answer == GL_TIMEOUT_EXPIRED || answer == GL_WAIT_FAILED;
  return given_up ? failure(Code::unavailable, "the GL does not answer") : Status{};
}

}  // namespace pelage
