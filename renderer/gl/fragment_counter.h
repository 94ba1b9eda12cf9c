// How many fragments were drawn, as the GL counts them.
#pragma once

#include <cstdint>

#include "renderer/gl/handles.h"

namespace pelage {

/// Runs of the fragment shader where the GL counts them (4.6 or ARB_pipeline_statistics_query; helpers that a driver
/// runs to fill a block may be among them), else samples that were drawn.
class FragmentCounter {
 public:
  explicit FragmentCounter(const Gl& gl);

  void begin() const;
  void end() const;
  /// Between the last begin and end. Waits for the GL to finish them.
  std::uint64_t result() const;

 private:
  const Gl* gl_;
  GLenum target_;
  QueryObject query_;
};

}  // namespace pelage
