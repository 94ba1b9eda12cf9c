// One GL context and one renderer for all tests of a process that use the same driver, because creating them and
// compiling their programs takes longer than most tests. Between tests both are reset to the state of new ones.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "renderer/frame/renderer.h"
#include "renderer/gl/context/context.h"

namespace pelage::testing {

enum class Backend { egl_device, egl_surfaceless, osmesa };

inline Result<std::unique_ptr<Context>> open(Backend backend) {
  switch (backend) {
    case Backend::egl_device: {
      Result<std::unique_ptr<Context>> hardware = open_egl(EglPlatform::hardware_device);
      return hardware ? std::move(hardware) : open_egl(EglPlatform::software_device);
    }
    case Backend::egl_surfaceless: return open_egl(EglPlatform::surfaceless);
    case Backend::osmesa: break;
  }
  return open_osmesa();
}

/// Resets the state that passes and tests change to that of a new context.
inline void reset_state(const Gl& gl) {
  for (const GLenum capability : {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST}) gl.Disable(capability);
  gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_TRUE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.UseProgram(0);
  gl.BindVertexArray(0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

class Stage : public ::testing::Environment {
 public:
  /// Returns the context of a driver, current and in the state of a new one. Closes that of another driver first. Fails
  /// as opening does.
  Result<Context*> context(Backend backend) {
    if (!context_ || backend != backend_) {
      close();
      Result<std::unique_ptr<Context>> opened = open(backend);
      if (!opened) return opened.status();
      context_ = std::move(opened).value();
      backend_ = backend;
    }
    reset_state(context_->gl());
    return context_.get();
  }

  /// Returns the renderer on that context, without models and pictures of earlier tests.
  Result<Renderer*> renderer(Backend backend) {
    const Result<Context*> context = this->context(backend);
    if (!context) return context.status();
    if (!renderer_) {
      Result<std::unique_ptr<Renderer>> made = Renderer::create((*context)->gl());
      if (!made) return made.status();
      renderer_ = std::move(made).value();
    }
    renderer_->forget_all();
    return renderer_.get();
  }

  /// Returns a renderer like that which draws strands by the GL too.
  Result<Renderer*> strands_renderer(Backend backend) {
    const Result<Context*> context = this->context(backend);
    if (!context) return context.status();
    if (!strands_) {
      Result<std::unique_ptr<Renderer>> made =
          Renderer::create((*context)->gl(), {.threads = 2, .software_gl_draws_strands = true});
      if (!made) return made.status();
      strands_ = std::move(made).value();
    }
    strands_->forget_all();
    return strands_.get();
  }

  void TearDown() override { close(); }

 private:
  void close() {
    renderer_.reset(), strands_.reset();
    context_.reset();
  }

  Backend backend_ = Backend::egl_device;
  std::unique_ptr<Context> context_;
  std::unique_ptr<Renderer> renderer_, strands_;
};

/// GoogleTest owns it and closes it after the last test.
inline Stage& stage = *static_cast<Stage*>(::testing::AddGlobalTestEnvironment(new Stage));

}  // namespace pelage::testing
