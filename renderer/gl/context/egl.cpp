// EGL without a window system: the device platform and Mesa's surfaceless one. The library is opened at run time, so
// that a machine without EGL still starts with OSMesa.
#include <dlfcn.h>

#include <array>
#include <cstring>
#include <vector>

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include "renderer/gl/context/context.h"

namespace pelage {

namespace {

struct Egl {
  decltype(&eglGetProcAddress) get = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC platform_display = nullptr;
  PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;
  PFNEGLQUERYDEVICESTRINGEXTPROC device_string = nullptr;
  decltype(&eglInitialize) initialize = nullptr;
  decltype(&eglBindAPI) bind_api = nullptr;
  decltype(&eglCreateContext) create_context = nullptr;
  decltype(&eglDestroyContext) destroy_context = nullptr;
  decltype(&eglMakeCurrent) make_current = nullptr;
  decltype(&eglGetError) error = nullptr;
};

template <class Function>
void get(const Egl& egl, Function& function, const char* name) {
  function = reinterpret_cast<Function>(egl.get(name));
}

/// The library stays open for the life of the process: drivers do not survive being unloaded.
Result<Egl> open_egl_library() {
  void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (!library) return failure(Code::unavailable, "libEGL.so.1 cannot be opened");
  Egl egl;
  egl.get = reinterpret_cast<decltype(egl.get)>(dlsym(library, "eglGetProcAddress"));
  if (!egl.get) return failure(Code::unavailable, "libEGL.so.1 has no eglGetProcAddress");
  get(egl, egl.platform_display, "eglGetPlatformDisplayEXT");
  get(egl, egl.query_devices, "eglQueryDevicesEXT");
  get(egl, egl.device_string, "eglQueryDeviceStringEXT");
  get(egl, egl.initialize, "eglInitialize");
  get(egl, egl.bind_api, "eglBindAPI");
  get(egl, egl.create_context, "eglCreateContext");
  get(egl, egl.destroy_context, "eglDestroyContext");
  get(egl, egl.make_current, "eglMakeCurrent");
  get(egl, egl.error, "eglGetError");
  if (!egl.platform_display || !egl.initialize || !egl.create_context || !egl.make_current || !egl.bind_api) {
    return failure(Code::unavailable, "libEGL.so.1 lacks platform displays");
  }
  return egl;
}

struct NamedDisplay {
  EGLDisplay display;
  std::string name;
};

/// Returns all EGL devices; a device's number is its index.
std::vector<EGLDeviceEXT> devices_of(const Egl& egl) {
  std::vector<EGLDeviceEXT> devices(32);
  EGLint count = 0;
  if (!egl.query_devices || !egl.query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count)) return {};
  devices.resize(static_cast<std::size_t>(count));
  return devices;
}

NamedDisplay display_of(const Egl& egl, const std::vector<EGLDeviceEXT>& devices, std::size_t number) {
  return {egl.platform_display(EGL_PLATFORM_DEVICE_EXT, devices[number], nullptr),
          fmt::format("EGL device {}", number)};
}

std::vector<NamedDisplay> device_displays(const Egl& egl, bool software) {
  const std::vector<EGLDeviceEXT> devices = devices_of(egl);
  std::vector<NamedDisplay> displays;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const char* extensions = egl.device_string ? egl.device_string(devices[i], EGL_EXTENSIONS) : nullptr;
    const bool is_software = extensions && std::strstr(extensions, "EGL_MESA_device_software");
    if (is_software == software) displays.push_back(display_of(egl, devices, i));
  }
  return displays;
}

std::vector<NamedDisplay> displays_of(const Egl& egl, EglPlatform platform) {
  if (platform != EglPlatform::surfaceless) return device_displays(egl, platform == EglPlatform::software_device);
  return {{egl.platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), "EGL surfaceless"}};
}

/// Never terminates its display: eglTerminate would end it for all contexts of the process on the same platform.
class EglContext final : public Context {
 public:
  explicit EglContext(const Egl& egl) : egl_(egl) {}
  ~EglContext() override {
    if (context_ == EGL_NO_CONTEXT) return;
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_.destroy_context(display_, context_);
  }

  Status open(const NamedDisplay& named) {
    display_ = named.display;
    if (display_ == EGL_NO_DISPLAY || !egl_.initialize(display_, nullptr, nullptr))
      return refuse(named, "eglInitialize");
    if (!egl_.bind_api(EGL_OPENGL_API)) return refuse(named, "eglBindAPI");  // has to be called on each thread
    if (!create(true) && !create(false)) return refuse(named, "eglCreateContext (OpenGL 4.5 core)");
    if (!egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) return refuse(named, "eglMakeCurrent");
    return prove(named.name, [this](const char* name) { return reinterpret_cast<void*>(egl_.get(name)); });
  }

 private:
  /// `reports_reset`: requests a context that reports a reset of the device (glGetGraphicsResetStatus); not every
  /// driver has it.
  bool create(bool reports_reset) {
    std::vector<EGLint> wanted{EGL_CONTEXT_MAJOR_VERSION,       4,
                               EGL_CONTEXT_MINOR_VERSION,       5,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
    if (reports_reset)
      wanted.insert(wanted.end(), {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
    wanted.push_back(EGL_NONE);
    context_ = egl_.create_context(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
    return context_ != EGL_NO_CONTEXT;
  }
  Status refuse(const NamedDisplay& named, const char* call) const {
    return failure(Code::unavailable, fmt::format("{}: {} failed (0x{:x})", named.name, call, egl_.error()));
  }

  Egl egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

/// Opens a context on the first display that works.
Result<std::unique_ptr<Context>> open_first(const Egl& egl, const std::vector<NamedDisplay>& displays) {
  std::string tried;
  for (const NamedDisplay& named : displays) {
    auto context = std::make_unique<EglContext>(egl);
    const Status status = context->open(named);
    if (status.ok()) return std::unique_ptr<Context>(std::move(context));
    tried += (tried.empty() ? "" : "; ") + status.message;
  }
  return failure(Code::unavailable, tried);
}

}  // namespace

Result<std::unique_ptr<Context>> open_egl(EglPlatform platform) {
  const Result<Egl> egl = open_egl_library();
  if (!egl) return egl.status();
  const std::vector<NamedDisplay> displays = displays_of(*egl, platform);
  if (!displays.empty()) return open_first(*egl, displays);
  const bool software = platform == EglPlatform::software_device;
  return failure(Code::unavailable, software ? "EGL has no software device" : "EGL has no hardware device");
}

Result<std::unique_ptr<Context>> open_egl_device(int device) {
  const Result<Egl> egl = open_egl_library();
  if (!egl) return egl.status();
  const std::vector<EGLDeviceEXT> devices = devices_of(*egl);
  if (device < 0 || static_cast<std::size_t>(device) >= devices.size())
    return failure(Code::unavailable, fmt::format("EGL has {} devices, and none of number {}", devices.size(), device));
  return open_first(*egl, {display_of(*egl, devices, static_cast<std::size_t>(device))});
}

}  // namespace pelage
