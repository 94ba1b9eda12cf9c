// Keyframes over the JSON of a frame request and of a scene's settings: any parameter of the contract can be animated,
// and is checked as the contract checks it.
#pragma once

#include <memory>

#include "base/status.h"
#include "protocol/commands/job.h"
#include "protocol/commands/settings.h"

namespace pelage {

class Animation {
 public:
  /// Refuses (invalid, with the pointer into the job) parameters that do not exist, keys whose values cannot be
  /// interpolated as requested, and settings in a time lapse. A parameter that takes whole numbers only is rounded
  /// between keys.
  static Result<Animation> create(const RenderJob& job, const SceneSettings& settings);

  /// Returns the request of a frame, and the commands that set the settings with keyframes. Refuses (invalid) what
  /// decoding refuses, with the pointer of the parameter ("/lights/0/intensity") and the frame in the message.
  Result<AnimatedFrame> at(double frame) const;
  /// Returns whether the job itself sets max_seconds of its requests.
  bool limits_seconds() const;

 private:
  struct Impl;
  explicit Animation(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<const Impl> impl_;
};

}  // namespace pelage
