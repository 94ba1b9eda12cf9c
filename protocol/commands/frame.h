// Frame requests: camera, view, format, overlay, AOVs, and the knobs of the drawing methods.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "protocol/commands/look.h"

namespace pelage {

/// Cameras that the server places itself. `front` looks from +Z, `left` at
/// the animal's left side, from +X; each frames the bare model, never the fur.
enum class AutoView { none, front, back, left, right, top, three_quarter };

/// A pinhole camera in the model's own coordinates (right-handed, Y up). Ignored but for `automatic` unless that is
/// none.
struct Camera {
  AutoView automatic = AutoView::three_quarter;
  glm::dvec3 position{0, 0, 1};
  glm::dvec3 target{0};     // differs from position
  glm::dvec3 up{0, 1, 0};   // not along the view
  double fov_degrees = 35;  // vertical, [1, 150]
};

/// What a pixel sample or a pick refers to: the camera and the size of the frame it was drawn on.
struct View {
  Camera camera;
  int width = 512;   // [1, 8192]
  int height = 512;  // [1, 8192]
};

// What a frame request says: the size, the camera and the quality.

enum class Tier { draft, interactive, detailed, reference };
/// raster: rasterized strands. strands: all strands, ray traced. shells: the shells of GPU fur, drawn by a GL.
enum class Method { raster, strands, shells };
/// How light gets through traced fur: by the colour and count of the strands that a ray to the light crosses, or along
/// whole paths that scatter from strand to strand.
enum class Transport { transmittance, paths };
/// Which model traced strands scatter by: the look's, as shells, or energy_conserving whatever the look says. Paths
/// scatter by energy_conserving in either case: no other model conserves energy.
enum class StrandScattering { look, energy_conserving };
enum class ShellPolicy { uniform, adaptive };  // adaptive: fewer shells where the view needs fewer (fur modelling 2)
/// four_pass: skin, depth of dense fur, back-facing fur, front-facing fur (after Scheuermann 2004). sorted: the
/// fragments of each pixel by depth, slow and exact.
enum class FragmentOrder { four_pass, sorted };
enum class ToneMap { none, filmic };
enum class Background { colour, transparent, studio };  // studio: a soft gradient with darker corners
/// `npy` is a NumPy array of the pixels of `png`, bytes [height, width, 4]; `npy_linear` one of what an EXR of floats
/// holds, [height, width, channels] in the order of its AOVs.
enum class FrameFormat { png, png16, jpeg, webp, exr, npy, npy_linear };

/// Returns whether the format holds linear light and AOVs, without exposure, tone map and background.
constexpr bool is_linear(FrameFormat format) { return format == FrameFormat::exr || format == FrameFormat::npy_linear; }
/// Returns whether it leaves out what is hardly seen.
constexpr bool is_lossy(FrameFormat format) { return format == FrameFormat::jpeg || format == FrameFormat::webp; }
enum class ExrType { half, single };
/// What a picture can show over the frame: a field, on the fur; or, instead of it, the shape of the model.
enum class Overlay {
  none,
  direction,
  strokes,
  length,
  density,
  wetness,
  mask,
  bald,       // the skin alone, in plain grey
  wire,       // its triangles
  difference  // how much the fields have changed since overlay_from
};

/// What an EXR can hold beside colour. All but beauty and alpha leave out the ground. Beauty, albedo and direct are
/// multiplied by alpha; position, normal, tangent and shadow are means over what covers the pixel.
enum class Aov {
  beauty,    // R, G, B, A: linear light without exposure, tone map and background
  alpha,     // A
  depth,     // Z: distance along the view of the first fur or skin over half opacity, model's unit; infinity for none
  position,  // model's coordinates
  normal,    // of the skin below, unit
  tangent,   // of the fur from root to tip, unit; 0 where the skin is bare
  albedo,    // linear
  direct,    // what lights add, without the ambient part, linear
  shadow,    // unshadowed share of `direct`, [0, 1]; 1 where there is no direct light
  sample_count,  // segments of strands that were blended, mean over the pixel; of traced strands the samples
  strand,  // that covers most of the pixel: its number from 1 on, where on it, and its coat; 0 where skin shows more
  root,    // of that strand, model's coordinates
  cryptomatte,  // how much of a pixel skin, eyes, curves and each coat cover
  // What cryptomatte is drawn as: the shares of three objects each (first_object of renderer/input). Nobody asks for
  // them by name.
  objects_1,
  objects_2,
  objects_3,
  objects_4
};

/// Pictures that an AOV is drawn as.
constexpr int pictures_of(Aov aov) { return aov == Aov::cryptomatte ? 4 : 1; }

/// How strands are traced. A pass adds a sample to each pixel that still needs some.
struct Tracing {
  int passes = 64;  // at most, [1, 65536]
  Transport transport = Transport::transmittance;
  StrandScattering scattering = StrandScattering::look;
  int bounces = 32;         // of a path, [1, 4096]; paths
  int strands = 2'000'000;  // at most, [1, 8000000]; fewer are drawn wider
  double noise = 0;         // estimated mean error of a displayed channel at which it stops, [0, 1]; 0 never
  double seconds = 0;       // after which it stops, [0, 3600]; 0 never
  double shutter = 0;       // seconds that it is open about the frame's time, [0, 10]: blurs fur that moves
  bool filter = true;       // features filter pictures of few passes
  std::uint32_t seed = 1;

  bool operator==(const Tracing&) const = default;
};

/// Which strands are rasterized, and how they are lit.
struct Rasterizing {
  double strands = 1.4;  // drawn on a pixel of skin seen from above; fewer strands are wider, [0.01, 1000]
  int light_of = 4;      // strands that share the light of one, [1, 8]

  bool operator==(const Rasterizing&) const = default;
};

/// How fur is drawn as shells (GPU fur).
struct Layering {
  int count = 16;  // of shells where the view needs most, [1, 1024]
  ShellPolicy policy = ShellPolicy::uniform;
  bool self_shadow = true;      // the one that needs no maps (science.md 4)
  bool shadow_maps = false;     // draw the shadows that lights ask for
  int shadow_resolution = 512;  // texels of a map's side, [1, 4096]
  FragmentOrder order = FragmentOrder::four_pass;

  bool operator==(const Layering&) const = default;
};

/// The settings that a tier stands for, and that a request may also set one by one.
struct Knobs {
  Method method = Method::raster;
  double scale = 1;         // rendered size over asked size, [0.25, 2]; not of method strands
  int eye_steps = 8;        // into the iris: 0 flat, 1 parallax, more march, [0, 64]; not of method shells
  Rasterizing raster = {};  // of method raster
  Tracing trace = {};       // of method strands
  Layering shells = {};     // of method shells

  bool operator==(const Knobs&) const = default;
};

/// The knobs that a tier stands for.
Knobs knobs_of(Tier tier);
/// Returns the quality of a JPEG or WebP of a picture that was drawn with these knobs, [1, 100]: the closer the picture
/// is to the truth, the higher.
int lossy_quality(const Knobs& knobs);

/// Why a traced picture ended; none while it goes on.
enum class TraceEnd { none, passes, noise, seconds };

/// What tracing a picture took, and how noisy it still is.
struct TraceReport {
  int passes = 0;      // 0 for what is not traced
  double samples = 0;  // mean of a pixel
  double noise = 0;    // estimated mean error of a shown channel
  std::size_t strands = 0;
  TraceEnd end = TraceEnd::none;
  double grow_ms = 0;  // growing and indexing strands
  double trace_ms = 0;
  bool operator==(const TraceReport&) const = default;
};

/// Pixels of a frame.
struct Crop {
  int left = 0, top = 0;      // from the left and from the top of the frame
  int width = 1, height = 1;  // [1, 8192]; all of them inside the frame

  bool operator==(const Crop&) const = default;
};

struct FrameRequest {
  int width = 512;   // [1, 8192]
  int height = 512;  // [1, 8192]
  std::optional<Crop> crop =
      {};  // draws these pixels alone, as they are in the whole frame; the picture has their size
  Camera camera;
  Knobs knobs = knobs_of(Tier::interactive);
  // At most one of these, and then no knobs: the server chooses them.
  std::optional<double> budget_ms = {};  // the least error for so much drawing time (FrameEstimate), [1, 600000]
  std::optional<double> max_error = {};  // the least cost with at most this error (FrameEstimate), [1e-6, 1]
  Background background = Background::colour;
  glm::vec3 background_colour{0.56f, 0.58f, 0.61f};  // linear
  double exposure = 0;                               // stops, [-20, 20]
  ToneMap tone_map = ToneMap::filmic;
  std::optional<Look> look;  // in place of the scene's, for this frame
  FrameFormat format = FrameFormat::png;
  int lossy_quality = 0;               // of JPEG and WebP, [0, 100]; 0: as the knobs ask (lossy_quality)
  ExrType exr_type = ExrType::half;    // depth and position are always single
  std::vector<Aov> aovs{Aov::beauty};  // of an EXR: at least one, each once
  std::string colour_space = {};       // of an EXR, as OpenColorIO knows it; "" for linear Rec. 709
  Overlay overlay = Overlay::none;     // not in an EXR
  bool masked = false;                 // only triangles with a corner whose mask is above .5, and what grows on them
  std::string overlay_coat = {};       // whose field an overlay shows; "" for that of the first coat that is seen
  std::optional<std::uint64_t> overlay_from = {};  // revision of this model; with Overlay::difference and only then
  std::optional<Tracing> progressive =
      {};  // rasterized strands now, traced ones while somebody waits for them (`after_pass`)
  std::optional<std::uint64_t> revision = {};  // of this model: the scene as it was then; without progressive
  std::optional<double> time =
      {};                   // seconds, [-1e6, 1e6]: the moment of the wind that is drawn; the scene's time unless given
  double max_seconds = 60;  // refused where drawing is expected to take longer, [1, 86400]
  std::string view;         // name of the viewer; of several frames asked for one view only the newest is drawn

  bool plans() const { return budget_ms || max_error; }
  /// Share of the frame's pixels that are drawn, (0, 1].
  double drawn_share() const {
    const double all = static_cast<double>(width) * height;
    return crop ? static_cast<double>(crop->width) * crop->height / all : 1;
  }
};

}  // namespace pelage
