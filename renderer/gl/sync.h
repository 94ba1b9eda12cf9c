// Queries to the GL about its drawing: a counter of drawn fragments, and a wait until the GL has finished.
#pragma once

#include <cstdint>

#include "base/status.h"
#include "renderer/gl/functions.h"
#include "renderer/gl/handles.h"

namespace pelage {

/// Runs of the fragment shader where the GL counts them (4.6 or ARB_pipeline_statistics_query; helpers that a driver
/// runs to fill a block may be among them), else samples that were drawn.
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

/// Waits until all that was asked for so far is done. Fails with unavailable when that takes longer than a minute.
Status wait_for(const Gl& gl);

}  // namespace pelage
