#include "protocol/json/encode.h"

#include <gtest/gtest.h>

#include <limits>

#include "protocol/json/colour.h"
#include "protocol/json/decode.h"

namespace pelage {
namespace {

SceneSummary some_summary() {
  SceneSummary summary{.id = "a1",
                       .name = "fox \"x\"",
                       .revision = 12,
                       .model = "obj",
                       .report = {},
                       .fields_hash = {.low = 5, .high = 7},
                       .undo_steps = 3,
                       .redo_steps = 1,
                       .coats = {{.name = "fur", .id = 0, .muted = false}, {.name = "mane", .id = 3, .muted = true}}};
  summary.report = {.source_vertices = 9,
                    .source_faces = 8,
                    .vertices = 7,
                    .triangles = 6,
                    .parts = 2,
                    .size = 155.5,
                    .bounds = {{-1, -2, -3}, {1, 2, 3}},
                    .repairs = {{"welded_vertices", 2}}};
  return summary;
}

TEST(Encode, CommandAnswerComesBack) {
  const CommandAnswer answer{.revision = 12,
                             .fields_hash = {.low = 0xfedcba9876543210, .high = 1},
                             .results = {{.op = "comb",
                                          .touched = 812,
                                          .mean_change = 0.11,
                                          .max_change = 0.64,
                                          .clamped = 3,
                                          .milliseconds = 1.25,
                                          .fields = {{"direction", 812, 0.11, 0.64}}}}};
  const auto back = decode_answer<CommandAnswer>(encode(answer));
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->fields_hash, answer.fields_hash);
  EXPECT_EQ(back->results[0].touched, 812u);
  EXPECT_EQ(encode(*back), encode(answer));
}

TEST(Encode, SummariesComeBack) {
  EXPECT_EQ(encode(*decode_answer<SceneSummary>(encode(some_summary()))), encode(some_summary()));
  const SceneList list{{some_summary(), some_summary()}};
  EXPECT_EQ(decode_answer<SceneList>(encode(list))->scenes.size(), 2u);
  EXPECT_EQ(encode(SceneList{}), R"({"scenes":[]})");
}

TEST(Encode, PicksComeBack) {
  EXPECT_EQ(encode(PickAnswer{}), R"({"hit":false})");
  const PickAnswer answer{
      .hit = true,
      .strand = PickedStrand{.id = 12, .kind = StrandKind::curve, .along = 0.5, .root = {1, 2, 2.9}},
      .triangle = 7,
      .barycentric = {0.2, 0.3, 0.5},
      .position = {1, 2, 3},
      .normal = {0, 1, 0},
      .direction = {0, 0, -1},
      .inclination = 0.5,
      .length = 0.03,
      .stretch = 0.1,
      .painted = {{{0.25, 0, 0, 0}, {2, 0, 0, 0}, {}, {}, {0.75, 0, 0, 0}, {}, {}, {0.1, 0.2, 0.3, 0.4}}}};
  EXPECT_NE(encode(answer).find(R"("root_colour":[0.1,0.2,0.3,0.4])"), std::string::npos);
  EXPECT_NE(encode(answer).find(R"("density":0.25)"), std::string::npos);
  EXPECT_EQ(encode(*decode_answer<PickAnswer>(encode(answer))), encode(answer));
}

TEST(Encode, LogHoldsCommandsAsJson) {
  const std::string text = encode(Log{
      {{.revision = 1, .kind = "do", .commands = R"({"op":"comb"})", .touched = 5, .in_effect = true, .author = "Ann"},
       {.revision = 2, .kind = "undo", .commands = "", .touched = 5}}});
  EXPECT_EQ(
      text,
      R"({"entries":[{"revision":1,"kind":"do","step":0,"touched":5,"in_effect":true,"author":"Ann","commands":{"op":"comb"}},)"
      R"({"revision":2,"kind":"undo","step":0,"touched":5,"in_effect":false,"author":""}]})");
  EXPECT_EQ(encode(*decode_answer<Log>(text)), text);
}

TEST(Encode, TraceReportsComeBack) {
  const TraceReport report{.passes = 12,
                           .samples = 11.5,
                           .noise = 0.02,
                           .strands = 400'000,
                           .end = TraceEnd::noise,
                           .grow_ms = 700,
                           .trace_ms = 1500.5};
  const auto read = decode_answer<TraceReport>(encode(report));
  ASSERT_TRUE(read.ok()) << read.status().message;
  EXPECT_EQ(encode(*read), encode(report));
  EXPECT_EQ(read->end, TraceEnd::noise);
  EXPECT_EQ(decode_answer<TraceReport>("{}").status().code, Code::malformed);
}

TEST(Encode, NoiseThatIsNotKnownYetIsTheLargest) {
  TraceReport report;
  report.noise = std::numeric_limits<double>::infinity();
  EXPECT_EQ(decode_answer<TraceReport>(encode(report))->noise, 1);
}

TEST(Encode, ProblemsNameFieldAndLimit) {
  const Status status = failure(Code::invalid, "2 is out of range.", "/brush/strength", "[0, 1]", "");
  EXPECT_EQ(encode_problem(status, 422),
            R"({"type":"urn:pelage:problem:invalid","title":"The request breaks the contract","status":422,)"
            R"("detail":"2 is out of range.","pointer":"/brush/strength","limit":"[0, 1]"})");
  const Status back = decode_problem(encode_problem(status, 422));
  EXPECT_EQ(back.code, Code::invalid);
  EXPECT_EQ(back.pointer, "/brush/strength");
  EXPECT_EQ(decode_problem("<html>").code, Code::malformed);
  EXPECT_EQ(decode_problem("{}").code, Code::malformed);
}

TEST(Encode, ProblemsSurviveTextThatIsNotUtf8) {
  EXPECT_NE(encode_problem(failure(Code::not_found, "no \xff"), 404).find("no "), std::string::npos);
}

TEST(Colour, AllLevelsComeBack) {
  for (int level = 0; level < 256; ++level) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", static_cast<unsigned>(level), 255u - static_cast<unsigned>(level),
                  7u);
    const auto colour = colour_of_text(text);
    ASSERT_TRUE(colour);
    EXPECT_EQ(text_of_colour(*colour), text);
  }
  EXPECT_FALSE(text_of_colour(glm::vec3(0.1f)));
  EXPECT_FALSE(colour_of_text("#12345"));
  EXPECT_FALSE(colour_of_text("#12345g"));
  EXPECT_FALSE(colour_of_text("123456#"));
}

}  // namespace
}  // namespace pelage
