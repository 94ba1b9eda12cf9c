#include "renderer/strands/world.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <new>
#include <optional>
#include <vector>

#include "renderer/strands/strand_part.h"

namespace pelage {

namespace {

/// Settings of the Embree device. max_isa=avx2 gives the same bits on CPUs with wider vectors. The number of threads is
/// not set, because that would limit oneTBB in the whole process; scenes are built on the caller's thread instead.
constexpr const char* device_settings = "max_isa=avx2,set_affinity=0,hugepages=0";
constexpr double strands_of_part = 6000;
constexpr float max_coordinate = 1e18f;  // sizes; Embree's own limit is 1.8e18
constexpr float black_depth = 5.5f;      // optical depth beyond which transmittance counts as 0

bool count_memory(void* budget, ssize_t bytes, bool) { return static_cast<MemoryBudget*>(budget)->take(bytes); }

/// A query with the data that its filter function needs. The context comes first, because the filter casts its address.
struct Query {
  RTCIntersectContext context{};
  const Ray* ray = nullptr;
  float depth = 0;        // optical depth of a black strand
  glm::vec3 gathered{0};  // sum of StrandPart::relative_depth over the strands crossed
  bool through = true;    // false once the ray hit something opaque
};

Query& query_of(const RTCFilterFunctionNArguments* arguments) { return *reinterpret_cast<Query*>(arguments->context); }

/// Ignores hits on the strand that the ray starts on.
void leave_own(const RTCFilterFunctionNArguments* arguments) {
  const auto* part = static_cast<const StrandPart*>(arguments->geometryUserPtr);
  if (!part) return;
  const std::uint32_t segment = RTCHitN_primID(arguments->hit, 1, 0);
  if (part->strand_of(segment) == query_of(arguments).ray->ignored) arguments->valid[0] = 0;
}

/// Sums StrandPart::relative_depth; ends the ray at an opaque hit or once too little light is left.
void gather_depth(const RTCFilterFunctionNArguments* arguments) {
  Query& query = query_of(arguments);
  const auto* part = static_cast<const StrandPart*>(arguments->geometryUserPtr);
  if (!part) {
    query.through = false;
    return;
  }
  const std::uint32_t segment = RTCHitN_primID(arguments->hit, 1, 0);
  if (part->strand_of(segment) != query.ray->ignored) {
    query.gathered += part->relative_depth(segment, RTCHitN_u(arguments->hit, 1, 0));
    const float min = std::min({query.gathered.r, query.gathered.g, query.gathered.b});
    if (min * query.depth > black_depth) {
      query.through = false;
      return;
    }
  }
  arguments->valid[0] = 0;
}

/// Returns true if Embree accepts the ray: numbers beyond its range would end the process.
bool can_be_cast(const Ray& ray) {
  const glm::vec3 furthest = glm::max(glm::abs(ray.origin), glm::abs(ray.direction));
  const bool in_range =
      furthest.x <= max_coordinate && furthest.y <= max_coordinate && furthest.z <= max_coordinate;  // false for NaN
  const float square = glm::dot(ray.direction, ray.direction);
  return in_range && square > 0.5f && square < 2 && ray.t_max >= 0;
}

RTCRay ray_of(const Ray& ray) {
  return {ray.origin.x,
          ray.origin.y,
          ray.origin.z,
          0,
          ray.direction.x,
          ray.direction.y,
          ray.direction.z,
          ray.time,
          ray.t_max,
          ~0u,
          0,
          0};
}

EmbreeGeometry make_skin(RTCDevice device, const FurModel& model, std::span<const glm::uvec3> triangles) {
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  auto* positions = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), model.positions.size()));
  auto* corners = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), triangles.size()));
  if (!positions || !corners) return nullptr;
  std::copy(model.positions.begin(), model.positions.end(), positions);
  std::copy(triangles.begin(), triangles.end(), corners);
  rtcCommitGeometry(geometry.get());
  return geometry;
}

EmbreeGeometry make_eyeballs(RTCDevice device, std::span<const FurEye> eyes) {
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT));
  auto* balls = static_cast<glm::vec4*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                                                RTC_FORMAT_FLOAT4, sizeof(glm::vec4), eyes.size()));
  if (!balls) return nullptr;
  for (const FurEye& eye : eyes) *balls++ = glm::vec4(eye.position, eye.radius);
  rtcCommitGeometry(geometry.get());
  return geometry;
}

EmbreeGeometry make_instance(RTCDevice device, RTCScene of) {
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE));
  const float unmoved[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  rtcSetGeometryInstancedScene(geometry.get(), of);
  rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, unmoved);
  rtcCommitGeometry(geometry.get());
  return geometry;
}

Status no_memory() {
  return failure(Code::too_large, "The strands need more memory than tracing may take.", "/quality/trace/strands",
                 "fewer strands");
}

}  // namespace

struct World::Impl {
  explicit Impl(std::size_t memory) : budget(memory), device(rtcNewDevice(device_settings)) {
    if (!device) throw std::bad_alloc();
    rtcSetDeviceMemoryMonitorFunction(device.get(), count_memory, &budget);
  }

  /// The settings of a coat for which the surface was divided into chunks.
  struct Division {
    double count = 0, tile = 0, share = 0;
    bool operator==(const Division&) const = default;
  };

  bool set_model(const FurModel& next, EachCoat<GrowRecipe> recipes);
  bool set_curves(const FurFrame& frame);
  bool grow(const Grower& grower, std::size_t part, std::atomic<std::size_t>& grown);
  bool join(const FurFrame& frame);
  glm::vec3 root_colour(std::size_t chunk) const;
  std::size_t object_of(std::size_t part) const;  // `part`: its number

  MemoryBudget budget;
  EmbreeDevice device;
  std::uint64_t model = 0;
  std::vector<Division> divided;                       // for each coat; empty while there are no chunks
  std::vector<StrandChunk> chunks;                     // shared by all coats
  std::vector<std::unique_ptr<StrandPart>> parts;      // for each coat and chunk; the last one has the curves
  std::vector<std::optional<std::uint64_t>> grown_of;  // for each coat and chunk, the fingerprint of the strands there
  std::vector<FurCurves> curves;
  std::vector<std::uint32_t> chunk_of_triangle;  // for each triangle of `skin`
  EmbreeGeometry skin;
  EmbreeScene all;
};

std::size_t World::Impl::object_of(std::size_t part) const {
  return part + 1 == parts.size() ? curves_object : first_coat_object + part / chunks.size();
}

/// Divides the surface into chunks and builds the skin: each triangle once, with a chunk that has it.
/// Returns false if memory does not suffice.
bool World::Impl::set_model(const FurModel& next, EachCoat<GrowRecipe> recipes) {
  std::vector<Division> wanted;
  std::vector<Coat> coats;
  for (const GrowRecipe& recipe : recipes) {
    wanted.push_back({static_cast<double>(recipe.coat.count), recipe.coat.tile, recipe.share});
    coats.push_back(recipe.coat);
  }
  if (next.id == model && wanted == divided) return true;
  parts.clear(), curves.clear(), skin.reset();
  divided.clear();  // stays empty unless all of the following succeeds
  chunks = make_chunks(next, coats, strands_of_part / recipes.front().share);
  const std::size_t of_coats = coats.size() * chunks.size();
  for (std::uint32_t i = 0; i <= of_coats; ++i) parts.push_back(std::make_unique<StrandPart>(i, budget));
  grown_of.assign(of_coats, {});
  std::vector<std::pair<glm::uvec3, std::uint32_t>> faces;
  for (std::uint32_t c = 0; c < chunks.size(); ++c) {
    for (const std::uint32_t triangle : chunks[c]) faces.emplace_back(next.triangles[triangle], c);
  }
  const auto key = [](const auto& face) { return std::array{face.first.x, face.first.y, face.first.z}; };
  std::sort(faces.begin(), faces.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  std::vector<glm::uvec3> triangles;
  chunk_of_triangle.clear();
  for (const auto& face : faces) {
    if (!triangles.empty() && triangles.back() == face.first) continue;
    triangles.push_back(face.first), chunk_of_triangle.push_back(face.second);
  }
  if (!triangles.empty()) {
    skin = make_skin(device.get(), next, triangles);
    if (!skin) return false;
  }
  model = next.id, divided = std::move(wanted);
  return true;
}

bool World::Impl::set_curves(const FurFrame& frame) {
  if (curves == frame.curves) return true;
  curves.clear();
  if (!parts.back()->set(device.get(), grow_curves(frame.curves))) return false;
  curves = frame.curves;
  return true;
}

bool World::Impl::grow(const Grower& grower, std::size_t part, std::atomic<std::size_t>& grown) {
  const StrandChunk& chunk = chunks[part % chunks.size()];
  const std::uint64_t fingerprint = grower.fingerprint(chunk);
  if (grown_of[part] == fingerprint) return true;
  grown_of[part].reset();
  parts[part]->drop();
  if (!parts[part]->set(device.get(), grower.grow(chunk, budget.left()))) return false;
  grown_of[part] = fingerprint;
  grown += parts[part]->strands().count();
  return true;
}

/// Returns the mean root colour over the strands of all coats.
glm::vec3 World::Impl::root_colour(std::size_t chunk) const {
  if (divided.size() == 1) return parts[chunk]->root_colour();
  glm::vec3 sum(0);
  float count = 0;
  for (std::size_t part = chunk; part < grown_of.size(); part += chunks.size()) {
    const auto strands = static_cast<float>(parts[part]->strands().count());
    sum += strands * parts[part]->root_colour(), count += strands;
  }
  return count > 0 ? sum / count : glm::vec3(0);
}

/// Builds the Embree scene of all parts, the skin and the eyeballs. Returns false if memory does not suffice.
bool World::Impl::join(const FurFrame& frame) {
  all.reset(rtcNewScene(device.get()));
  rtcSetSceneFlags(all.get(), RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  if (skin) rtcAttachGeometryByID(all.get(), skin.get(), static_cast<unsigned>(parts.size()));
  if (!frame.eyes.empty()) {
    const EmbreeGeometry balls = make_eyeballs(device.get(), frame.eyes);
    if (!balls) return false;
    rtcAttachGeometryByID(all.get(), balls.get(), static_cast<unsigned>(parts.size() + 1));
  }
  for (const auto& part : parts) {
    if (part->index()) {
      const EmbreeGeometry instance = make_instance(device.get(), part->index());
      rtcAttachGeometryByID(all.get(), instance.get(), part->number());
    }
  }
  run_on_this_thread([&] { rtcCommitScene(all.get()); });
  return rtcGetDeviceError(device.get()) == RTC_ERROR_NONE;
}

World::World(std::size_t memory) : impl_(std::make_unique<Impl>(memory)) {}
World::~World() = default;

void World::set_memory(std::size_t memory) { impl_->budget.set_limit(memory); }

Result<World::Change> World::update(const FurModel& model, EachCoat<FurFields> fields, const FurFrame& frame,
                                    EachCoat<GrowRecipe> recipes, const WorkThreads& workers,
                                    const std::function<bool()>& go_on) {
  Impl& world = *impl_;
  world.all.reset();                      // it references parts that are about to be dropped
  rtcGetDeviceError(world.device.get());  // clears the error of an earlier scene that did not fit into memory
  if (!world.set_model(model, recipes) || !world.set_curves(frame)) return no_memory();
  std::vector<std::unique_ptr<const Grower>> growers;
  for (std::size_t c = 0; c < recipes.size(); ++c)
    growers.push_back(std::make_unique<const Grower>(model, fields[c], recipes[c]));
  std::atomic<std::size_t> grown{0};
  std::atomic<bool> wanted{true};
  const bool completed = for_each_until_false(workers, world.grown_of.size(), [&](std::size_t part) {
    if (!go_on()) wanted = false;
    return wanted && world.grow(*growers[part / world.chunks.size()], part, grown);
  });
  if (!wanted) return cancelled_status();
  if (!completed || !world.join(frame)) return no_memory();
  Change change{.grown = grown, .strands = 0};
  for (const auto& part : world.parts) change.strands += part->strands().count();
  return change;
}

std::size_t World::bytes() const { return impl_->budget.used(); }

Hit World::intersect(const Ray& ray) const {
  if (!can_be_cast(ray)) return {};
  const Impl& world = *impl_;
  Query query;
  rtcInitIntersectContext(&query.context);
  query.ray = &ray;
  if (ray.ignored != StrandId{}) query.context.filter = leave_own;
  RTCRayHit found{ray_of(ray), {}};
  found.hit.geomID = found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(world.all.get(), &query.context, &found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  if (found.hit.instID[0] != RTC_INVALID_GEOMETRY_ID) {
    Hit hit = world.parts[found.hit.instID[0]]->hit(ray, found.ray.tfar, found.hit.primID, found.hit.u);
    hit.object = world.object_of(found.hit.instID[0]);
    return hit;
  }
  Hit hit{.kind = HitKind::skin, .distance = found.ray.tfar};
  const glm::vec3 across(found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z);
  hit.normal = across * (1 / std::max(glm::length(across), 1e-30f));
  if (glm::dot(hit.normal, ray.direction) > 0) hit.normal = -hit.normal;
  const bool eye = found.hit.geomID == world.parts.size() + 1;
  if (!eye) hit.colour = world.root_colour(world.chunk_of_triangle[found.hit.primID]);
  return hit;
}

bool World::occluded(const Ray& ray) const {
  if (!can_be_cast(ray)) return false;
  Query query;
  rtcInitIntersectContext(&query.context);
  query.ray = &ray;
  if (ray.ignored != StrandId{}) query.context.filter = leave_own;
  RTCRay towards = ray_of(ray);
  rtcOccluded1(impl_->all.get(), &query.context, &towards);
  return towards.tfar < 0;
}

glm::vec3 World::transmittance(const Ray& ray, float depth) const {
  if (!can_be_cast(ray)) return glm::vec3(1);
  Query query;
  rtcInitIntersectContext(&query.context);
  query.ray = &ray, query.depth = depth;
  query.context.filter = gather_depth;
  RTCRay towards = ray_of(ray);
  rtcOccluded1(impl_->all.get(), &query.context, &towards);
  return query.through ? glm::exp(-depth * query.gathered) : glm::vec3(0);
}

}  // namespace pelage
