// Frame requests, as bodies and as URLs.
#include <gtest/gtest.h>

#include <string>

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "tests/unit/protocol/refusals.h"

namespace pelage {
namespace {

TEST(DecodeFrame, ReadsDefaultsAndCameras) {
  const auto plain = decode_frame_request("{}");
  ASSERT_TRUE(plain.ok());
  EXPECT_EQ(plain->width, 512);
  EXPECT_EQ(plain->camera.automatic, AutoView::three_quarter);
  const auto free =
      decode_frame_request(R"({"camera": {"position": [0, 0, 2], "target": [0, 0, 0]}, "background": "transparent"})");
  ASSERT_TRUE(free.ok());
  EXPECT_EQ(free->camera.automatic, AutoView::none);
  EXPECT_EQ(free->background, Background::transparent);
  EXPECT_EQ(decode_frame_request(R"({"camera": {"position": [0, 0, 2], "target": [0, 0, 2]}})").status().pointer,
            "/camera");
  EXPECT_EQ(decode_frame_request(R"({"camera": {"position": [0, 2, 0], "target": [0, 0, 0]}})").status().pointer,
            "/camera/up");
}

TEST(DecodeFrame, TheUsualFormatIsForRequestsThatNameNone) {
  const auto format_of = [](const char* text, FrameFormat usual) { return decode_frame_request(text, usual)->format; };
  EXPECT_EQ(format_of("{}", FrameFormat::webp), FrameFormat::webp);
  EXPECT_EQ(format_of(R"({"format": "png"})", FrameFormat::webp), FrameFormat::png);
  EXPECT_EQ(decode_frame_request("{}")->format, FrameFormat::png);
  EXPECT_EQ(decode_frame_request(R"({"background": "transparent"})", FrameFormat::jpeg).status().pointer,
            "/background");
  EXPECT_EQ(decode_frame_request("[]", FrameFormat::jpeg).status().code, decode_frame_request("[]").status().code);
}

TEST(DecodeFrame, QualityIsATierOrKnobs) {
  EXPECT_EQ(decode_frame_request(R"({"quality": "draft"})")->knobs, knobs_of(Tier::draft));
  Knobs expected = knobs_of(Tier::interactive);
  expected.raster.strands = 7;
  EXPECT_EQ(decode_frame_request(R"({"quality": {"raster": {"strands": 7}}})")->knobs, expected);
  EXPECT_EQ(decode_frame_request(R"({"quality": "finest"})").status().pointer, "/quality");
  EXPECT_EQ(decode_frame_request(R"({"quality": {"method": "shells", "shells": {"count": 1025}}})").status().pointer,
            "/quality/shells/count");
  for (const std::string gone : {"bands", "samples", "accumulation"})
    EXPECT_EQ(decode_frame_request(R"({"quality": {")" + gone + R"(": 1}})").status().pointer, "/quality/" + gone);
}

TEST(DecodeFrame, RefusesSizesOutOfRange) {
  for (const char* size : {"0", "-1", "8193", "1e9", "1.5", "\"512\""}) {
    EXPECT_EQ(decode_frame_request(std::string(R"({"width": )") + size + "}").status().pointer, "/width") << size;
  }
}

TEST(DecodeFrame, FormatsTakeOnlyMembersThatFitThem) {
  const auto exr = decode_frame_request(R"({"format": "exr", "exr_type": "float", "aovs": ["depth", "beauty"]})");
  ASSERT_TRUE(exr.ok()) << exr.status().message;
  EXPECT_EQ(exr->exr_type, ExrType::single);
  EXPECT_EQ(exr->aovs, (std::vector{Aov::depth, Aov::beauty}));
  EXPECT_EQ(decode_frame_request(R"({"background": "studio"})")->background, Background::studio);
  const auto pointer_of = [](const char* text) { return decode_frame_request(text).status().pointer; };
  EXPECT_EQ(pointer_of(R"({"aovs": ["beauty"]})"), "/aovs");
  EXPECT_EQ(pointer_of(R"({"format": "exr", "aovs": []})"), "/aovs");
  EXPECT_EQ(pointer_of(R"({"format": "exr", "aovs": ["depth", "depth"]})"), "/aovs/1");
  EXPECT_EQ(pointer_of(R"({"format": "exr", "overlay": "strokes"})"), "/overlay");
  EXPECT_EQ(pointer_of(R"({"format": "jpeg", "background": "transparent"})"), "/background");
  EXPECT_EQ(pointer_of(R"({"lossy_quality": 101})"), "/lossy_quality");
  EXPECT_EQ(decode_frame_request(R"({"format": "tiff"})").status().limit,
            "png | png16 | jpeg | webp | exr | npy | npy_linear");
}

TEST(DecodeFrame, ADifferenceIsFromARevision) {
  const auto taken = decode_frame_request(R"({"overlay": "difference", "overlay_from": 18446744073709551615})");
  ASSERT_TRUE(taken.ok()) << taken.status().message;
  EXPECT_EQ(taken->overlay, Overlay::difference);
  EXPECT_EQ(taken->overlay_from, std::uint64_t{18446744073709551615u});
  for (const char* wrong :
       {R"({"overlay": "difference"})", R"({"overlay": "mask", "overlay_from": 3})", R"({"overlay_from": 3})",
        R"({"overlay": "difference", "overlay_from": -1})", R"({"overlay": "difference", "overlay_from": 1.5})"}) {
    EXPECT_EQ(decode_frame_request(wrong).status().pointer, "/overlay_from") << wrong;
  }
  EXPECT_EQ(decode_frame_query({{"overlay", "difference"}, {"overlay_from", "7"}})->overlay_from, std::uint64_t{7});
}

TEST(DecodeFrame, ReadsAnEarlierRevision) {
  const auto taken = decode_frame_request(R"({"revision": 0})");
  ASSERT_TRUE(taken.ok()) << taken.status().message;
  EXPECT_EQ(taken->revision, std::uint64_t{0});
  EXPECT_FALSE(decode_frame_request("{}")->revision);
  EXPECT_EQ(decode_frame_query({{"revision", "7"}})->revision, std::uint64_t{7});
  EXPECT_EQ(decode_frame_request(R"({"revision": -1})").status().pointer, "/revision");
  EXPECT_TRUE(decode_frame_request(R"({"revision": 3, "progressive": false, "quality": "reference"})").ok());
  EXPECT_EQ(decode_frame_request(R"({"revision": 3, "progressive": true})").status().pointer, "/progressive");
}

TEST(DecodeFrame, AovsTogetherHaveALimit) {
  const auto with = [](const char* more) {
    return decode_frame_request(
        std::string(R"({"format": "exr", "width": 8192, "height": 4096, "quality": {"scale": 1}, )") + more + "}");
  };
  EXPECT_TRUE(with(R"("aovs": ["beauty", "depth"])").ok());
  EXPECT_EQ(with(R"("aovs": ["beauty", "depth", "normal"])").status().pointer, "/aovs");
}

TEST(DecodeFrame, SortedTakesOneSampleAndHasALimit) {
  const auto pointer_of = [](const char* text) { return decode_frame_request(text).status().pointer; };
  const auto sorted = decode_frame_request(
      R"({"width": 1024, "height": 1024, "quality": {"method": "shells", "shells": {"order": "sorted", "count": 1024}}})");
  ASSERT_TRUE(sorted.ok());
  EXPECT_EQ(sorted->knobs.shells.order, FragmentOrder::sorted);
  EXPECT_EQ(decode_frame_request("{}")->knobs.shells.order, FragmentOrder::four_pass);
  EXPECT_EQ(pointer_of(R"({"quality": {"method": "shells", "shells": {"order": "depth"}}})"), "/quality/shells/order");
  EXPECT_EQ(
      pointer_of(
          R"({"width": 1025, "height": 1024, "quality": {"method": "shells", "shells": {"order": "sorted", "count": 1024}}})"),
      "/quality");
  EXPECT_EQ(
      pointer_of(
          R"({"quality": {"method": "shells", "shells": {"order": "sorted", "count": 1024}, "scale": 2.0}, "width": 1024})"),
      "/quality");
}

TEST(DecodeFrame, ScaleCountsForTheSize) {
  EXPECT_TRUE(decode_frame_request(R"({"width": 4096, "quality": "detailed"})").ok());
  EXPECT_EQ(decode_frame_request(R"({"width": 4097, "quality": "detailed"})").status().pointer, "/quality");
  EXPECT_TRUE(decode_frame_request(R"({"height": 8192, "quality": {"scale": 1}})").ok());
  EXPECT_EQ(decode_frame_request(R"({"height": 8192, "quality": {"scale": 1.5}})").status().pointer, "/quality");
}

TEST(Query, ReadsHowStrandsAreTraced) {
  const auto tracing = decode_tracing_query({{"passes", "9"},
                                             {"transport", "paths"},
                                             {"bounces", "3"},
                                             {"noise", "0.01"},
                                             {"seconds", "2.5"},
                                             {"strands", "1000"},
                                             {"filter", "false"},
                                             {"seed", "7"}});
  ASSERT_TRUE(tracing.ok()) << tracing.status().message;
  EXPECT_EQ(*tracing, (Tracing{.passes = 9,
                               .transport = Transport::paths,
                               .scattering = StrandScattering::energy_conserving,
                               .bounces = 3,
                               .strands = 1000,
                               .noise = 0.01,
                               .seconds = 2.5,
                               .filter = false,
                               .seed = 7}));
  EXPECT_EQ(*decode_tracing_query({}), Tracing{});
  EXPECT_EQ(decode_tracing_query({{"passes", "0"}}).status().pointer, "/passes");
  EXPECT_EQ(decode_tracing_query({{"bounces", "3"}}).status().pointer, "/bounces");
  EXPECT_EQ(decode_tracing_query({{"pases", "3"}}).status().nearest, "passes");
}

TEST(DecodeFrame, NumbersOfAnAddressAreWrittenAsPeopleDo) {
  const auto scale_of = [](const char* text) { return decode_frame_query({{"scale", text}})->knobs.scale; };
  EXPECT_EQ(scale_of(".5"), 0.5);
  EXPECT_EQ(scale_of("+.5"), 0.5);
  EXPECT_EQ(scale_of("1."), 1);
  EXPECT_EQ(scale_of("+1"), 1);
  EXPECT_EQ(scale_of(".05e1"), 0.5);
  EXPECT_EQ(decode_frame_query({{"exposure", "-.5"}})->exposure, -0.5);
  EXPECT_EQ(decode_frame_query({{"width", "9."}})->width, 9);
  EXPECT_EQ(decode_tracing_query({{"noise", ".01"}})->noise, 0.01);
  const auto free = decode_frame_query({{"position", ".5,+1, -.25"}, {"target", "0.,0,0"}});
  ASSERT_TRUE(free.ok()) << free.status().message;
  EXPECT_EQ(free->camera.position, glm::dvec3(0.5, 1, -0.25));
  for (const char* wrong : {".", "+", "-", "+-1", "1..", ".5.", "..5", "+ 1", "1.e3", "--1", "", "5.x", "007"})
    EXPECT_EQ(decode_frame_query({{"scale", wrong}}).status().pointer, "/quality/scale") << wrong;
  for (const char* wrong : {"1,2,3,", ",1,2", "1,,2", "1,2,.", ""})
    EXPECT_EQ(decode_frame_query({{"position", wrong}, {"target", "0,0,0"}}).status().pointer, "/camera/position")
        << wrong;
}

TEST(DecodeFrameQuery, SaysWhatTheBodySays) {
  const auto request = decode_frame_query({{"width", "64"},
                                           {"height", "32"},
                                           {"camera", "front"},
                                           {"method", "raster"},
                                           {"eye_steps", "9"},
                                           {"scale", "0.5"},
                                           {"background", "#ff0000"},
                                           {"exposure", "-1.5"}});
  ASSERT_TRUE(request.ok()) << request.status().message;
  EXPECT_EQ(request->width, 64);
  EXPECT_EQ(request->camera.automatic, AutoView::front);
  EXPECT_EQ(request->knobs.method, Method::raster);
  EXPECT_EQ(request->knobs.eye_steps, 9);
  EXPECT_EQ(request->knobs.scale, 0.5);
  EXPECT_FLOAT_EQ(request->background_colour.r, 1);
  EXPECT_DOUBLE_EQ(request->exposure, -1.5);
  const auto free = decode_frame_query({{"position", "0,0.5,2"}, {"target", "0, 0, 0"}, {"fov_degrees", "50"}});
  ASSERT_TRUE(free.ok()) << free.status().message;
  EXPECT_EQ(free->camera.position, glm::dvec3(0, 0.5, 2));
}

TEST(DecodeFrameQuery, RefusesBadParametersWithTheirPointer) {
  const auto pointer_of = [](const Query& query) { return decode_frame_query(query).status().pointer; };
  EXPECT_EQ(pointer_of({{"width", "0"}}), "/width");
  EXPECT_EQ(pointer_of({{"width", "64,\"x\":1"}}), "/width");
  EXPECT_EQ(pointer_of({{"width", "1e400"}}), "/width");
  EXPECT_EQ(pointer_of({{"width", "nan"}}), "/width");
  EXPECT_EQ(pointer_of({{"position", std::string(8000, '[')}, {"target", "0,0,0"}}), "/camera/position");
  EXPECT_EQ(pointer_of({{"position", "0,0"}, {"target", "0,0,0"}}), "/camera/position");
  EXPECT_EQ(pointer_of({{"quality", "draft"}, {"scale", "1"}}), "/quality");
  EXPECT_EQ(pointer_of({{"scale", "1"}, {"quality", "draft"}}), "/quality");
  EXPECT_EQ(pointer_of({{"width", "9"}, {"width", "9"}}), "/width");
  EXPECT_EQ(decode_frame_query({{"widht", "9"}}).status().nearest, "width");
  EXPECT_EQ(decode_frame_query({{"\xff", "9"}}).status().code, Code::invalid);
  EXPECT_EQ(pointer_of({{"view", "\xff"}}), "/view");
}

TEST(DecodeFrame, ACropLiesInsideTheFrame) {
  const auto request =
      decode_frame_request(R"({"width": 100, "height": 80, "crop": {"left": 60, "width": 40, "height": 80}})");
  ASSERT_TRUE(request.ok()) << request.status().message;
  EXPECT_EQ(request->crop, (Crop{60, 0, 40, 80}));
  EXPECT_DOUBLE_EQ(request->drawn_share(), 0.4);
  EXPECT_EQ(decode_frame_request(encode(*request))->crop, request->crop);
  EXPECT_EQ(decode_frame_query({{"width", "100"}, {"height", "80"}, {"crop", "60,0, 40,80"}})->crop, request->crop);
  for (const char* crop : {R"({"left": 61, "width": 40, "height": 80})", R"({"top": 1, "width": 40, "height": 80})"}) {
    const auto refused = decode_frame_request(std::string(R"({"width": 100, "height": 80, "crop": )") + crop + "}");
    EXPECT_EQ(refused.status().pointer, "/crop") << crop;
    EXPECT_NE(refused.status().limit.find("at most 100"), std::string::npos) << refused.status().limit;
  }
  EXPECT_EQ(decode_frame_request(R"({"crop": {"width": 0, "height": 8}})").status().pointer, "/crop/width");
  EXPECT_EQ(decode_frame_request(R"({"crop": {"width": 8}})").status().pointer, "/crop/height");
  for (const char* text : {"1,2,3", "a", "1,2,3,4,5", ""})
    EXPECT_EQ(decode_frame_query({{"crop", text}}).status().pointer, "/crop") << text;
}

}  // namespace
}  // namespace pelage
