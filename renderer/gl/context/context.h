// A headless GL context, chosen at run time. A process has one at a time, which stays current on one thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/status.h"
#include "renderer/gl/functions.h"

namespace pelage {

/// Which context to open. automatic: a GPU's EGL device if there is one, else no GL. none: no GL. egl: the first that
/// works of the hardware EGL devices, the software device and surfaceless. osmesa: Mesa's off-screen library.
enum class GlChoice { automatic, none, egl, osmesa };

class Context {
 public:
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  const Gl& gl() const { return gl_; }
  /// Returns a text such as "EGL device 0, llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6".
  const std::string& description() const { return description_; }

 protected:
  Context() = default;
  /// Loads the functions and tests the context by drawing and reading a pixel.
  Status prove(const std::string& name, const LoadFunction& find);

 private:
  Gl gl_;
  std::string description_;
};

/// Opens a new context on the calling thread at each call; null if there is to be no GL.
using ContextSource = std::function<Result<std::unique_ptr<Context>>()>;

/// The source for a renderer that draws without a GL.
inline Result<std::unique_ptr<Context>> without_gl() { return std::unique_ptr<Context>(); }

enum class EglPlatform { hardware_device, software_device, surfaceless };

/// Opens a context and makes it current on the calling thread. Fails with unavailable, naming what failed; so do the
/// next two.
Result<std::unique_ptr<Context>> open_egl(EglPlatform platform);
/// Opens a context on the EGL device with this number, a GPU or a software one.
Result<std::unique_ptr<Context>> open_egl_device(int device);
Result<std::unique_ptr<Context>> open_osmesa();

/// Opens the chosen context; null if there is to be no GL. If egl, osmesa or a given device does not work, fails with
/// unavailable, naming what was tried; they never fall back to another choice. `threads` bounds the threads of a
/// software GL (0: as many as cores); it only takes effect at the first context of the process. `device` is the number
/// of an EGL device, for automatic and egl; no other device is tried then.
Result<std::unique_ptr<Context>> select_context(GlChoice choice, int threads, std::optional<int> device = {});

}  // namespace pelage
