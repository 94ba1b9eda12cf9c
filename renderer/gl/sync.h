// A counter of drawn fragments, and a wait until the GL has finished.
#pragma once

#include <cstdint>

#include "base/status.h"
#include "renderer/gl/functions.h"
#include "renderer/gl/handles.h"

namespace pelage {

/// Counts invocations of the fragment shader if the GL can (4.6 or ARB_pipeline_statistics_query; helper invocations
/// may be included), else samples that passed the depth test.
class FragmentCounter {
 public:
  explicit FragmentCounter(const Gl& gl);

  void begin() const;
  void end() const;
  /// Returns the count between the last begin and end. Waits for the GL to finish.
  std::uint64_t result() const;

 private:
  const Gl* gl_;
  GLenum target_;
  QueryObject query_;
};

/// Waits until the GL has done all commands so far. Fails with unavailable if that takes longer than a minute.
Status wait_for(const Gl& gl);

}  // namespace pelage
