// A renderer on each backend.
#pragma once

#include "tests/gl/backends.h"

namespace pelage::testing {

class WithRenderer : public OnBackend {
 protected:
  void SetUp() override {
    OnBackend::SetUp();
    if (!context) return;
    const Result<Renderer*> made = stage.renderer(GetParam());
    ASSERT_TRUE(made.ok()) << made.status().message;
    renderer = *made;
  }

  Renderer* renderer = nullptr;
};

}  // namespace pelage::testing
