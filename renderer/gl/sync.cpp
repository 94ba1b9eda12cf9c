#include "renderer/gl/sync.h"

namespace pelage {

FragmentCounter::FragmentCounter(const Gl& gl)
    : gl_(&gl), target_(GL_FRAGMENT_SHADER_INVOCATIONS), query_(gl, target_) {
  if (gl.GetError() == GL_NO_ERROR) return;
  target_ = GL_SAMPLES_PASSED;
  query_ = QueryObject(gl, target_);
}

void FragmentCounter::begin() const { gl_->BeginQuery(target_, query_.id()); }

void FragmentCounter::end() const { gl_->EndQuery(target_); }

std::uint64_t FragmentCounter::result() const {
  GLuint64 count = 0;
  gl_->GetQueryObjectui64v(query_.id(), GL_QUERY_RESULT, &count);
  return count;
}

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
