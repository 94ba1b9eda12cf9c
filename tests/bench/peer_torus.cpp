#include "tests/bench/peer_torus.h"

#include <fstream>
#include <ostream>
#include <span>

#include "renderer/strands/strand_shading.h"
#include "server/frames/fur_view.h"

namespace pelage::bench {

namespace {

constexpr std::size_t strands_each = 6000;

template <class T>
void put(std::ostream& file, std::span<const T> values) {
  const std::span<const std::byte> bytes = std::as_bytes(values);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

struct Listed {
  std::size_t strands = 0;
  int points = 0;  // per strand
};

Listed write_strands(const FurModel& model, const FurFields& fields, const FurFrame& frame, std::ostream& file) {
  const Grower grower(model, fields, {.coat = frame.coat()});
  const StrandShading shading(frame);
  Listed listed;
  std::vector<float> numbers;
  for (const StrandChunk& chunk : make_chunks(model, frame.coat(), strands_each)) {
    const StrandSet set = grower.grow(chunk);
    listed.strands += set.count(), listed.points = set.segments + 1;
    numbers.clear();
    for (std::size_t i = 0; i < set.points.size(); ++i) {
      const StrandPoint& point = set.points[i];
      const glm::vec3 sigma_a = shading.absorption(unpack_colour(set.colours[i]));
      numbers.insert(numbers.end(), {point.position.x, point.position.y, point.position.z, point.radius, sigma_a.r,
                                     sigma_a.g, sigma_a.b});
    }
    put(file, std::span<const float>(numbers));
  }
  return listed;
}

std::ostream& operator<<(std::ostream& out, glm::vec3 v) {
  return out << '[' << v.x << ", " << v.y << ", " << v.z << ']';
}

void write_settings(const FurFrame& frame, std::ostream& out) {
  const FurCamera& camera = frame.camera;
  const FurLight& light = frame.lights.front();
  const FibreOptics& fibre = frame.look.fibre;
  const auto ambient = static_cast<float>(frame.look.ambient);
  out.precision(9);
  out << "  \"width\": " << frame.width << ", \"height\": " << frame.height
      << ", \"bounces\": " << frame.knobs.trace.bounces << ",\n  \"camera\": {\"position\": " << camera.position
      << ", \"right\": " << camera.right << ", \"up\": " << camera.up << ", \"forward\": " << camera.forward
      << ", \"tan_half_fov\": " << camera.tan_half_fov << "},\n  \"light\": {\"direction\": " << light.direction
      << ", \"half_angle\": " << light.angle << ", \"radiance\": " << light.radiance
      << "},\n  \"environment\": " << ambient * frame.environment.sky
      << ",\n  \"skin\": " << frame.coat().ramp.front().colour
      << ",\n  \"fibre\": {\"longitudinal_roughness\": " << fibre.longitudinal_roughness
      << ", \"azimuthal_roughness\": " << fibre.azimuthal_roughness << ", \"cuticle_tilt\": " << fibre.cuticle_tilt
      << ", \"refractive_index\": " << fibre.refractive_index << "}";
}

}  // namespace

testing::FurredModel peer_torus() {
  testing::FurredModel model = testing::furred({Builtin::torus, 8000}, {.length = 0.06, .inclination = 0.55});
  Coat& coat = model.settings.coats[0].coat;
  coat.count = 600, coat.width_root = 0.003, coat.width_tip = 0.001, coat.colour_spread = 0;
  coat.clump = 0.5, coat.clump_size = 0.03, coat.root_share = 0.2;
  coat.ramp = {{0, {.20f, .10f, .05f}}, {1, {.52f, .33f, .18f}}};
  model.settings.look.colour_source = ColourSource::coat;
  model.settings.look.skin = coat.ramp.front().colour;
  model.settings.lights = {
      {.kind = LightKind::directional, .direction = {-0.5, -0.8, -0.6}, .intensity = 2.5, .angle_degrees = 5}};
  return model;
}

FrameRequest peer_request(int size, int passes, std::uint32_t seed) {
  FrameRequest request = testing::small_frame(AutoView::three_quarter, size);
  request.knobs = knobs_of(Tier::reference);
  Tracing& trace = request.knobs.trace;
  trace.transport = Transport::paths, trace.scattering = StrandScattering::energy_conserving;
  trace.passes = passes, trace.seed = seed, trace.filter = false;
  request.tone_map = ToneMap::filmic, request.background = Background::studio;
  return request;
}

std::size_t write_peer_scene(const testing::FurredModel& model, const FurFrame& frame, const std::string& folder) {
  const SceneView view = model.view();
  const ModelArrays arrays = make_arrays(view);
  std::ofstream strands(folder + "/strands.bin", std::ios::binary), skin(folder + "/skin.bin", std::ios::binary);
  const Listed listed =
      write_strands(make_model(view, arrays), make_fields(view, frame.skin, {}).front(), frame, strands);
  const Mesh& mesh = model.model.surface.mesh();
  put(skin, std::span<const glm::vec3>(mesh.positions));
  put(skin, std::span<const glm::uvec3>(mesh.triangles));
  std::ofstream text(folder + "/scene.json");
  text << "{\n  \"strands\": " << listed.strands << ", \"points\": " << listed.points
       << ", \"vertices\": " << mesh.positions.size() << ", \"triangles\": " << mesh.triangles.size() << ",\n";
  write_settings(frame, text);
  text << "\n}\n";
  return strands.flush() && skin.flush() && text.flush() ? listed.strands : 0;
}

}  // namespace pelage::bench
