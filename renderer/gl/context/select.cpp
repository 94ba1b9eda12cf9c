#include <cstdlib>
#include <functional>
#include <vector>

#include "renderer/gl/context/context.h"

namespace pelage {

namespace {

using Opener = std::function<Result<std::unique_ptr<Context>>()>;

std::vector<Opener> openers_of(GlChoice choice) {
  std::vector<Opener> openers;
  if (choice != GlChoice::osmesa) {
    for (const EglPlatform platform :
         {EglPlatform::hardware_device, EglPlatform::software_device, EglPlatform::surfaceless}) {
      openers.emplace_back([platform] { return open_egl(platform); });
    }
  }
  if (choice != GlChoice::egl) openers.emplace_back(open_osmesa);
  return openers;
}

}  // namespace

Result<std::unique_ptr<Context>> select_context(GlChoice choice, int threads) {
  // The only door that llvmpipe has for its thread count; read once, when its screen is made.
  if (threads > 0) setenv("LP_NUM_THREADS", std::to_string(threads > 1 ? threads : 0).c_str(), 1);
  std::string tried;
  for (const Opener& open : openers_of(choice)) {
    Result<std::unique_ptr<Context>> context = open();
    if (context) return context;
    tried += (tried.empty() ? "" : "; ") + context.status().message;
  }
  return with_next(failure(Code::unavailable, "no OpenGL 4.5: " + tried + "."),
                   choice == GlChoice::automatic ? "install Mesa, as deploy/packages.sh build does"
                                                 : "try --gl auto; or install Mesa, as deploy/packages.sh build does");
}

}  // namespace pelage
