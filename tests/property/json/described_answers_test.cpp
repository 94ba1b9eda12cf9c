// Answers have the members of their schemas, and decode to the same values, bit for bit.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "tests/property/json/generators.h"
#include "tests/property/json/hand_over.h"

namespace pelage::testing {
namespace {

template <class T>
void expect_back(const char* schema) {
  const T before = answer<T>();
  const std::string text = encode(before);
  hand_over(schema, text);
  const Result<T> after = decode_answer<T>(text);
  if (!after.ok()) RC_FAIL(after.status().message + " " + after.status().pointer + " " + text);
  if (!(*after == before)) RC_FAIL(encode(*after) + "\nis not\n" + text);
  nlohmann::json newer = nlohmann::json::parse(text);
  newer["new"] = 1;  // as from a newer server
  const Result<T> known = decode_answer<T>(newer.dump());
  RC_ASSERT(known.ok());
  RC_ASSERT(*known == before);
}

RC_GTEST_PROP(DescribedAnswers, OfScenesComeBack, ()) {
  expect_back<SceneSummary>("Scene"), expect_back<SceneList>("SceneList"), expect_back<Log>("Log");
  expect_back<SceneEvent>("SceneEvent"), expect_back<ChangeEvent>("ChangeEvent");
  expect_back<CommandAnswer>("CommandAnswer"), expect_back<Comparison>("Comparison");
  expect_back<PickAnswer>("Pick"), expect_back<Problem>("Problem");
}

RC_GTEST_PROP(DescribedAnswers, OfPicturesComeBack, ()) {
  expect_back<FrameEstimate>("FrameEstimate"), expect_back<FrameCounters>("FrameCounters");
  expect_back<FrameCost>("FrameCost"), expect_back<ExportAnswer>("ExportAbout"),
      expect_back<FrameProgressList>("FrameProgressList");
  expect_back<TraceReport>("TraceReport"), expect_back<MapAnswer>("MapAbout");
  expect_back<PictureAnswer>("StoredPicture");
}

/// Compared as text, which keeps every bit.
RC_GTEST_PROP(DescribedAnswers, SettingsComeBack, ()) {
  const std::string text = encode(answer<SettingsAnswer>());
  hand_over("Settings", text);
  const auto after = decode_answer<SettingsAnswer>(text);
  if (!after.ok()) RC_FAIL(after.status().message + " " + after.status().pointer + " " + text);
  RC_ASSERT(encode(*after) == text);
}

/// Every member must be present and of the right kind, except sparse ones.
RC_GTEST_PROP(DescribedAnswers, WhatIsMissingIsNamed, ()) {
  nlohmann::json broken = nlohmann::json::parse(encode(answer<SceneSummary>()));
  const auto at = *rc::gen::inRange<std::size_t>(0, broken.size());
  const std::string name = std::next(broken.begin(), static_cast<std::ptrdiff_t>(at)).key();
  RC_PRE(name != "metres_per_unit" && name != "carried");  // they are sparse
  if (*rc::gen::arbitrary<bool>())
    broken.erase(name);
  else
    broken[name] = nullptr;
  const Result<SceneSummary> refused = decode_answer<SceneSummary>(broken.dump());
  RC_ASSERT(!refused.ok());
  RC_ASSERT(refused.status().code == Code::malformed);
  RC_ASSERT(refused.status().pointer == "/" + name);
}

}  // namespace
}  // namespace pelage::testing
