// Traced strands, progressive pictures and lights with a size, as JSON.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/limits.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "tests/unit/protocol/refusals.h"

namespace pelage {
namespace {

FrameRequest decoded(const std::string& text) {
  const auto request = decode_frame_request(text);
  EXPECT_TRUE(request.ok()) << text << "\n" << request.status().message << " " << request.status().pointer;
  return request.ok() ? *request : FrameRequest{};
}

Status frame_refusal(const std::string& text) {
  const auto request = decode_frame_request(text);
  return request.ok() ? Status{} : request.status();
}

void expect_frame_refusal(const std::string& text, const std::string& pointer) {
  const Status status = frame_refusal(text);
  EXPECT_EQ(status.code, Code::invalid) << text << "\n" << status.message;
  EXPECT_EQ(status.pointer, pointer) << text << "\n" << status.message;
  EXPECT_NE(status.limit, "") << text << "\nsays no limit";
}

/// A frame whose strands are traced with these members; `progressive` makes one that is progressive with them.
std::string traced(const std::string& trace) {
  return R"({"quality": {"method": "strands", "trace": {)" + trace + "}}}";
}
std::string progressive(const std::string& trace) { return R"({"progressive": {)" + trace + "}}"; }

Status lights_refusal(const std::string& members) {
  return refusal(R"({"op": "set_lights", "lights": [{)" + members + "}]}");
}

TEST(Trace, DefaultsAreThoseOfTheStruct) {
  EXPECT_EQ(decoded("{}").knobs.method, Method::raster);
  EXPECT_FALSE(decoded("{}").progressive);
  const FrameRequest strands = decoded(R"({"quality": {"method": "strands"}})");
  EXPECT_EQ(strands.knobs.method, Method::strands);
  EXPECT_EQ(strands.knobs.trace, Tracing{});
  EXPECT_EQ(decoded(traced("")).knobs.trace, Tracing{});
  EXPECT_EQ(Tracing{}.passes, 64);
  EXPECT_EQ(Tracing{}.strands, 2'000'000);
  EXPECT_EQ(Tracing{}.transport, Transport::transmittance);
  EXPECT_TRUE(Tracing{}.filter);
}

TEST(Trace, TheTierReferenceTraces) {
  EXPECT_EQ(decoded(R"({"quality": "reference"})").knobs, knobs_of(Tier::reference));
  EXPECT_EQ(knobs_of(Tier::reference).method, Method::strands);
  for (const Tier tier : {Tier::draft, Tier::interactive, Tier::detailed})
    EXPECT_EQ(knobs_of(tier).method, Method::raster);
}

TEST(Trace, ReadsEachMember) {
  const std::string members = R"("passes": 7, "transport": "paths", "scattering": "energy_conserving", "bounces": 9,
      "strands": 1234, "noise": 0.25, "seconds": 1.5, "filter": false, "seed": 4294967295)";
  const Tracing expected{.passes = 7,
                         .transport = Transport::paths,
                         .scattering = StrandScattering::energy_conserving,
                         .bounces = 9,
                         .strands = 1234,
                         .noise = 0.25,
                         .seconds = 1.5,
                         .filter = false,
                         .seed = 4294967295u};
  EXPECT_EQ(decoded(traced(members)).knobs.trace, expected);
  EXPECT_EQ(decoded(progressive(members)).progressive, expected);
  EXPECT_EQ(decoded(traced(R"("scattering": "energy_conserving")")).knobs.trace.scattering,
            StrandScattering::energy_conserving);
}

TEST(Trace, StrandsScatterByTheLookAndPathsByEnergyConserving) {
  EXPECT_EQ(knobs_of(Tier::reference).trace.scattering, StrandScattering::look);
  EXPECT_EQ(decoded(traced(R"("passes": 7)")).knobs.trace.scattering, StrandScattering::look);
  const Tracing paths = decoded(traced(R"("transport": "paths")")).knobs.trace;
  EXPECT_EQ(paths.scattering, StrandScattering::energy_conserving);
}

TEST(Trace, TakesTheEndsOfRangesAndRefusesWhatLiesBeyond) {
  struct Member {
    std::string name;
    std::vector<std::string> taken, refused;
  };
  const std::string passes = std::to_string(limits::trace_passes), strands = std::to_string(limits::strands);
  const std::vector<Member> members = {
      {"passes", {"1", passes}, {"0", "-1", std::to_string(limits::trace_passes + 1), "1.5", "\"many\"", "1e300"}},
      {"strands", {"1", strands}, {"0", std::to_string(limits::strands + 1), "2.5", "null"}},
      {"noise", {"0", "1"}, {"-0.001", "1.001", "true"}},
      {"seconds", {"0", "3600"}, {"-1", "3600.5", "\"long\""}},
      {"seed", {"0", "4294967295"}, {"-1", "4294967296", "0.5"}},
      {"filter", {"true", "false"}, {"1", "\"yes\""}},
      {"transport", {R"("transmittance")", R"("paths")"}, {R"("path")", "1"}},
      {"scattering", {R"("look")", R"("energy_conserving")"}, {R"("marschner")", "{}"}},
      {"colour", {}, {"1"}}};
  for (const Member& member : members) {
    for (const std::string& value : member.taken) {
      const std::string text = "\"" + member.name + "\": " + value;
      EXPECT_TRUE(frame_refusal(traced(text)).ok()) << text;
      EXPECT_TRUE(frame_refusal(progressive(text)).ok()) << text;
    }
    for (const std::string& value : member.refused) {
      const std::string text = "\"" + member.name + "\": " + value;
      EXPECT_EQ(frame_refusal(traced(text)).pointer, "/quality/trace/" + member.name) << text;
      EXPECT_EQ(frame_refusal(progressive(text)).pointer, "/progressive/" + member.name) << text;
    }
  }
}

TEST(Trace, OnlyPathsHaveBounces) {
  for (const std::string bounces : {"1", "4096"})
    EXPECT_TRUE(frame_refusal(traced(R"("transport": "paths", "bounces": )" + bounces)).ok());
  for (const std::string bounces : {"0", "4097", "1.5"})
    expect_frame_refusal(traced(R"("transport": "paths", "bounces": )" + bounces), "/quality/trace/bounces");
  expect_frame_refusal(traced(R"("bounces": 32)"), "/quality/trace/bounces");
  expect_frame_refusal(progressive(R"("transport": "transmittance", "bounces": 32)"), "/progressive/bounces");
  expect_frame_refusal(traced(R"("transport": "paths", "scattering": "look")"), "/quality/trace/scattering");
  expect_frame_refusal(progressive(R"("transport": "paths", "scattering": "look")"), "/progressive/scattering");
}

TEST(Trace, MethodsTakeTheirOwnKnobs) {
  const auto asked = [](const std::string& method, const std::string& knob) {
    return R"({"quality": {"method": ")" + method + "\", " + knob + "}}";
  };
  struct Own {
    std::string knob;
    std::vector<std::string> methods;
  };
  const std::vector<Own> knobs = {{R"("scale": 1)", {"raster", "shells"}},
                                  {R"("eye_steps": 3)", {"raster", "strands"}},
                                  {R"("raster": {"strands": 1})", {"raster"}},
                                  {R"("trace": {"passes": 1})", {"strands"}},
                                  {R"("shells": {"count": 8})", {"shells"}}};
  for (const Own& own : knobs) {
    const std::string name = own.knob.substr(1, own.knob.find('"', 1) - 1);
    for (const std::string method : {"raster", "strands", "shells"}) {
      const bool taken = std::find(own.methods.begin(), own.methods.end(), method) != own.methods.end();
      if (taken)
        EXPECT_TRUE(frame_refusal(asked(method, own.knob)).ok()) << method << " " << name;
      else
        expect_frame_refusal(asked(method, own.knob), "/quality/" + name);
    }
  }
  EXPECT_EQ(decoded(asked("strands", R"("eye_steps": 3)")).knobs.eye_steps, 3);
  expect_frame_refusal(R"({"quality": {"trace": {}}})", "/quality/trace");
  EXPECT_EQ(frame_refusal(R"({"quality": {"method": "hairs"}})").pointer, "/quality/method");
}

TEST(Trace, ProgressiveIsASwitchOrHowToTrace) {
  EXPECT_EQ(decoded(R"({"progressive": true})").progressive, Tracing{});
  EXPECT_FALSE(decoded(R"({"progressive": false})").progressive);
  EXPECT_EQ(decoded(progressive("")).progressive, Tracing{});
  EXPECT_EQ(frame_refusal(R"({"progressive": 1})").pointer, "/progressive");
  EXPECT_EQ(frame_refusal(R"({"progressive": "yes"})").pointer, "/progressive");
  expect_frame_refusal(R"({"quality": "reference", "progressive": true})", "/progressive");
  for (const std::string method : {"strands", "shells"})
    expect_frame_refusal(R"({"quality": {"method": ")" + method + R"("}, "progressive": {}})", "/progressive");
  EXPECT_TRUE(frame_refusal(R"({"quality": "reference", "progressive": false})").ok());
}

TEST(Trace, OverlaysLieOnStrandsAlone) {
  const std::string shells = R"({"quality": {"method": "shells"}, )";
  for (const std::string overlay : {"direction", "strokes", "length", "density", "wetness", "mask", "bald", "wire"}) {
    const std::string member = R"("overlay": ")" + overlay + "\"}";
    EXPECT_TRUE(frame_refusal(R"({"quality": "reference", )" + member).ok()) << overlay;
    EXPECT_TRUE(frame_refusal("{" + member).ok()) << overlay;
    expect_frame_refusal(shells + member, "/overlay");
  }
  EXPECT_TRUE(frame_refusal(R"({"quality": "reference", "overlay": "difference", "overlay_from": 1})").ok());
  EXPECT_TRUE(frame_refusal(shells + R"("format": "exr", "aovs": ["beauty", "alpha"]})").ok());
  expect_frame_refusal(shells + R"("format": "exr", "aovs": ["beauty", "depth"]})", "/aovs");
}

TEST(Trace, OnlyRasterizedStrandsHaveNumbersAndRoots) {
  for (const std::string aov : {"strand", "root"}) {
    const std::string exr = R"({"format": "exr", "aovs": ["beauty", ")" + aov + R"("])";
    EXPECT_TRUE(frame_refusal(exr + R"(, "progressive": false})").ok());
    expect_frame_refusal(exr + R"(, "quality": "reference"})", "/aovs");
    expect_frame_refusal(exr + R"(, "progressive": {}})", "/aovs");
  }
}

TEST(Trace, ComesBackThroughEncode) {
  FrameRequest strands;
  strands.knobs = knobs_of(Tier::reference);
  strands.knobs.trace = {
      .passes = 3, .scattering = StrandScattering::energy_conserving, .strands = 77, .noise = 0.01, .seed = 9};
  EXPECT_EQ(decoded(encode(strands)).knobs, strands.knobs);
  FrameRequest progressive;
  progressive.progressive = Tracing{.passes = 5,
                                    .transport = Transport::paths,
                                    .scattering = StrandScattering::energy_conserving,
                                    .bounces = 100,
                                    .seconds = 2,
                                    .filter = false};
  EXPECT_EQ(decoded(encode(progressive)).progressive, progressive.progressive);
  EXPECT_EQ(decoded(encode(progressive)).knobs, progressive.knobs);
}

TEST(Trace, ReportsNameTheirNumbers) {
  const TraceReport report{.passes = 16,
                           .samples = 15.5,
                           .noise = 0.125,
                           .strands = 1000,
                           .end = TraceEnd::noise,
                           .grow_ms = 20,
                           .trace_ms = 300};
  const std::string text = encode(report);
  for (const std::string part : {R"("passes":16)", R"("samples":15.5)", R"("noise":0.125)", R"("strands":1000)",
                                 R"("end":"noise")", R"("grow_ms":20)", R"("trace_ms":300)"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
}

TEST(Trace, QueriesChooseTheMethod) {
  const auto strands = decode_frame_query({{"method", "strands"}, {"eye_steps", "4"}});
  ASSERT_TRUE(strands.ok()) << strands.status().message;
  EXPECT_EQ(strands->knobs.method, Method::strands);
  EXPECT_EQ(strands->knobs.eye_steps, 4);
  const auto reference = decode_frame_query({{"quality", "reference"}});
  ASSERT_TRUE(reference.ok()) << reference.status().message;
  EXPECT_EQ(reference->knobs, knobs_of(Tier::reference));
  EXPECT_EQ(decode_frame_query({{"method", "strands"}, {"scale", "1"}}).status().pointer, "/quality/scale");
  EXPECT_EQ(decode_frame_query({{"quality", "reference"}, {"method", "strands"}}).status().pointer, "/quality");
  EXPECT_EQ(decode_frame_query({{"quality", "referense"}}).status().nearest, "reference");
}

TEST(Lights, HaveASize) {
  const auto commands = decode_commands(R"({"op": "set_lights", "lights": [{}, {"kind": "area", "angle_degrees": 90,
      "radius": 10, "width": 100, "height": 0.001}]})");
  ASSERT_TRUE(commands.ok()) << commands.status().message;
  const std::vector<Light>& lights = std::get<SetLights>(commands->front()).lights;
  EXPECT_EQ(lights[0].angle_degrees, 3);
  EXPECT_EQ(lights[0].radius, 0.05);
  EXPECT_EQ(lights[0].width, 0.5);
  EXPECT_EQ(lights[0].height, 0.5);
  EXPECT_EQ(lights[1].kind, LightKind::area);
  EXPECT_EQ(lights[1].angle_degrees, 90);
  EXPECT_EQ(lights[1].radius, 10);
  EXPECT_EQ(lights[1].width, 100);
  EXPECT_EQ(lights[1].height, 0.001);
  const auto again = decode_commands(encode(commands->front()));
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(encode(again->front()), encode(commands->front()));
  EXPECT_EQ(std::get<SetLights>(again->front()).lights[1].height, 0.001);
}

TEST(Lights, RefuseSizesBeyondTheirRange) {
  struct Member {
    std::string name, value;
  };
  const std::vector<Member> members = {{"angle_degrees", "-0.1"},
                                       {"angle_degrees", "90.1"},
                                       {"radius", "-1e-9"},
                                       {"radius", "10.01"},
                                       {"width", "0"},
                                       {"width", "0.0009"},
                                       {"width", "100.1"},
                                       {"height", "0"},
                                       {"height", "100.1"},
                                       {"height", "\"1\""},
                                       {"kind", "\"rectangle\""}};
  for (const auto& [name, value] : members) {
    const Status status = lights_refusal("\"" + name + "\": " + value);
    EXPECT_EQ(status.pointer, "/lights/0/" + name) << value;
  }
  EXPECT_TRUE(lights_refusal(R"("angle_degrees": 0, "radius": 0)").ok());
}

}  // namespace
}  // namespace pelage
