// What errors of scenes were measured, so that the next frames of like views are planned by them.
#pragma once

#include <cstdint>
#include <map>

#include "renderer/quality/error_model.h"
#include "renderer/quality/planner.h"

namespace pelage {

/// Keeps the measured errors of the scenes that were asked for last, of one coat in one light seen from about as far:
/// of other views nothing is known. Equal requests in a row get equal knobs.
class ErrorLog {
 public:
  static constexpr std::size_t max_scenes = 256;
  static constexpr double slack = 0.15;  // of each trait, in [0, 1], up to which views are alike

  /// What is known of the frame's scene; nothing yet where it was never seen like this. Stays until the next call.
  MeasuredErrors& of(const FurFrame& frame, const ErrorTraits& in_range);

 private:
  struct Scene {
    ErrorTraits traits{};
    FurFrame frame;  // that was first seen like this
    MeasuredErrors errors;
    std::uint64_t used = 0;

    bool is_like(const FurFrame& other, const ErrorTraits& others) const;
  };

  std::map<std::uint64_t, Scene> scenes_;
  std::uint64_t clock_ = 0;
};

}  // namespace pelage
