// A fixture with a renderer for each test.
#pragma once

#include <gtest/gtest.h>

#include "renderer/frame/renderer.h"

namespace pelage::testing {

class WithRenderer : public ::testing::Test {
 protected:
  Renderer* renderer = &renderer_;

 private:
  Renderer renderer_{{.threads = 2}};
};

}  // namespace pelage::testing
