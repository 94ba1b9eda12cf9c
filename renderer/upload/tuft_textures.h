// A coat's tufts on a model.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/gl/handles.h"
#include "renderer/pattern/tufts.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

/// Made anew when the model or the tufts change; kept for one model.
class TuftTextures {
 public:
  explicit TuftTextures(const Gl& gl) : uniforms_(gl) {}

  /// Leaves the uniform block at binding 7 and the volume at texture unit 13.
  void prepare(const Gl& gl, std::uint64_t model_id, const Tufts& tufts, const ModelBuffers& model);

 private:
  void send(const Gl& gl, const Tufts& tufts, const ModelBuffers& model);

  Buffer uniforms_;
  Texture volume_;
  std::uint64_t model_ = 0;
  std::optional<Tufts> tufts_;
};

}  // namespace pelage
