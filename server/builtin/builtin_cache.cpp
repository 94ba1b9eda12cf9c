#include "server/builtin/builtin_cache.h"

namespace pelage {

namespace {

constexpr int max_triangles = 100'000;  // of a creature that is cached; some megabytes

}  // namespace

std::shared_ptr<const RawModel> BuiltinCache::model(const BuiltinModel& wanted) {
  const bool remembered = wanted.shape == Builtin::creature && wanted.triangles <= max_triangles;
  {
    const std::lock_guard lock(mutex_);
    if (remembered && creature_ && triangles_ == wanted.triangles) return creature_;
  }
  auto made = std::make_shared<const RawModel>(make_builtin(wanted));
  if (!remembered) return made;
  const std::lock_guard lock(mutex_);
  triangles_ = wanted.triangles, creature_ = made;
  return made;
}

}  // namespace pelage
