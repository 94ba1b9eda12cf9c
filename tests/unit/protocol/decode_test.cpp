#include "protocol/json/decode.h"

#include <gtest/gtest.h>

#include <string>

#include "base/limits.h"
#include "clients/cli/recipe/split_steps.h"
#include "tests/unit/protocol/refusals.h"

namespace pelage {
namespace {

const std::string comb_text = R"({"op": "comb", "stroke": {"samples": [{"position": [0, 0.2, 0.5]}]}})";

TEST(Decode, ACombHasDefaults) {
  const auto commands = decode_commands(comb_text);
  ASSERT_TRUE(commands.ok());
  ASSERT_EQ(commands->size(), 1u);
  const Comb& comb = std::get<Comb>(commands->front());
  EXPECT_DOUBLE_EQ(comb.brush.radius, 0.05);
  EXPECT_DOUBLE_EQ(comb.lean, 0.7);
  ASSERT_EQ(comb.stroke->samples.size(), 1u);
  EXPECT_EQ(std::get<PositionSample>(comb.stroke->samples[0].position).position, glm::dvec3(0, 0.2, 0.5));
  EXPECT_DOUBLE_EQ(comb.stroke->samples[0].pressure, 1);
}

TEST(Decode, BatchKeepsItsOrder) {
  const auto commands = decode_commands(R"({"commands": [{"op": "blow", "source": [0, 1, 0]},)"
                                        R"({"op": "attract", "point": [1, 2, 3], "radius": 0.3, "units": "world"}]})");
  ASSERT_TRUE(commands.ok()) << commands.status().message;
  EXPECT_STREQ(op_of(commands->at(0)), "blow");
  const Attract& attract = std::get<Attract>(commands->at(1));
  EXPECT_EQ(attract.units, Units::world);
  EXPECT_DOUBLE_EQ(attract.radius, 0.3);
  EXPECT_DOUBLE_EQ(attract.brush.radius, 0.05);
}

TEST(Decode, ReadsEveryKindOfSample) {
  const auto commands = decode_commands(
      R"({"op": "comb", "stroke": {"id": "k7", "part": 3, "last": false,
          "view": {"camera": {"auto": "front"}, "width": 640, "height": 480},
          "samples": [{"screen": [10.5, 20.5]}, {"triangle": 7, "barycentric": [0.2, 0.3, 0.5], "time": 1}]}})");
  ASSERT_TRUE(commands.ok()) << commands.status().message;
  const Stroke& stroke = *std::get<Comb>(commands->front()).stroke;
  EXPECT_EQ(stroke.id, "k7");
  EXPECT_EQ(stroke.part, 3u);
  EXPECT_FALSE(stroke.last);
  EXPECT_EQ(stroke.view->width, 640);
  EXPECT_EQ(std::get<ScreenSample>(stroke.samples[0].position).screen, glm::dvec2(10.5, 20.5));
  EXPECT_EQ(std::get<SurfaceSample>(stroke.samples[1].position).triangle, 7u);
}

TEST(Decode, RefusesWhatIsNotJson) {
  expect_refusal("", Code::malformed, "");
  expect_refusal("comb", Code::malformed, "");
  expect_refusal("{\"op\": \"comb\"", Code::malformed, "");
  expect_refusal("{\"op\": \"comb\"} x", Code::malformed, "");
  expect_refusal("{\"op\": NaN}", Code::malformed, "");
  expect_refusal("{\"op\": \"\xff\xfe\"}", Code::malformed, "");
}

TEST(Decode, RefusesDuplicateNamesWithTheirPosition) {
  expect_refusal(R"({"op": "comb", "op": "comb"})", Code::malformed, "/op");
  expect_refusal(R"({"commands": [{"op": "comb"}, {"brush": {"radius": 1, "radius": 2}}]})", Code::malformed,
                 "/commands/1/brush/radius");
}

TEST(Decode, RefusesNumbersThatOverflow) {
  expect_refusal(R"({"op": "blow", "source": [1e400, 0, 0]})", Code::malformed, "/source");
  expect_refusal(R"({"op": "blow", "source": [-1e400, 0, 0]})", Code::malformed, "/source");
}

TEST(Decode, RefusesDeepNesting) {
  const std::size_t max = static_cast<std::size_t>(limits::json_depth);
  EXPECT_EQ(refusal(std::string(max, '[') + std::string(max, ']')).code, Code::invalid);
  EXPECT_EQ(refusal(std::string(max + 1, '[') + std::string(max + 1, ']')).code, Code::malformed);
  EXPECT_EQ(refusal(std::string(500000, '[')).code, Code::malformed);
}

TEST(Decode, NamesTheNearestKnownName) {
  const Status member = refusal(R"({"op": "comb", "brush": {"raduis": 1}, "flood": true, "direction": [0, 1, 0]})");
  EXPECT_EQ(member.code, Code::invalid);
  EXPECT_EQ(member.pointer, "/brush/raduis");
  EXPECT_EQ(member.nearest, "radius");
  EXPECT_EQ(refusal(R"({"op": "cmob"})").nearest, "comb");
  EXPECT_EQ(refusal(R"({"op": "set_cote"})").nearest, "set_coat");
  const Status shape = refusal(R"({"op": "comb", "brush": {"falloff_shape": "surfaces"}})");
  EXPECT_EQ(shape.pointer, "/brush/falloff_shape");
  EXPECT_EQ(shape.limit, "volume | surface | screen");
  EXPECT_EQ(shape.nearest, "surface");
}

TEST(Decode, EscapesPointers) {
  expect_refusal(R"({"op": "comb", "a/b~c": 1, "flood": true, "direction": [0, 1, 0]})", Code::invalid, "/a~1b~0c");
}

TEST(Decode, RangesHoldAtTheirEndsOnly) {
  const auto comb_with = [](const std::string& brush) {
    return R"({"op": "comb", "flood": true, "direction": [0, 1, 0], "brush": {)" + brush + "}}";
  };
  EXPECT_TRUE(refusal(comb_with(R"("strength": 0)")).ok());
  EXPECT_TRUE(refusal(comb_with(R"("strength": 1)")).ok());
  const Status status = refusal(comb_with(R"("strength": 1.0000001)"));
  EXPECT_EQ(status.code, Code::invalid);
  EXPECT_EQ(status.pointer, "/brush/strength");
  EXPECT_EQ(status.limit, "[0, 1]");
  EXPECT_EQ(status.message, "1.0000001 is out of range.");
  EXPECT_EQ(refusal(comb_with(R"("strength": -2)")).message, "-2 is out of range.");
  EXPECT_EQ(refusal(comb_with(R"("strength": 9000.0)")).message, "9000 is out of range.");
  EXPECT_EQ(refusal(comb_with(R"("strength": 1e+27)")).message, "1e+27 is out of range.");
  expect_refusal(comb_with(R"("strength": "1")"), Code::invalid, "/brush/strength");
  expect_refusal(comb_with(R"("strength": null)"), Code::invalid, "/brush/strength");
  expect_refusal(comb_with(R"("radius": -0.1)"), Code::invalid, "/brush/radius");
  expect_refusal(comb_with(R"("invert": 1)"), Code::invalid, "/brush/invert");
}

TEST(Decode, CombNeedsAStrokeOrAFlood) {
  expect_refusal(R"({"op": "comb"})", Code::invalid, "/stroke");
  expect_refusal(R"({"op": "comb", "flood": true})", Code::invalid, "/direction");
  expect_refusal(R"({"op": "comb", "flood": true, "direction": [0, 0, 0]})", Code::invalid, "/direction");
  expect_refusal(
      R"({"op": "comb", "flood": true, "direction": [0, 1, 0], "stroke": {"samples": [{"position": [0, 0, 0]}]}})",
      Code::invalid, "/stroke");
  expect_refusal(R"({"op": "comb", "direction": [0, 1, 0], "stroke": {"samples": [{"position": [0, 0, 0]}]}})",
                 Code::invalid, "/direction");
}

TEST(Decode, StrokesAreWhole) {
  const auto stroke = [](const std::string& body) { return R"({"op": "comb", "stroke": {)" + body + "}}"; };
  expect_refusal(stroke(R"("id": "a")"), Code::invalid, "/stroke/samples");
  expect_refusal(stroke(R"("samples": [])"), Code::invalid, "/stroke/samples");
  expect_refusal(stroke(R"("samples": [{"screen": [1, 1]}])"), Code::invalid, "/stroke/view");
  expect_refusal(stroke(R"("samples": [{}])"), Code::invalid, "/stroke/samples/0");
  expect_refusal(stroke(R"("samples": [{"position": [0, 0, 0], "screen": [1, 1]}])"), Code::invalid,
                 "/stroke/samples/0");
  expect_refusal(stroke(R"("samples": [{"position": [0, 0]}])"), Code::invalid, "/stroke/samples/0/position");
  expect_refusal(stroke(R"("samples": [{"triangle": 1}])"), Code::invalid, "/stroke/samples/0/barycentric");
  expect_refusal(stroke(R"("samples": [{"triangle": 1.5, "barycentric": [0, 0, 1]}])"), Code::invalid,
                 "/stroke/samples/0/triangle");
  expect_refusal(stroke(R"("samples": [{"triangle": 1, "barycentric": [0.5, 0.5, 0.5]}])"), Code::invalid,
                 "/stroke/samples/0/barycentric");
  expect_refusal(stroke(R"("samples": [{"position": [0, 0, 0], "time": 2}, {"position": [0, 0, 0], "time": 1}])"),
                 Code::invalid, "/stroke/samples/1/time");
  expect_refusal(stroke(R"("id": "a\u0000b", "samples": [{"position": [0, 0, 0]}])"), Code::invalid, "/stroke/id");
}

TEST(Decode, CountsAreLimited) {
  const std::string sample = R"({"position":[0,0,0]})";
  const auto stroke_of_size = [&](std::size_t n) {
    return R"({"op":"comb","stroke":{"samples":[)" + repeated(sample, n) + "]}}";
  };
  EXPECT_TRUE(refusal(stroke_of_size(limits::samples_per_stroke)).ok());
  expect_refusal(stroke_of_size(limits::samples_per_stroke + 1), Code::invalid, "/stroke/samples");
  const auto batch = [&](std::size_t n) { return R"({"commands": [)" + repeated(comb_text, n) + "]}"; };
  EXPECT_TRUE(refusal(batch(limits::commands_per_batch)).ok());
  expect_refusal(batch(limits::commands_per_batch + 1), Code::invalid, "/commands");
  expect_refusal(R"({"commands": []})", Code::invalid, "/commands");
  expect_refusal(R"({"op": "set_lights", "lights": [)" + repeated("{}", limits::lights + 1) + "]}", Code::invalid,
                 "/lights");
}

TEST(Decode, BareSkinHasLimits) {
  const auto regions = [](const std::string& list) { return R"({"op": "set_skin", "regions": [)" + list + "]}"; };
  const auto region = [&](const std::string& members) {
    return regions(R"({"centre": [0, 1, 0], "radii": [0.1, 0.2, 0.3])" + (members.empty() ? "" : ", " + members) + "}");
  };
  const std::string one = R"({"centre": [0, 0, 0], "radii": [1, 1, 1]})";
  EXPECT_TRUE(refusal(regions("")).ok());
  EXPECT_TRUE(refusal(region(R"("softness": 0, "facing": {"direction": [0, 1, 0]}, "bumps": {})")).ok());
  EXPECT_TRUE(refusal(region(R"("softness": 10, "colour": "#ffffff", "wetness": 1)")).ok());
  EXPECT_TRUE(refusal(regions(repeated(one, limits::skin_regions))).ok());
  expect_refusal(regions(repeated(one, limits::skin_regions + 1)), Code::invalid, "/regions");
  expect_refusal(regions(R"({"centre": [0, 0, 0]})"), Code::invalid, "/regions/0/radii");
  expect_refusal(regions(R"({"centre": [0, 0, 0], "radii": [1, 0, 1]})"), Code::invalid, "/regions/0/radii/1");
  expect_refusal(region(R"("softness": -0.1)"), Code::invalid, "/regions/0/softness");
  expect_refusal(region(R"("axis": [0, 0, 0])"), Code::invalid, "/regions/0/axis");
  expect_refusal(region(R"("facing": {})"), Code::invalid, "/regions/0/facing/direction");
  expect_refusal(region(R"("facing": {"direction": [0, 0, 1], "angle_degrees": 181})"), Code::invalid,
                 "/regions/0/facing/angle_degrees");
  expect_refusal(region(R"("roughness": 0)"), Code::invalid, "/regions/0/roughness");
  expect_refusal(region(R"("bumps": {"size": 0})"), Code::invalid, "/regions/0/bumps/size");
  expect_refusal(region(R"("color": "#ffffff")"), Code::invalid, "/regions/0/color");
}

TEST(Decode, EyesHaveLimits) {
  const auto eyes = [](const std::string& list) { return R"({"op": "set_eyes", "eyes": [)" + list + "]}"; };
  const auto eye = [&](const std::string& members) {
    return eyes(R"({"position": [0, 1, 0], "radius": 0.02)" + (members.empty() ? "" : ", " + members) + "}");
  };
  EXPECT_TRUE(refusal(eyes("")).ok());
  EXPECT_TRUE(refusal(eye("")).ok());
  EXPECT_TRUE(
      refusal(eye(R"("look_at": [0, 0, 0], "pupil": {"shape": "slit", "size": "automatic"}, "lids": {})")).ok());
  EXPECT_TRUE(refusal(eyes(repeated(R"({"position": [0, 0, 0], "radius": 1})", limits::eyes))).ok());
  expect_refusal(eyes(repeated(R"({"position": [0, 0, 0], "radius": 1})", limits::eyes + 1)), Code::invalid, "/eyes");
  expect_refusal(eyes(R"({"position": [0, 1, 0], "radius": 0})"), Code::invalid, "/eyes/0/radius");
  expect_refusal(eyes(R"({"position": [0, 1, 0]})"), Code::invalid, "/eyes/0/radius");
  expect_refusal(eye(R"("gaze": [0, 0, 0])"), Code::invalid, "/eyes/0/gaze");
  expect_refusal(eye(R"("gaze": [0, 0, 1], "look_at": [0, 0, 0])"), Code::invalid, "/eyes/0/gaze");
  expect_refusal(eye(R"("look_at": [0, 1, 0])"), Code::invalid, "/eyes/0/look_at");
  expect_refusal(eye(R"("pupil": {"size": 1.5})"), Code::invalid, "/eyes/0/pupil/size");
  expect_refusal(eye(R"("pupil": {"size": "small"})"), Code::invalid, "/eyes/0/pupil/size");
  expect_refusal(eye(R"("refraction": 0.9)"), Code::invalid, "/eyes/0/refraction");
  expect_refusal(eye(R"("iris": {"color": "#ffffff"})"), Code::invalid, "/eyes/0/iris/color");
  EXPECT_EQ(refusal(eye(R"("iris": {"color": "#ffffff"})")).nearest, "colour");
}

TEST(Decode, CurvesHaveLimits) {
  const auto groups = [](const std::string& list) { return R"({"op": "set_curves", "groups": [)" + list + "]}"; };
  const auto group = [&](const std::string& curves, const std::string& members = "") {
    return groups(R"({"curves": [)" + curves + "]" + (members.empty() ? "" : ", " + members) + "}");
  };
  const std::string line = "[[0, 0, 0], [0, 1, 0]]";
  EXPECT_TRUE(refusal(groups("")).ok());
  EXPECT_TRUE(refusal(group(line)).ok());
  EXPECT_TRUE(refusal(group("[" + repeated("[0, 0, 0]", limits::curve_points) + "]")).ok());
  expect_refusal(group("[" + repeated("[0, 0, 0]", limits::curve_points + 1) + "]"), Code::invalid,
                 "/groups/0/curves/0");
  expect_refusal(group("[[0, 0, 0]]"), Code::invalid, "/groups/0/curves/0");
  expect_refusal(group(line + ", [[0, 0, 0], [0, 1]]"), Code::invalid, "/groups/0/curves/1/1");
  expect_refusal(group(""), Code::invalid, "/groups/0/curves");
  expect_refusal(groups("{}"), Code::invalid, "/groups/0/curves");
  EXPECT_TRUE(refusal(group(repeated(line, limits::curves))).ok());
  expect_refusal(group(repeated(line, limits::curves + 1)), Code::invalid, "/groups/0/curves");
  expect_refusal(group(line, R"("width_root": 0.2)"), Code::invalid, "/groups/0/width_root");
  expect_refusal(group(line, R"("width_tip": -1)"), Code::invalid, "/groups/0/width_tip");
  expect_refusal(group(line, R"("spread": 1.5)"), Code::invalid, "/groups/0/spread");
  expect_refusal(group(line, R"("fill": 0.5)"), Code::invalid, "/groups/0/fill");
  expect_refusal(group(line, R"("fill": 4096)"), Code::invalid, "/groups/0/fill");
  expect_refusal(group(line, R"("root_color": "#ffffff")"), Code::invalid, "/groups/0/root_color");
}

TEST(Decode, CurvesAreCountedWithWhatIsFilledIn) {
  const auto pair = [](int fill) {
    return R"({"curves": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]], "fill": )" + std::to_string(fill) + "}";
  };
  const auto groups = [](const std::string& list) { return R"({"op": "set_curves", "groups": [)" + list + "]}"; };
  EXPECT_TRUE(refusal(groups(pair(limits::curves - 2))).ok());
  expect_refusal(groups(pair(limits::curves - 1)), Code::invalid, "/groups/0");
  EXPECT_TRUE(refusal(groups(repeated(pair(limits::curves / 16 - 2), limits::curve_groups))).ok());
  expect_refusal(groups(repeated(pair(limits::curves / 16 - 2), 15) + "," + pair(limits::curves / 16 - 1)),
                 Code::invalid, "/groups/15");
  expect_refusal(groups(repeated(pair(0), limits::curve_groups + 1)), Code::invalid, "/groups");
}

TEST(Decode, BatchesNameTheCommand) {
  expect_refusal(R"({"commands": [)" + comb_text + R"(, {"op": "comb", "brush": {"radius": -1}}]})", Code::invalid,
                 "/commands/1/brush/radius");
  expect_refusal(R"({"commands": [)" + comb_text + R"(], "op": "comb"})", Code::invalid, "/op");
  expect_refusal(R"({"commands": [7]})", Code::invalid, "/commands/0");
}

TEST(Decode, RampsRise) {
  expect_refusal(
      R"({"op": "set_coat", "coat": {"ramp": [{"at": 0, "colour": "#000000"}, {"at": 0, "colour": "#ffffff"}]}})",
      Code::invalid, "/coat/ramp/1/at");
  expect_refusal(R"({"op": "set_coat", "coat": {"ramp": [{"at": 0, "colour": "red"}]}})", Code::invalid,
                 "/coat/ramp/0/colour");
}

TEST(Decode, ReadsThePartsOfACoat) {
  const auto commands = decode_commands(
      R"({"op": "set_coat", "coat": {"wetness": 1, "undercoat": {"share": 0.6}, "ticking": {"share": 0.1, "colour": "#ffffff"},
          "pattern": {"kind": "rosettes", "axis": [1, 0, 0], "seed": 9}, "variation": {"hue": 0.2}}})");
  ASSERT_TRUE(commands.ok()) << commands.status().message;
  const Coat& coat = std::get<SetCoat>(commands->front()).coat;
  EXPECT_EQ(coat.wetness, 1);
  EXPECT_EQ(coat.undercoat, (Undercoat{.share = 0.6}));
  EXPECT_EQ(coat.ticking, (Ticking{.share = 0.1, .colour = glm::vec3(1)}));
  EXPECT_EQ(coat.pattern, (Pattern{.kind = PatternKind::rosettes, .axis = {1, 0, 0}, .seed = 9}));
  EXPECT_EQ(coat.variation, (Variation{.hue = 0.2}));
}

TEST(Decode, PartsOfACoatHaveLimits) {
  const auto coat = [](const std::string& members) { return R"({"op": "set_coat", "coat": {)" + members + "}}"; };
  expect_refusal(coat(R"("wetness": 1.1)"), Code::invalid, "/coat/wetness");
  expect_refusal(coat(R"("wave": -0.1)"), Code::invalid, "/coat/wave");
  expect_refusal(coat(R"("fine_clump_size": 0)"), Code::invalid, "/coat/fine_clump_size");
  expect_refusal(coat(R"("undercoat": {"length": 0})"), Code::invalid, "/coat/undercoat/length");
  expect_refusal(coat(R"("ticking": {"colour": "white"})"), Code::invalid, "/coat/ticking/colour");
  expect_refusal(coat(R"("pattern": {"scale": 0})"), Code::invalid, "/coat/pattern/scale");
  expect_refusal(coat(R"("pattern": {"axis": [0, 0, 0]})"), Code::invalid, "/coat/pattern/axis");
  expect_refusal(coat(R"("pattern": {"kind": "stripe"})"), Code::invalid, "/coat/pattern/kind");
  expect_refusal(coat(R"("variation": {"amount": 1})"), Code::invalid, "/coat/variation/amount");
}

TEST(DecodeColour, IsSrgb) {
  const auto commands = decode_commands(R"({"op": "set_look", "look": {"skin": "#ff0080"}})");
  ASSERT_TRUE(commands.ok());
  const glm::vec3 skin = std::get<SetLook>(commands->front()).look.skin;
  EXPECT_FLOAT_EQ(skin.r, 1);
  EXPECT_FLOAT_EQ(skin.g, 0);
  EXPECT_NEAR(skin.b, 0.2158605, 1e-6);  // 128 / 255 by IEC 61966-2-1
}

TEST(DecodeHistory, ReadsBranchesAndAmendments) {
  EXPECT_EQ(decode_branch(" ")->name, "branch");
  EXPECT_FALSE(decode_branch("{}")->revision);
  EXPECT_EQ(decode_branch(R"({"revision": 3})")->revision, std::uint64_t{3});
  EXPECT_EQ(decode_branch(R"({"name": ""})").status().pointer, "/name");
  EXPECT_EQ(decode_branch(R"({"revision": -3})").status().pointer, "/revision");
  EXPECT_EQ(decode_branch(R"({"at": 3})").status().pointer, "/at");

  EXPECT_TRUE(decode_amend(R"({"revision": 3, "commands": []})")->commands.empty());
  EXPECT_EQ(decode_amend(R"({"commands": []})").status().pointer, "/revision");
  EXPECT_EQ(decode_amend(R"({"revision": 3})").status().pointer, "/commands");
  EXPECT_EQ(decode_amend(R"({"revision": 3, "commands": {"op": "set_ground"}})").status().pointer, "/commands");
  EXPECT_EQ(decode_amend(R"({"revision": 3, "commands": [{"op": "set_grond", "ground": {}}]})").status().nearest,
            "set_ground");
  std::string many = R"({"revision": 3, "commands": [)";
  for (int i = 0; i < 1001; ++i) many += std::string(i == 0 ? "" : ",") + R"({"op": "set_ground", "ground": {}})";
  EXPECT_EQ(decode_amend(many + "]}").status().pointer, "/commands");
}

TEST(DecodeImportQuery, ReadsAxesAndFormats) {
  const auto options = decode_import_query({{"format", "3ds"}, {"up", "-z"}, {"front", "y"}, {"length", "0.1"}});
  ASSERT_TRUE(options.ok());
  EXPECT_EQ(options->format, ModelFormat::tds);
  EXPECT_EQ(options->up, Axis::minus_z);
  EXPECT_DOUBLE_EQ(options->fur.length, 0.1);
  EXPECT_EQ(decode_import_query({}).status().pointer, "/format");
  EXPECT_EQ(decode_import_query({{"format", "fbx"}}).status().pointer, "/format");
  EXPECT_EQ(decode_import_query({{"format", "obj"}, {"up", "z"}, {"front", "-z"}}).status().pointer, "/front");
}

TEST(DecodeScene, NewScenesHaveDefaultsAndLimits) {
  EXPECT_EQ(decode_new_scene("{}")->model.shape, Builtin::creature);
  EXPECT_TRUE(decode_new_scene(R"({"name": ")" + std::string(limits::name_bytes, 'x') + "\"}").ok());
  EXPECT_EQ(decode_new_scene(R"({"name": ")" + std::string(limits::name_bytes + 1, 'x') + "\"}").status().pointer,
            "/name");
  EXPECT_EQ(decode_new_scene(R"({"name": ""})").status().pointer, "/name");
  EXPECT_EQ(decode_new_scene(R"({"model": {"builtin": "torsu"}})").status().nearest, "torus");
  EXPECT_EQ(decode_new_scene(R"({"model": {"triangles": 1000001}})").status().pointer, "/model/triangles");
}

TEST(DecodeMoves, ReadsStepsAndRevisions) {
  EXPECT_EQ(*decode_steps(""), 1);
  EXPECT_EQ(*decode_steps(R"({"steps": 3})"), 3);
  EXPECT_EQ(decode_steps(R"({"steps": 0})").status().pointer, "/steps");
  EXPECT_EQ(*decode_revision(R"({"revision": 18446744073709551615})"), 18446744073709551615ULL);
  EXPECT_EQ(decode_revision(R"({"revision": -1})").status().pointer, "/revision");
  EXPECT_EQ(decode_revision("{}").status().pointer, "/revision");
}

TEST(DecodePick, PixelsLieInTheView) {
  EXPECT_TRUE(decode_pick(R"({"view": {"width": 10, "height": 20}, "pixel": [10, 20]})").ok());
  EXPECT_EQ(decode_pick(R"({"view": {"width": 10, "height": 20}, "pixel": [10.5, 0]})").status().pointer, "/pixel/0");
  EXPECT_EQ(decode_pick("{}").status().pointer, "/pixel");
  const auto refused = [](const char* text) { return decode_pick(text).status().pointer; };
  EXPECT_TRUE(decode_pick(R"({"ray": {"origin": [0, 0, 9], "direction": [0, 0, -1]}})").ok());
  EXPECT_EQ(refused(R"({"ray": {"origin": [0, 0, 9], "direction": [0, 0, 0]}})"), "/ray/direction");
  EXPECT_EQ(refused(R"({"ray": {"origin": [0, 0, 9], "direction": [0, 0, 1]}, "pixel": [1, 1]})"), "/pixel");
  EXPECT_TRUE(decode_pick(R"({"farthest": {"direction": [0, 1, 0]}})").ok());
  EXPECT_TRUE(decode_pick(R"({"farthest": {"direction": [0, 1, 0], "min": [0, 0, 0], "max": [0, 1, 1]}})").ok());
  EXPECT_EQ(refused(R"({"farthest": {"direction": [0, 1, 0], "min": [0, 0, 0]}})"), "/farthest/max");
  EXPECT_EQ(refused(R"({"farthest": {"direction": [0, 1, 0], "min": [0, 2, 0], "max": [0, 1, 1]}})"), "/farthest/max");
  EXPECT_TRUE(decode_pick(R"({"nearest": [1, 2, 3]})").ok());
  EXPECT_EQ(refused(R"({"nearest": [1, 2]})"), "/nearest");
}

TEST(SplitSteps, SplitsLinesArraysAndDocuments) {
  EXPECT_EQ(split_steps("{\"op\": \"a\"}\n\n{\"op\": \"b\"}\r\n")->size(), 2u);
  EXPECT_EQ(split_steps("[{\"op\": \"a\"},\n {\"op\": \"b\"}, {}]")->size(), 3u);
  EXPECT_EQ(split_steps("{\n\"op\":\n\"a\"}")->size(), 1u);
  EXPECT_FALSE(split_steps("").ok());
  EXPECT_NE(split_steps("{}\n{]\n").status().message.find("Line 2"), std::string::npos);
  EXPECT_NE(split_steps("{\n\"op\" \"a\"}").status().message.find("line 2"), std::string::npos);
}

TEST(DecodeSubdivide, HasDefaultsAndLimits) {
  EXPECT_EQ(decode_subdivide("")->levels, 1);
  EXPECT_FALSE(decode_subdivide("{}")->masked);
  const auto both = decode_subdivide(R"({"levels": 3, "masked": true})");
  ASSERT_TRUE(both.ok());
  EXPECT_EQ(both->levels, 3);
  EXPECT_TRUE(both->masked);
  EXPECT_EQ(decode_subdivide(R"({"levels": 0})").status().pointer, "/levels");
  EXPECT_EQ(decode_subdivide(R"({"levels": 9})").status().pointer, "/levels");
  EXPECT_EQ(decode_subdivide(R"({"mask": true})").status().nearest, "masked");
}

TEST(DecodeTurnModel, NamesAxes) {
  EXPECT_EQ(decode_turn_model("")->up, Axis::plus_y);
  const auto lying = decode_turn_model(R"({"up": "z", "front": "-y"})");
  ASSERT_TRUE(lying.ok());
  EXPECT_EQ(lying->up, Axis::plus_z);
  EXPECT_EQ(lying->front, Axis::minus_y);
  EXPECT_EQ(decode_turn_model(R"({"up": "w"})").status().pointer, "/up");
}

TEST(DecodeRetarget, NamesItsSource) {
  const auto commands = decode_commands(R"({"op": "retarget", "scene": "abc", "fields": ["length"]})");
  ASSERT_TRUE(commands.ok());
  const auto& retarget = std::get<Retarget>(commands->front());
  EXPECT_EQ(retarget.scene, "abc");
  EXPECT_FALSE(retarget.revision);
  EXPECT_EQ(retarget.align, Alignment::box);
  EXPECT_EQ(retarget.strength, 1);
  expect_refusal(R"({"op": "retarget"})", Code::invalid, "/scene");
  expect_refusal(R"({"op": "retarget", "scene": ""})", Code::invalid, "/scene");
  expect_refusal(R"({"op": "retarget", "scene": "abc", "align": "boxes"})", Code::invalid, "/align");
  expect_refusal(R"({"op": "retarget", "scene": "abc", "strength": 2})", Code::invalid, "/strength");
}

}  // namespace
}  // namespace pelage
