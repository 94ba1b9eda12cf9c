#include "renderer/gl/fragment_counter.h"

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

}  // namespace pelage
