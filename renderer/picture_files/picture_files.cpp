#include "renderer/picture_files/picture_files.h"

#include <dlfcn.h>

#include <stdexcept>

namespace pelage {

namespace {

const PictureFiles& load() {
  void* library = dlopen("$ORIGIN/pelage-pictures.so", RTLD_NOW | RTLD_LOCAL);
  void* entry = library ? dlsym(library, "pelage_picture_files") : nullptr;
  if (!entry) throw std::runtime_error(std::string("Picture files cannot be read or written: ") + dlerror());
  return *reinterpret_cast<const PictureFiles* (*)()>(entry)();
}

}  // namespace

const PictureFiles& picture_files() {
  static const PictureFiles& files = load();
  return files;
}

}  // namespace pelage
