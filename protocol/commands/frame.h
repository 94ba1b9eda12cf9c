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

/// Cameras that the server places itself. `front` looks from +Z, `left` at the animal's left side, from +X; each frames
/// the bare model, never the fur.
enum class AutoView { none, front, back, left, right, top, three_quarter };

/// A pinhole camera in the model's own coordinates (right-handed, Y up). If `automatic` is not none, the other members
/// are ignored.
struct Camera {
  AutoView automatic = AutoView::three_quarter;
  glm::dvec3 position{0, 0, 1};
  glm::dvec3 target{0};     // differs from position
  glm::dvec3 up{0, 1, 0};   // not parallel to the view direction
  double fov_degrees = 35;  // vertical, [1, 150]
};

/// The camera and size of the frame that a pixel sample or a pick refers to.
struct View {
  Camera camera;
  int width = 512;   // [1, 8192]
  int height = 512;  // [1, 8192]
};

// Settings of a frame request: quality, format and content.

enum class Tier { draft, interactive, detailed, reference };
/// raster: rasterized strands. strands: all strands, ray traced. shells: the shells of GPU fur, drawn by a GL.
enum class Method { raster, strands, shells };
/// How light travels through traced fur. transmittance: attenuated by the colour and number of the strands that a ray
/// to the light crosses. paths: path tracing, with scattering from strand to strand.
enum class Transport { transmittance, paths };
/// Scattering model of traced strands: the look's, as for shells, or energy_conserving whatever the look says. Paths
/// always scatter by energy_conserving: no other model conserves energy.
enum class StrandScattering { look, energy_conserving };
enum class ShellPolicy { uniform, adaptive };  // adaptive: fewer shells where the view needs fewer (fur modelling 2)
/// Order in which shell fragments are blended. four_pass: skin, depth of dense fur, back-facing fur, front-facing fur
/// (after Scheuermann 2004). sorted: by depth in each pixel, slow and exact.
enum class FragmentOrder { four_pass, sorted };
enum class ToneMap { none, filmic };
enum class Background { colour, transparent, studio };  // studio: a soft gradient with darker corners
/// `npy` is a NumPy array of the pixels of `png`, bytes [height, width, 4]; `npy_linear` is one of the contents of an
/// EXR of floats, [height, width, channels] in the order of its AOVs.
enum class FrameFormat { png, png16, jpeg, webp, exr, npy, npy_linear };

/// Returns whether the format holds linear light and AOVs, without exposure, tone map and background.
constexpr bool is_linear(FrameFormat format) { return format == FrameFormat::exr || format == FrameFormat::npy_linear; }
/// Returns whether the compression is lossy.
constexpr bool is_lossy(FrameFormat format) { return format == FrameFormat::jpeg || format == FrameFormat::webp; }
enum class ExrType { half, single };
/// What a picture can show besides the frame: a field drawn on the fur or, in place of the frame, the shape of the
/// model.
enum class Overlay {
  none,
  direction,
  strokes,
  length,
  density,
  wetness,
  mask,
  bald,       // the skin alone, in plain grey
  wire,       // the same with the edges of its triangles
  difference  // how much the fields have changed since overlay_from
};

/// AOVs that an EXR can hold. All but beauty and alpha leave out the ground. Beauty, albedo and direct are multiplied
/// by alpha; position, normal, tangent and shadow are means over what covers the pixel.
enum class Aov {
  beauty,    // R, G, B, A: linear light without exposure, tone map and background
  alpha,     // A
  depth,     // Z: distance along the view at which opacity exceeds one half, model's unit; infinity if it never does
  position,  // model coordinates
  normal,    // normal of the skin below, unit
  tangent,   // tangent of the fur from root to tip, unit; 0 where the skin is bare
  albedo,    // linear
  direct,    // light from the lights, without ambient light, linear
  shadow,    // unshadowed share of `direct`, [0, 1]; 1 where there is no direct light
  sample_count,  // blended strand segments, mean over the pixel; samples if strands are traced
  strand,  // strand that covers most of the pixel: number from 1, position along it, coat; 0 where skin covers more
  root,    // root of that strand, model coordinates
  cryptomatte,  // coverage of the pixel by skin, eyes, curves and each coat
  // The pictures that cryptomatte is drawn as, each with the coverage by three objects (first_object in
  // renderer/input). Requests cannot name them.
  objects_1,
  objects_2,
  objects_3,
  objects_4
};

/// Returns the number of pictures that an AOV is drawn as.
constexpr int pictures_of(Aov aov) { return aov == Aov::cryptomatte ? 4 : 1; }

/// How strands are traced. A pass adds a sample to each pixel that still needs some.
struct Tracing {
  int passes = 64;  // largest number of passes, [1, 65536]
  Transport transport = Transport::transmittance;
  StrandScattering scattering = StrandScattering::look;
  int bounces = 32;         // largest number of bounces of a path, [1, 4096]; with Transport::paths
  int strands = 2'000'000;  // largest number of strands, [1, 8000000]; fewer strands are drawn wider
  double noise = 0;         // stops at this estimated mean error of a displayed channel, [0, 1]; 0 never
  double seconds = 0;       // stops after this time, [0, 3600]; 0 never
  double shutter = 0;       // exposure time centred on the frame's time, seconds, [0, 10]; blurs moving fur
  bool filter = true;       // filters pictures of few passes, guided by direction, depth and colour
  std::uint32_t seed = 1;

  bool operator==(const Tracing&) const = default;
};

/// Which strands are rasterized, and how they are lit.
struct Rasterizing {
  double strands = 1.4;  // strands per pixel of skin seen from above, [0.01, 1000]; fewer are drawn wider
  int light_of = 4;      // neighbouring strands that share the lighting of one of them, [1, 8]

  bool operator==(const Rasterizing&) const = default;
};

/// How fur is drawn as shells (GPU fur).
struct Layering {
  int count = 16;  // number of shells where the view needs the most, [1, 1024]
  ShellPolicy policy = ShellPolicy::uniform;
  bool self_shadow = true;      // estimated self-shadowing, which needs no maps (science.md 4)
  bool shadow_maps = false;     // draws the shadow maps that lights ask for
  int shadow_resolution = 512;  // texels of a map's side, [1, 4096]
  FragmentOrder order = FragmentOrder::four_pass;

  bool operator==(const Layering&) const = default;
};

/// The quality settings that a tier stands for. A request may also set them one by one.
struct Knobs {
  Method method = Method::raster;
  double scale = 1;         // rendered size over requested size, [0.25, 2]; not for method strands
  int eye_steps = 8;        // into the iris: 0 flat, 1 parallax, more ray march, [0, 64]; not for method shells
  Rasterizing raster = {};  // for method raster
  Tracing trace = {};       // for method strands
  Layering shells = {};     // for method shells

  bool operator==(const Knobs&) const = default;
};

/// Returns the knobs that a tier stands for.
Knobs knobs_of(Tier tier);
/// Returns the default quality of a JPEG or WebP drawn with these knobs, [1, 100]; the better the picture, the higher.
int lossy_quality(const Knobs& knobs);

/// Why tracing a picture ended; none while it goes on.
enum class TraceEnd { none, passes, noise, seconds };

/// The cost of tracing a picture so far, and its remaining noise.
struct TraceReport {
  int passes = 0;      // 0 if the picture is not traced
  double samples = 0;  // mean per pixel
  double noise = 0;    // estimated mean error of a displayed channel
  std::size_t strands = 0;
  TraceEnd end = TraceEnd::none;
  double grow_ms = 0;  // growing and indexing strands
  double trace_ms = 0;
  bool operator==(const TraceReport&) const = default;
};

/// A rectangle of pixels of a frame.
struct Crop {
  int left = 0, top = 0;      // distance from the left and top edges of the frame
  int width = 1, height = 1;  // [1, 8192]; the rectangle lies inside the frame

  bool operator==(const Crop&) const = default;
};

struct FrameRequest {
  int width = 512;                // [1, 8192]
  int height = 512;               // [1, 8192]
  std::optional<Crop> crop = {};  // draws only these pixels, with the values that they have in the whole frame
  Camera camera;
  Knobs knobs = knobs_of(Tier::interactive);
  // At most one of these is set. The server then chooses the knobs.
  std::optional<double> budget_ms = {};  // minimizes the error within this drawing time (FrameEstimate), [1, 600000]
  std::optional<double> max_error = {};  // minimizes the cost within this error (FrameEstimate), [1e-6, 1]
  Background background = Background::colour;
  glm::vec3 background_colour{0.56f, 0.58f, 0.61f};  // linear
  double exposure = 0;                               // stops, [-20, 20]
  ToneMap tone_map = ToneMap::filmic;
  std::optional<Look> look;  // replaces the scene's look in this frame
  FrameFormat format = FrameFormat::png;
  int lossy_quality = 0;               // of JPEG and WebP, [0, 100]; 0: the default of the knobs, lossy_quality()
  ExrType exr_type = ExrType::half;    // depth, position, strand, root and cryptomatte are always single
  std::vector<Aov> aovs{Aov::beauty};  // for linear formats: at least one, each once
  std::string colour_space = {};       // for linear formats: an OpenColorIO name; "" for linear Rec. 709
  Overlay overlay = Overlay::none;     // none for linear formats
  bool masked = false;                 // draws only triangles with a corner whose mask is above .5, and their fur
  std::string overlay_coat = {};       // coat whose field the overlay shows; "" for the first that is not muted
  std::optional<std::uint64_t> overlay_from = {};  // revision that Overlay::difference compares with; for it only
  std::optional<Tracing> progressive = {};         // answers with rasterized strands, then traces while a client waits
  std::optional<std::uint64_t> revision = {};      // draws the scene as of this revision; not with progressive
  std::optional<double> time = {};                 // time of the wind, seconds, [-1e6, 1e6]; absent: the scene's time
  double max_seconds = 60;  // refuses the frame if drawing is expected to take longer, [1, 86400]
  std::string view;         // name of the viewer; of several frames asked for one view only the newest is drawn

  bool plans() const { return budget_ms || max_error; }
  /// Share of the frame's pixels that are drawn, (0, 1].
  double drawn_share() const {
    const double all = static_cast<double>(width) * height;
    return crop ? static_cast<double>(crop->width) * crop->height / all : 1;
  }
};

}  // namespace pelage
