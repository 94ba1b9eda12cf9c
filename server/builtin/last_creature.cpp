#include "server/builtin/last_creature.h"

namespace pelage {

namespace {

constexpr int max_triangles = 100'000;  // of one that is remembered, some megabytes

}  // namespace

std::shared_ptr<const RawModel> LastCreature::builtin(const BuiltinModel& model) {
  const bool remembered = model.shape == Builtin::creature && model.triangles <= max_triangles;
  {
    const std::lock_guard lock(mutex_);
    if (remembered && creature_ && triangles_ == model.triangles) return creature_;
  }
  auto made = std::make_shared<const RawModel>(make_builtin(model));
  if (!remembered) return made;
  const std::lock_guard lock(mutex_);
  triangles_ = model.triangles, creature_ = made;
  return made;
}

}  // namespace pelage
