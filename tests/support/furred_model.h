// A model with a first groom, ready to be drawn without a server.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "protocol/commands/frame.h"
#include "renderer/frame/renderer.h"
#include "server/scene/scene.h"

namespace pelage::testing {

struct FurredModel {
  SceneModel model;
  FieldSet fields;
  SceneSettings settings;
  std::optional<RawImage> skin_texture = {};  // named by settings.skin_texture

  SceneView view(bool masked = false) const {
    return {model, fields, settings, 0, skin_texture ? &*skin_texture : nullptr, model.id, nullptr, masked};
  }
};

/// Prepares a model as the server does.
FurredModel furred(const RawModel& raw, FirstGroom fur = {});

/// Prepares a built-in as the server does.
FurredModel furred(BuiltinModel model, FirstGroom fur = {});

/// A ninth of the strands, each nine times as wide: they cover as much, and grow in a ninth of the time.
Coat coarse(Coat coat);
FurredModel coarse(FurredModel model);

/// Reads a PLY or OBJ file with the import worker beside this program; front is +Z. Throws if the file is refused.
FurredModel furred_file(const std::string& path, FirstGroom fur = {});

/// A small frame without tone map, so that values can be compared.
FrameRequest small_frame(AutoView view = AutoView::front, int size = 128);

/// Syncs the model if the renderer lacks it, and draws the whole picture.
Image draw(Renderer& renderer, const FurredModel& model, const FrameRequest& request);

/// Returns what drawing a whole frame asks of the GL. The renderer has the model.
FrameCounters counters_of(Renderer& renderer, const FurFrame& frame);

/// Share of pixels whose alpha is above half.
double covered(const Image& image);
/// Mean absolute difference of all channels, in 1/255.
double mean_difference(const Image& a, const Image& b);
int largest_difference(const Image& a, const Image& b);
/// Mean of red, green and blue over the pixels with alpha over `min`, in 1/255.
glm::dvec3 mean_colour(const Image& image, int min = 200);

}  // namespace pelage::testing
