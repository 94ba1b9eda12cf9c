// Keyframes animate any parameter over frames, within the contract.
#include "protocol/json/animation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage::testing {
namespace {

Result<Animation> animate(const std::string& keyframes, const std::string& more = "") {
  const auto job = decode_job(R"({"builtin": {}, "output": "#.png", "frame": {"camera": {"auto": "left"}})" + more +
                              ", \"keyframes\": " + keyframes + "}");
  EXPECT_TRUE(job.ok()) << job.status().message << job.status().pointer;
  return job ? Animation::create(*job, SceneSettings()) : Result<Animation>(job.status());
}

std::string keys_of(const std::string& parameter, const std::string& keys,
                    const std::string& interpolation = "linear") {
  return R"([{"parameter": ")" + parameter + R"(", "interpolation": ")" + interpolation + R"(", "keys": [)" + keys +
         "]}]";
}

AnimatedFrame frame_of(const Result<Animation>& animation, double frame) {
  EXPECT_TRUE(animation.ok()) << animation.status().message << animation.status().pointer;
  const auto at = animation->at(frame);
  EXPECT_TRUE(at.ok()) << at.status().message << at.status().pointer;
  return at ? *at : AnimatedFrame{};
}

TEST(Keyframes, GoStraightOrStepOrAlongACurve) {
  const std::string keys = R"({"frame": 1, "value": 0}, {"frame": 5, "value": 4}, {"frame": 9, "value": 4})";
  const auto exposure = [&](const char* how, double frame) {
    return frame_of(animate(keys_of("/frame/exposure", keys, how)), frame).request.exposure;
  };
  for (const char* how : {"step", "linear", "spline"}) {
    EXPECT_EQ(exposure(how, -3), 0) << how;
    EXPECT_EQ(exposure(how, 1), 0) << how;
    EXPECT_EQ(exposure(how, 5), 4) << how;
    EXPECT_EQ(exposure(how, 99), 4) << how;
  }
  EXPECT_EQ(exposure("step", 4.9), 0);
  EXPECT_DOUBLE_EQ(exposure("linear", 2), 1);
  EXPECT_NEAR(exposure("spline", 3), 2, 1e-9);  // starts and ends at rest
  EXPECT_LT(exposure("spline", 2), 1);
  EXPECT_EQ(exposure("spline", 7), 4);  // flat between equal keys, without overshoot
}

TEST(Tiles, AreTakenWhereTheWholeFrameIsTooLarge) {
  const auto frame_in = [](const std::string& tiles) {
    const auto job = decode_job(R"({"builtin": {}, "output": "#.png",
        "frame": {"width": 4096, "height": 2160, "quality":
        {"method": "shells", "shells": {"count": 200, "order": "sorted"}}})" +
                                tiles + "}");
    EXPECT_TRUE(job.ok()) << job.status().message;
    return Animation::create(*job, SceneSettings())->at(1);
  };
  const auto whole = frame_in("");
  ASSERT_FALSE(whole.ok());
  EXPECT_EQ(whole.status().pointer, "/frame/quality");
  EXPECT_NE(whole.status().limit.find("tiles"), std::string::npos) << whole.status().limit;
  const auto cut = frame_in(R"(, "tiles": {"columns": 2})");
  ASSERT_TRUE(cut.ok()) << cut.status().message;
  EXPECT_EQ(cut->request.width, 4096);
  EXPECT_EQ(cut->request.crop, std::nullopt);
}

TEST(Keyframes, OfWholeNumbersAreWholeBetweenFrames) {
  const std::string keys = R"({"frame": 1, "value": 4}, {"frame": 5, "value": 6})";
  const auto job = decode_job(
      R"({"builtin": {}, "output": "#.png", "frame": {"quality": {"method": "shells", "shells": {"count": 4}}}, "keyframes": )" +
      keys_of("/frame/quality/shells/count", keys) + "}");
  const auto shells = Animation::create(*job, SceneSettings());
  EXPECT_EQ(frame_of(shells, 2.5).request.knobs.shells.count, 5);
  EXPECT_EQ(frame_of(shells, 1.25).request.knobs.shells.count, 4);
  EXPECT_EQ(frame_of(animate(keys_of("/frame/width", R"({"frame": 1, "value": 1}, {"frame": 2, "value": 8192})")), 1.5)
                .request.width,
            4097);
  EXPECT_DOUBLE_EQ(frame_of(animate(keys_of("/frame/exposure", keys)), 2).request.exposure, 4.5);
  const auto coat =
      frame_of(animate(keys_of("/coats/0/coat/count", R"({"frame": 1, "value": 10}, {"frame": 4, "value": 20})")), 1.5);
  EXPECT_EQ(std::get<SetCoats>(coat.settings[0]).coats[0].coat->count, 12);
}

TEST(Keyframes, SplinesStayBetweenTheirKeysWhereverTheyTurn) {
  std::string keys;
  for (int k = 0; k < 40; ++k)
    keys += (k ? ", " : "") + std::string("{\"frame\": ") + std::to_string(k * k) +
            ", \"value\": " + std::to_string(9 * std::sin(k * 1.7) * (k % 3)) + "}";
  const auto animation = animate(keys_of("/frame/exposure", keys, "spline"));
  for (int k = 0; k + 1 < 40; ++k) {
    const double left = frame_of(animation, k * k).request.exposure;
    const double right = frame_of(animation, (k + 1) * (k + 1)).request.exposure;
    for (double t = 0.125; t < 1; t += 0.125) {
      const double between = frame_of(animation, k * k + t * (2 * k + 1)).request.exposure;
      EXPECT_GE(between, std::min(left, right));
      EXPECT_LE(between, std::max(left, right));
    }
  }
}

TEST(Keyframes, ChangeSettingsByTheirCommands) {
  const auto light =
      frame_of(animate(keys_of("/lights/0/intensity", R"({"frame": 0, "value": 1}, {"frame": 4, "value": 3})")), 1);
  ASSERT_EQ(light.settings.size(), 1u);
  EXPECT_DOUBLE_EQ(std::get<SetLights>(light.settings[0]).lights[0].intensity, 1.5);
  const auto coat =
      frame_of(animate(keys_of("/coats/0/coat/bend", R"({"frame": 0, "value": 0.1}, {"frame": 4, "value": 0.5})")), 2);
  EXPECT_NEAR(std::get<SetCoats>(coat.settings[0]).coats[0].coat->bend, 0.3, 1e-7);
  const auto colour = frame_of(
      animate(keys_of("/lights/0/colour", R"({"frame": 0, "value": "#000000"}, {"frame": 4, "value": "#ffffff"})")), 2);
  EXPECT_NEAR(std::get<SetLights>(colour.settings[0]).lights[0].colour.r, 0.5, 1e-6);  // interpolated in linear light
  const auto word =
      frame_of(animate(keys_of("/frame/camera/auto", R"({"frame": 0, "value": "left"}, {"frame": 4, "value": "right"})",
                               "step")),
               4);
  EXPECT_EQ(word.request.camera.automatic, AutoView::right);
}

void expect_refusal(const std::string& keyframes, const std::string& pointer, const std::string& more = "") {
  const auto animation = animate(keyframes, more);
  ASSERT_FALSE(animation.ok()) << keyframes;
  EXPECT_EQ(animation.status().pointer, pointer) << keyframes;
}

TEST(Keyframes, OfWhatIsNotThereAreRefused) {
  const std::string keys = R"({"frame": 0, "value": 1})";
  expect_refusal(keys_of("/lihgts/0/intensity", keys), "/keyframes/0/parameter");
  EXPECT_EQ(animate(keys_of("/lihgts/0/intensity", keys)).status().nearest, "lights");
  expect_refusal(keys_of("/lights/99/intensity", keys), "/keyframes/0/parameter");
  expect_refusal(keys_of("/lights/0/intensitie", keys), "/keyframes/0/parameter");
  expect_refusal(keys_of("lights", keys), "/keyframes/0/parameter");
  expect_refusal(keys_of("/frame", keys), "/keyframes/0/parameter");
  expect_refusal(keys_of("/frame/~9", keys), "/keyframes/0/parameter");
  expect_refusal(keys_of("/lights/0/intensity", keys), "/keyframes/0/parameter", R"(, "time_lapse": true)");
  for (const char* value : {"true", "\"left\"", "[]", "[1, 2]", "[1, \"a\"]"})
    expect_refusal(keys_of("/frame/exposure", keys + R"(, {"frame": 2, "value": )" + value + "}"),
                   "/keyframes/0/keys/1/value");
}

TEST(Keyframes, KeepToTheLimitsOfTheContract) {
  const auto animation = animate(keys_of("/frame/exposure", R"({"frame": 0, "value": 0}, {"frame": 10, "value": 40})"));
  EXPECT_TRUE(animation->at(5).ok());
  const auto refused = animation->at(6);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().pointer, "/frame/exposure");
  EXPECT_NE(refused.status().message.find("At frame 6"), std::string::npos) << refused.status().message;
  const auto light = animate(keys_of("/lights/0/intensity", R"({"frame": 0, "value": -1})"))->at(0);
  ASSERT_FALSE(light.ok());
  EXPECT_EQ(light.status().pointer, "/lights/0/intensity");
  const auto width =
      Animation::create(*decode_job(R"({"builtin": {}, "output": "#.png", "frame": {"width": 0}})"), {})->at(3);
  ASSERT_FALSE(width.ok());
  EXPECT_EQ(width.status().pointer, "/frame/width");
  EXPECT_EQ(width.status().message.find("At frame"), std::string::npos);  // it has no keyframe
  const auto unknown = animate(keys_of("/frame/exposurre", R"({"frame": 0, "value": 1})"))->at(0);
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.status().nearest, "exposure");
}

TEST(Jobs, AreRefusedWithThePositionInTheirFile) {
  const auto pointer = [](const std::string& text) {
    const auto job = decode_job(text);
    return job ? "none" : job.status().pointer;
  };
  EXPECT_EQ(pointer(R"({"scene": "a.pelage", "output": "#.png"})"), "none");
  EXPECT_EQ(pointer(R"({"scene": "a.pelage"})"), "/output");
  EXPECT_EQ(pointer(R"({"output": "#.png"})"), "/scene");
  EXPECT_EQ(pointer(R"({"scene": "a", "builtin": {}, "output": "#.png"})"), "/scene");
  EXPECT_EQ(pointer(R"({"scene": "a", "output": "#.png", "turntable": {"degree": 1}})"), "/turntable/degree");
  EXPECT_EQ(pointer(R"({"scene": "a", "output": "#.png", "keyframes": [{"parameter": "/frame/exposure",
                     "keys": [{"frame": 2, "value": 1}, {"frame": 2, "value": 1}]}]})"),
            "/keyframes/0/keys/1/frame");
}

}  // namespace
}  // namespace pelage::testing
