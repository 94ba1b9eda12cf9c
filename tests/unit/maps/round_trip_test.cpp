// From fields to pictures and back, with this program's own models and with rotated and mirrored islands.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/random.h"
#include "server/builtin/builtin.h"
#include "server/groom/evaluate.h"
#include "server/maps/draw_map.h"
#include "server/patches/patches.h"
#include "server/surface/prepare.h"

namespace pelage {
namespace {

Surface surface_of(const RawModel& raw) { return Surface(prepare(raw).value()); }

MapRequest asked(Field field, int size, MapFormat format = MapFormat::png16,
                 MapEncoding encoding = MapEncoding::automatic) {
  MapRequest request;
  request.field = field, request.size = size, request.format = format, request.encoding = encoding;
  return request;
}

/// Fur in which every field is different at every vertex.
FieldSet random_fields(std::size_t vertices) {
  Random random(5);
  FieldSet fields(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    for (std::size_t f = 0; f < field_count; ++f) {
      glm::vec4 value(0);
      for (int k = 0; k < shape_of(field_at(f)).channels; ++k)
        value[k] = stored_value(field_at(f), random.uniform(0.1, 0.9));
      if (field_at(f) == Field::direction)
        value = glm::vec4(stored_direction({random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7)}), 0, 0);
      if (field_at(f) == Field::length) value.x *= 0.1f;
      if (field_at(f) == Field::mask) value.x = 1;
      fields.set(field_at(f), v, value);
    }
  }
  return fields;
}

/// The map as another program would read it from the file.
MapPicture file_of(const DrawnMap& map, int bits) {
  MapPicture picture{map.image.size, map.image.size, bits, {}, {}};
  for (std::size_t i = 0; i < map.image.covered.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      const int from = map.layout.channels == 1 ? 0 : k;
      const bool there = from < map.layout.channels;
      const double max = bits == 8 ? 255 : bits == 16 ? 65535 : 1;
      const double number =
          there ? encode_channel(map.layout.kinds[static_cast<std::size_t>(from)], map.image.at(i)[from], bits) : 0;
      picture.rgba.push_back(static_cast<float>(number / max));
    }
  }
  return picture;
}

MapFormat format_of(int bits) { return bits == 8 ? MapFormat::png : bits == 16 ? MapFormat::png16 : MapFormat::exr; }

Evaluation read_back(const DrawnMap& map, int bits, const Surface& surface, const FieldSet& fields,
                     double strength = 1) {
  const MapPicture picture = file_of(map, bits);
  const ApplyMap command{"", map.answer.field, map.answer.encoding, map.answer.scale, map.answer.units, strength};
  ToolExtras extras;
  extras.picture = &picture;
  return evaluate(command, surface, fields, extras);
}

/// The largest change of any field after a map was written and read back on the same fur.
double worst_change(const Surface& surface, const FieldSet& fields, MapRequest request, int bits) {
  request.format = format_of(bits);
  const Evaluation read = read_back(draw_map(surface.mesh(), fields, request), bits, surface, fields);
  double worst = 0;
  for (const FieldChange& change : measure(read.delta, fields)) worst = std::max(worst, change.max_change);
  return worst;
}

class MapRoundTrip : public ::testing::Test {
 protected:
  MapRoundTrip()
      : surface_(surface_of(make_builtin({Builtin::torus, 800}))),
        fields_(random_fields(surface_.mesh().positions.size())) {}

  Surface surface_;
  FieldSet fields_;
};

TEST_F(MapRoundTrip, EveryFieldComesBack) {
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    const MapRequest request = asked(field, 512);
    EXPECT_LT(worst_change(surface_, fields_, request, 32), 1e-5) << shape_of(field).name;
    const bool signed_unit = field == Field::direction, colour = shape_of(field).channels == 4;
    const double scale = field == Field::length ? 0.09 : 1;
    // A direction has two components. A colour's curve and the division by its coverage (at least .1) enlarge a step.
    const double steps = signed_unit ? 2 * std::sqrt(2.0) : colour ? 24 : 1;
    EXPECT_LT(worst_change(surface_, fields_, request, 16), steps * scale / 65535) << shape_of(field).name;
    EXPECT_LT(worst_change(surface_, fields_, request, 8), steps * scale / 255) << shape_of(field).name;
  }
}

/// A list of all vertices, as a script would send it back.
MapPicture sent_back(const VertexList& list) {
  MapPicture picture{1, static_cast<int>(list.values.size() / list.channels), 32, {}, {}};
  for (std::size_t i = 0; i < list.values.size(); i += list.channels) {
    for (std::size_t k = 0; k < 4; ++k) {
      const bool there = k < list.channels;
      picture.rgba.push_back(there ? list.values[i + k] : list.channels == 1 ? list.values[i] : 1.0f);
    }
  }
  return picture;
}

TEST_F(MapRoundTrip, ListsOfVerticesAreExactAndNeedNoTexture) {
  const Surface ball = surface_of(make_builtin({Builtin::sphere, 500}));
  const FieldSet fields = random_fields(ball.mesh().positions.size());
  const FieldSet rest(ball.mesh().positions.size());
  for (std::size_t f = 0; f < field_count; ++f) {
    MapRequest request = asked(field_at(f), 1, MapFormat::npy, MapEncoding::vertices);
    request.units = Units::world;
    const VertexList list = list_vertices(ball.mesh(), fields, request);
    const MapPicture picture = sent_back(list);
    ToolExtras extras;
    extras.picture = &picture;
    const ApplyMap command{"", field_at(f), MapEncoding::vertices, list.answer.scale, request.units};
    FieldSet read = rest;
    read.apply(evaluate(command, ball, rest, extras).delta);
    for (std::uint32_t v = 0; v < fields.size(); ++v)
      EXPECT_LT(glm::distance(read.value(field_at(f), v), fields.value(field_at(f), v)), 2e-6f)
          << shape_of(field_at(f)).name;
  }
}

TEST_F(MapRoundTrip, ListsOfDirectionsAreVectorsAlongTheSurface) {
  const VertexList list =
      list_vertices(surface_.mesh(), fields_, asked(Field::direction, 1, MapFormat::npy, MapEncoding::vertices));
  ASSERT_EQ(list.values.size(), 3 * fields_.size());
  for (std::uint32_t v = 0; v < fields_.size(); ++v) {
    const glm::vec3 along(list.values[3 * v], list.values[3 * v + 1], list.values[3 * v + 2]);
    EXPECT_NEAR(glm::dot(along, surface_.mesh().normals[v]), 0, 1e-6);
    EXPECT_NEAR(glm::length(along), glm::length(glm::vec2(fields_.value(Field::direction, v))), 1e-6);
  }
}

TEST_F(MapRoundTrip, FastFurAndVectorMapsKeepDirections) {
  MapRequest request = asked(Field::direction, 512, MapFormat::png16, MapEncoding::fast_fur);
  EXPECT_LT(worst_change(surface_, fields_, request, 32), 1e-5);
  EXPECT_LT(worst_change(surface_, fields_, request, 16), 3.0 / 65535);
  request.encoding = MapEncoding::vector;
  EXPECT_LT(worst_change(surface_, fields_, request, 32), 2e-5) << "a root undoes what a square rounded";
}

TEST_F(MapRoundTrip, LengthsComeBackInAnyScaleAndUnit) {
  MapRequest request = asked(Field::length, 64);
  const DrawnMap own = draw_map(surface_.mesh(), fields_, request);
  EXPECT_NEAR(own.answer.scale, 0.09, 0.001) << "the longest fur";
  request.units = Units::world, request.scale = 0.5;
  const DrawnMap world = draw_map(surface_.mesh(), fields_, request);
  const double size = surface_.mesh().size;
  EXPECT_NEAR(world.image.values[0] * 0.5 / size, own.image.values[0] * own.answer.scale, 1e-6);
  for (const FieldChange& change : measure(read_back(world, 32, surface_, fields_).delta, fields_))
    EXPECT_LT(change.max_change, 0.02);
}

TEST_F(MapRoundTrip, UprightFurStaysExactlyUpright) {
  FieldSet upright(fields_.size());
  const MapRequest request = asked(Field::direction, 128);
  for (const int bits : {8, 16, 32}) EXPECT_EQ(worst_change(surface_, upright, request, bits), 0) << bits;
  EXPECT_EQ(encode_channel(ChannelKind::signed_unit, 0, 8), 128);
  EXPECT_EQ(encode_channel(ChannelKind::signed_unit, 0, 16), 32768);
}

TEST_F(MapRoundTrip, MaskAndStrengthHold) {
  const MapRequest request = asked(Field::density, 256, MapFormat::exr);
  const DrawnMap map = draw_map(surface_.mesh(), fields_, request);
  FieldSet other(fields_.size());
  EXPECT_TRUE(read_back(map, 32, surface_, other, 0).delta.empty());
  for (std::uint32_t v = 0; v < other.size(); v += 2) other.set(Field::mask, v, glm::vec4(0));
  const Evaluation read = read_back(map, 32, surface_, other, 0.5);
  for (const std::uint32_t v : read.delta.vertices()) EXPECT_EQ(v % 2, 1u);
  other.apply(read.delta);
  EXPECT_NEAR(other.number(Field::density, 1), 0.5 + 0.5 * fields_.number(Field::density, 1), 1e-5);
}

TEST_F(MapRoundTrip, ValuesBeyondTheFieldAreHeldAndCounted) {
  MapPicture picture{1, 1, 32, {}, {3e38f, -2, 0.5f, 1}};
  ToolExtras extras;
  extras.picture = &picture;
  const Evaluation read = evaluate(ApplyMap{"", Field::length, MapEncoding::value, 1e27}, surface_, fields_, extras);
  EXPECT_EQ(read.clamped, fields_.size());
  FieldSet after = fields_;
  after.apply(read.delta);
  EXPECT_EQ(after.number(Field::length, 7), 10.0f);
  after.apply(evaluate(ApplyMap{"", Field::direction, MapEncoding::vector, 1}, surface_, after, extras).delta);
  EXPECT_TRUE(std::isfinite(after.at(7).direction.x));
}

TEST_F(MapRoundTrip, MapsOfOnePixelStayFinite) {
  for (const int bits : {8, 16, 32})
    EXPECT_TRUE(std::isfinite(worst_change(surface_, fields_, asked(Field::length, 1), bits)));
}

TEST_F(MapRoundTrip, AMaskIsReadFromTheChannelThatIsNamed) {
  const MapPicture picture{1, 1, 8, {}, {1, 0.5f, 0.25f, 0.75f}};
  const auto read = [&](PictureChannel channel) { return read_channel(surface_.mesh(), picture, channel)[3]; };
  EXPECT_DOUBLE_EQ(read(PictureChannel::red), 1);
  EXPECT_DOUBLE_EQ(read(PictureChannel::green), 0.5);
  EXPECT_DOUBLE_EQ(read(PictureChannel::blue), 0.25);
  EXPECT_DOUBLE_EQ(read(PictureChannel::alpha), 0.75);
  EXPECT_NEAR(read(PictureChannel::luminance), 0.2126 + 0.7152 * 0.5 + 0.0722 * 0.25, 1e-7);
  ChangeMask mask;
  mask.shape = MaskPicture{"", PictureChannel::green};
  ToolExtras extras;
  extras.picture = &picture;
  FieldSet after = fields_;
  after.apply(evaluate(mask, surface_, fields_, extras).delta);
  EXPECT_EQ(after.number(Field::mask, 9), 0.5f);
}

/// A horizontal square that faces up; `uv_of` maps its (x, -z) to texture coordinates.
Surface square(const std::function<glm::dvec2(glm::dvec2)>& uv_of) {
  RawModel raw = make_builtin({Builtin::plane, 200});
  for (std::size_t i = 0; i < raw.corners.size(); ++i) {
    const glm::dvec3 p = raw.positions[raw.corners[i]];
    raw.corner_uv[i] = uv_of({p.x, -p.z});
  }
  return surface_of(raw);
}

/// The map's values in the middle, for fur that leans along a direction of the model.
glm::dvec2 drawn_lean(const Surface& surface, glm::dvec3 lean) {
  const Mesh& mesh = surface.mesh();
  FieldSet fields(mesh.positions.size());
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    const glm::dvec3 tangent(mesh.tangents[v]), normal(mesh.normals[v]);
    fields.set(v, Groom{glm::vec2(glm::dot(lean, tangent), glm::dot(lean, glm::cross(normal, tangent))), 0.1f, 0});
  }
  const DrawnMap map = draw_map(mesh, fields, asked(Field::direction, 33, MapFormat::exr));
  const float* middle = map.image.at(16 * 33 + 16);
  return {middle[0], middle[1]};
}

TEST(MapTangents, RedIsAlongUAndGreenAlongV) {
  const glm::dvec3 x(1, 0, 0), away(0, 0, -1);
  const Surface straight = square([](glm::dvec2 p) { return p + 0.5; });
  EXPECT_NEAR(glm::distance(drawn_lean(straight, x), glm::dvec2(1, 0)), 0, 1e-6);
  EXPECT_NEAR(glm::distance(drawn_lean(straight, away), glm::dvec2(0, 1)), 0, 1e-6);
  const Surface turned = square([](glm::dvec2 p) { return glm::dvec2(-p.y, p.x) + 0.5; });
  EXPECT_NEAR(glm::distance(drawn_lean(turned, x), glm::dvec2(0, 1)), 0, 1e-6);
  EXPECT_NEAR(glm::distance(drawn_lean(turned, away), glm::dvec2(-1, 0)), 0, 1e-6);
}

TEST(MapTangents, MirroredIslandsTurnTheBitangentOver) {
  const Surface mirrored = square([](glm::dvec2 p) { return glm::dvec2(-p.x, p.y) + 0.5; });
  EXPECT_NEAR(glm::distance(drawn_lean(mirrored, {1, 0, 0}), glm::dvec2(-1, 0)), 0, 1e-6);
  EXPECT_NEAR(glm::distance(drawn_lean(mirrored, {0, 0, -1}), glm::dvec2(0, 1)), 0, 1e-6) << "green still is along +v";
}

TEST(MapTangents, DirectionsComeBackFromTurnedAndMirroredIslands) {
  for (const bool mirror : {false, true}) {
    for (const double degrees : {0.0, 30.0, 117.0, 270.0}) {
      const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
      const Surface surface = square([&](glm::dvec2 p) {
        const glm::dvec2 q(mirror ? -p.x : p.x, p.y);
        return 0.6 * glm::dvec2(c * q.x - s * q.y, s * q.x + c * q.y) + 0.5;
      });
      const FieldSet fields = random_fields(surface.mesh().positions.size());
      EXPECT_LT(worst_change(surface, fields, asked(Field::direction, 256), 32), 1e-5) << degrees << mirror;
    }
  }
}

TEST(MapExtremes, DegenerateTextureCoordinatesStayFinite) {
  const Surface flat = square([](glm::dvec2) { return glm::dvec2(0.5); });
  EXPECT_FALSE(has_own_uvs(flat.mesh())) << "refused before it comes here";
  const Surface line = square([](glm::dvec2 p) { return glm::dvec2(p.x + 0.5, 0.5); });
  const Surface far = square([](glm::dvec2 p) { return 900.0 * p; });
  for (const Surface* surface : {&flat, &line, &far}) {
    const FieldSet fields = random_fields(surface->mesh().positions.size());
    for (const Field field : {Field::direction, Field::length, Field::tip_colour})
      EXPECT_TRUE(std::isfinite(worst_change(*surface, fields, asked(field, 64), 16)));
  }
  EXPECT_GT(draw_map(far.mesh(), FieldSet(far.mesh().positions.size()), asked(Field::length, 16)).answer.outside, 100u);
}

TEST(MapBuiltins, SheetsHaveTextureCoordinates) {
  for (const Builtin shape : {Builtin::torus, Builtin::knot, Builtin::plane, Builtin::cloth})
    EXPECT_TRUE(has_own_uvs(surface_of(make_builtin({shape, 600})).mesh())) << static_cast<int>(shape);
  const Surface torus = surface_of(make_builtin({Builtin::torus, 600}));
  const DrawnMap map = draw_map(torus.mesh(), FieldSet(torus.mesh().positions.size()), asked(Field::length, 64));
  EXPECT_EQ(map.answer.covered, 1);
  EXPECT_EQ(map.answer.outside, 0u);
}

}  // namespace
}  // namespace pelage
