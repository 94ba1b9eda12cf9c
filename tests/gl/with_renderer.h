// A renderer on each backend.
#pragma once

#include <memory>

#include "renderer/frame/renderer.h"
#include "tests/gl/backends.h"

namespace pelage::testing {

class WithRenderer : public OnBackend {
 protected:
  void SetUp() override {
    OnBackend::SetUp();
    if (!context) return;
    Result<std::unique_ptr<Renderer>> made = Renderer::create(gl());
    ASSERT_TRUE(made.ok()) << made.status().message;
    renderer = std::move(made).value();
  }
  void TearDown() override {
    renderer.reset();
    OnBackend::TearDown();
  }

  std::unique_ptr<Renderer> renderer;
};

}  // namespace pelage::testing
