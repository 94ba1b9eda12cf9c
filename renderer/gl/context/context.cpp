#include "renderer/gl/context/context.h"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <functional>
#include <vector>

#include "renderer/gl/handles.h"

namespace pelage {

namespace {

std::string text(const Gl& gl, GLenum name) {
  const GLubyte* value = gl.GetString(name);
  return value ? reinterpret_cast<const char*>(value) : "?";
}

bool draws_a_pixel(const Gl& gl) {
  const RenderTarget target(gl, GL_RGBA8, 1, 1, false);
  if (!target.complete()) return false;
  const std::array<float, 4> colour{0.2f, 0.4f, 0.6f, 1.0f};
  gl.ClearNamedFramebufferfv(target.framebuffer(), GL_COLOR, 0, colour.data());
  std::array<GLubyte, 4> pixel{};
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer());
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  return pixel == std::array<GLubyte, 4>{51, 102, 153, 255};
}

}  // namespace

Status Context::prove(const std::string& name, const LoadFunction& find) {
  const std::string missing = gl_.load(find);
  if (!missing.empty()) return failure(Code::unavailable, fmt::format("{}: no {}", name, missing));
  description_ = fmt::format("{}, {}, OpenGL {}", name, text(gl_, GL_RENDERER), text(gl_, GL_VERSION));
  if (!draws_a_pixel(gl_)) return failure(Code::unavailable, description_ + ": a test pixel came out wrong");
  return {};
}

namespace {

using Opener = std::function<Result<std::unique_ptr<Context>>()>;

std::vector<Opener> openers_of(GlChoice choice, std::optional<int> device) {
  if (device) return {[device] { return open_egl_device(*device); }};
  const auto egl = [](EglPlatform platform) { return Opener([platform] { return open_egl(platform); }); };
  switch (choice) {
    case GlChoice::automatic: return {egl(EglPlatform::hardware_device)};
    case GlChoice::none: return {};
    case GlChoice::egl:
      return {egl(EglPlatform::hardware_device), egl(EglPlatform::software_device), egl(EglPlatform::surfaceless)};
    case GlChoice::osmesa: return {open_osmesa};
  }
  return {};
}

}  // namespace

Result<std::unique_ptr<Context>> select_context(GlChoice choice, int threads, std::optional<int> device) {
  // llvmpipe takes its number of threads from this variable only, and reads it once, when it is initialized.
  if (threads > 0) setenv("LP_NUM_THREADS", std::to_string(threads > 1 ? threads : 0).c_str(), 1);
  std::string tried;
  for (const Opener& open : openers_of(choice, device)) {
    Result<std::unique_ptr<Context>> context = open();
    if (context) return context;
    tried += (tried.empty() ? "" : "; ") + context.status().message;
  }
  if (!device && (choice == GlChoice::automatic || choice == GlChoice::none)) return std::unique_ptr<Context>();
  return with_next(failure(Code::unavailable, "no OpenGL 4.5: " + tried + "."),
                   "use --gl auto, which needs no GL; or install Mesa, as deploy/packages.sh build does");
}

}  // namespace pelage
