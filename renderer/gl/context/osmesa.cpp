// Contexts by OSMesa, Mesa's off-screen library. It is opened at run time because newer Mesa no longer has it.
#include <dlfcn.h>

#include <array>

// osmesa.h comes last, as its own GL header is older.
// clang-format off
#include "renderer/gl/context/context.h"

#include <GL/osmesa.h>
// clang-format on

namespace pelage {

namespace {

struct OsMesa {
  decltype(&OSMesaCreateContextAttribs) create = nullptr;
  decltype(&OSMesaDestroyContext) destroy = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetProcAddress) get = nullptr;
};

Result<OsMesa> open_osmesa_library() {
  void* library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (!library) return failure(Code::unavailable, "libOSMesa.so.8 cannot be opened");
  OsMesa mesa;
  const auto get = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
  };
  get(mesa.create, "OSMesaCreateContextAttribs");
  get(mesa.destroy, "OSMesaDestroyContext");
  get(mesa.make_current, "OSMesaMakeCurrent");
  get(mesa.get, "OSMesaGetProcAddress");
  if (!mesa.create || !mesa.destroy || !mesa.make_current || !mesa.get) {
    return failure(Code::unavailable, "libOSMesa.so.8 lacks functions");
  }
  return mesa;
}

class OsMesaContext final : public Context {
 public:
  explicit OsMesaContext(const OsMesa& mesa) : mesa_(mesa) {}
  ~OsMesaContext() override {
    if (context_) mesa_.destroy(context_);
  }

  Status open() {
    constexpr std::array<int, 11> wanted{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         4,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         5,
                                         OSMESA_DEPTH_BITS,
                                         0,
                                         0};
    context_ = mesa_.create(wanted.data(), nullptr);
    if (!context_) return failure(Code::unavailable, "OSMesa has no OpenGL 4.5 core");
    // The default framebuffer is required but never drawn to.
    if (!mesa_.make_current(context_, pixels_.data(), GL_UNSIGNED_BYTE, 4, 4)) {
      return failure(Code::unavailable, "OSMesaMakeCurrent failed");
    }
    return prove("OSMesa", [this](const char* name) { return reinterpret_cast<void*>(mesa_.get(name)); });
  }

 private:
  OsMesa mesa_;
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 64> pixels_{};
};

}  // namespace

Result<std::unique_ptr<Context>> open_osmesa() {
  const Result<OsMesa> mesa = open_osmesa_library();
  if (!mesa) return mesa.status();
  auto context = std::make_unique<OsMesaContext>(*mesa);
  const Status status = context->open();
  if (!status.ok()) return status;
  return std::unique_ptr<Context>(std::move(context));
}

}  // namespace pelage
