// A coat's pattern on a model: the volume of its colours, and the slow changes at the vertices.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/gl/handles.h"
#include "renderer/pattern/pattern.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

/// Made anew when the model, the pattern, its variation or the colours change; kept for one model.
class PatternTextures {
 public:
  explicit PatternTextures(const Gl& gl) : uniforms_(gl) {}

  /// Leaves the uniform block at binding 1 and the volume at texture unit 8.
  void prepare(const Gl& gl, std::uint64_t model_id, const Coat& coat, ModelBuffers& model);

 private:
  void send_volume(const Gl& gl, const PatternBlock& block, const ModelBuffers& model);

  Buffer uniforms_;
  Texture volume_;
  std::uint64_t model_ = 0;
  std::optional<PatternBlock> block_;
};

}  // namespace pelage
