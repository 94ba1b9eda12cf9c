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
  /// Refused (invalid, with the pointer into the job): a parameter that is not there, keys whose values cannot be
  /// interpolated as asked, settings in a time lapse. A parameter that takes whole numbers alone is rounded between
  /// keys.
  static Result<Animation> create(const RenderJob& job, const SceneSettings& settings);

  /// The request, and the commands that set what keyframes change. Refused (invalid) as decoding does, with the pointer
  /// of the parameter ("/lights/0/intensity") and the frame in the message.
  Result<AnimatedFrame> at(double frame) const;
  /// Returns whether the job itself says the requests' max_seconds.
  bool limits_seconds() const;

 private:
  struct Impl;
  explicit Animation(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<const Impl> impl_;
};

}  // namespace pelage
