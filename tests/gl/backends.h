// The GL backends of tests. Most tests run on both drivers, EGL and OSMesa; tests of contexts run on each way to open
// one. Tests of a missing backend are skipped with the reason, and fail in CI.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/gl/stage.h"

namespace pelage::testing {

inline std::string name_of_backend(Backend backend) {
  static const char* const names[] = {"egl_device", "egl_surfaceless", "osmesa"};
  return names[static_cast<int>(backend)];
}

/// The end of a test's name, by which CMake runs the tests of a driver.
inline std::string name_of(const ::testing::TestParamInfo<Backend>& info) { return name_of_backend(info.param); }

inline bool in_ci() {
  const char* ci = std::getenv("CI");
  return ci && std::string(ci) == "true";
}

class OnBackend : public ::testing::TestWithParam<Backend> {
 protected:
  void SetUp() override {
    const Result<Context*> opened = stage.context(GetParam());
    if (opened) {
      context = *opened;
      return;
    }
    if (in_ci()) FAIL() << opened.status().message;
    GTEST_SKIP() << opened.status().message;
  }
  void TearDown() override {
    if (!context) return;
    EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
  }
  const Gl& gl() const { return context->gl(); }

  Context* context = nullptr;
};

/// The two drivers. Surfaceless EGL uses the driver of the EGL device; the tests Backends.* expect the same bytes from
/// both.
inline auto both_backends() { return ::testing::Values(Backend::egl_device, Backend::osmesa); }

/// Every way to open a context, for handles, plain frames and the golden pictures.
inline auto all_contexts() { return ::testing::Values(Backend::egl_device, Backend::egl_surfaceless, Backend::osmesa); }

}  // namespace pelage::testing
