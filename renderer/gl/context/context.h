// A headless GL context, chosen at run time. One at a time for the process, current on one thread for its whole life.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/status.h"
#include "renderer/gl/functions.h"

namespace pelage {

/// automatic: a GPU's EGL device where there is one, else no GL. none: no GL. egl: hardware EGL devices, the software
/// device, surfaceless, the first that proves itself.
enum class GlChoice { automatic, none, egl, osmesa };

class Context {
 public:
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  const Gl& gl() const { return gl_; }
  /// "EGL device 0, llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6".
  const std::string& description() const { return description_; }

 protected:
  Context() = default;
  /// Loads the functions and proves the context by drawing and reading a pixel.
  Status prove(const std::string& name, const LoadFunction& find);

 private:
  Gl gl_;
  std::string description_;
};

/// Opens a context on the calling thread, each time another; null where there is to be no GL.
using ContextSource = std::function<Result<std::unique_ptr<Context>>()>;

/// The source for a renderer that draws without a GL.
inline Result<std::unique_ptr<Context>> without_gl() { return std::unique_ptr<Context>(); }

enum class EglPlatform { hardware_device, software_device, surfaceless };

/// Each makes a context and makes it current on the calling thread, or says (unavailable) what failed.
Result<std::unique_ptr<Context>> open_egl(EglPlatform platform);
/// Opens a context by the EGL device of that number, a GPU or a software one.
Result<std::unique_ptr<Context>> open_egl_device(int device);
Result<std::unique_ptr<Context>> open_osmesa();

/// Null where the choice is no GL. Fails (unavailable) with what was tried when egl or osmesa does not work: they never
/// fall back to another. `threads` bounds a software GL's threads (0: as many as cores) and must be set before any
/// context is made. `device` is the number of an EGL device, of automatic and egl; no other is tried then.
Result<std::unique_ptr<Context>> select_context(GlChoice choice, int threads, std::optional<int> device = {});

}  // namespace pelage
