// Caches the creature that was made last: it takes a second to make, and scenes tend to begin with the same one.
#pragma once

#include <memory>
#include <mutex>

#include "server/builtin/builtin.h"

namespace pelage {

/// Thread-safe.
class BuiltinCache {
 public:
  /// Returns make_builtin(wanted), from the cache if it is the last creature.
  std::shared_ptr<const RawModel> model(const BuiltinModel& wanted);

 private:
  std::mutex mutex_;
  int triangles_ = 0;
  std::shared_ptr<const RawModel> creature_;
};

}  // namespace pelage
