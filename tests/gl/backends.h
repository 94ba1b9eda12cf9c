// Tests run on both GL drivers, EGL and OSMesa; those of a context's own ways on each way to open one. A backend that is missing skips with its reason, and fails in CI.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>

#include "renderer/gl/context/context.h"

namespace pelage::testing {

enum class Backend { egl_device, egl_surfaceless, osmesa };

inline std::string name_of(const ::testing::TestParamInfo<Backend>& info) {
  static const char* const names[] = {"egl_device", "egl_surfaceless", "osmesa"};
  return names[static_cast<int>(info.param)];
}

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

inline bool in_ci() {
  const char* ci = std::getenv("CI");
  return ci && std::string(ci) == "true";
}

class OnBackend : public ::testing::TestWithParam<Backend> {
 protected:
  void SetUp() override {
    Result<std::unique_ptr<Context>> opened = open(GetParam());
    if (opened) {
      context = std::move(opened).value();
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

  std::unique_ptr<Context> context;
};

/// The two drivers. Surfaceless EGL is the driver of the EGL device, and Backends holds it to the same bytes.
inline auto both_backends() { return ::testing::Values(Backend::egl_device, Backend::osmesa); }

/// Every way to open a context, for handles, plain frames and the golden pictures.
inline auto all_contexts() { return ::testing::Values(Backend::egl_device, Backend::egl_surfaceless, Backend::osmesa); }

}  // namespace pelage::testing
