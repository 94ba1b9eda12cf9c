// What is encoded decodes to the same thing, bit for bit. Equality is compared on the encoded text, which has every
// field with all its digits; a second test shows that different commands have different texts.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "protocol/json/colour.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "tests/property/json/generators.h"

namespace pelage::testing {
namespace {

RC_GTEST_PROP(Json, CommandsComeBack, ()) {
  const Command before = command();
  const std::string text = encode(before);
  const auto after = decode_commands(text);
  if (!after.ok()) RC_FAIL(after.status().message + " " + after.status().pointer + " " + text);
  RC_ASSERT(after->size() == 1u);
  RC_ASSERT(after->front().index() == before.index());
  RC_ASSERT(encode(*after) == text);
}

RC_GTEST_PROP(Json, BatchesComeBack, ()) {
  std::vector<Command> before;
  const int count = *rc::gen::inRange(1, 4);
  for (int i = 0; i < count; ++i) before.push_back(command());
  const auto after = decode_commands(encode(before));
  RC_ASSERT(after.ok());
  RC_ASSERT(encode(*after) == encode(before));
}

RC_GTEST_PROP(Json, NumbersKeepEveryBit, ()) {
  const Comb before{.stroke = {},
                    .flood = true,
                    .brush = {.radius = number(0, 1e27), .strength = number(0, 1)},
                    .lean = number(0, 1),
                    .direction = direction()};
  const Comb after = std::get<Comb>(decode_commands(encode(Command(before)))->front());
  RC_ASSERT(after.brush.radius == before.brush.radius);
  RC_ASSERT(after.brush.strength == before.brush.strength);
  RC_ASSERT(after.lean == before.lean);
  RC_ASSERT(*after.direction == *before.direction);
}

RC_GTEST_PROP(Json, ColoursKeepEveryBit, ()) {
  const glm::vec3 before = colour();
  Look look;
  look.skin = before;
  const glm::vec3 after = std::get<SetLook>(decode_commands(encode(Command(SetLook{look})))->front()).look.skin;
  RC_ASSERT(after == before);
}

RC_GTEST_PROP(Json, CoatsKeepEveryBit, ()) {
  const Coat before = std::get<SetCoat>(set_coat()).coat;
  const Coat after = std::get<SetCoat>(decode_commands(encode(Command(SetCoat{before})))->front()).coat;
  RC_ASSERT(after == before);
}

RC_GTEST_PROP(Json, EnvironmentsKeepEveryBit, ()) {
  const Environment before = std::get<SetEnvironment>(set_environment()).environment;
  const auto decoded = decode_commands(encode(Command(SetEnvironment{before})));
  const Environment after = std::get<SetEnvironment>(decoded->front()).environment;
  RC_ASSERT(after.harmonics == before.harmonics);
  RC_ASSERT(after.turn_degrees == before.turn_degrees && after.intensity == before.intensity);
  RC_ASSERT(after.sky == before.sky && after.horizon == before.horizon && after.ground == before.ground);
}

RC_GTEST_PROP(Json, PicturesOfModelsComeBack, ()) {
  const Command before = set_skin_texture();
  const auto after = decode_commands(encode(before));
  RC_ASSERT(after.ok());
  RC_ASSERT(std::get<SetSkinTexture>(after->front()).picture == std::get<SetSkinTexture>(before).picture);
}

RC_GTEST_PROP(Json, NewScenesComeBack, ()) {
  const NewScene before = new_scene();
  const auto after = decode_new_scene(encode(before));
  if (!after.ok()) RC_FAIL(after.status().message + " " + after.status().pointer);
  RC_ASSERT(encode(*after) == encode(before));
  RC_ASSERT(after->fur_patches == before.fur_patches && after->model.shape == before.model.shape);
  RC_ASSERT(after->fur.length == before.fur.length && after->model.triangles == before.model.triangles);
}

RC_GTEST_PROP(Json, FrameRequestsComeBack, ()) {
  const FrameRequest before = frame_request();
  const auto after = decode_frame_request(encode(before));
  if (!after.ok()) RC_FAIL(after.status().message + " " + after.status().pointer);
  RC_ASSERT(after->knobs == before.knobs);
  RC_ASSERT(encode(*after) == encode(before));
  RC_ASSERT(after->format == before.format && after->overlay == before.overlay);
  RC_ASSERT(after->revision == before.revision && after->crop == before.crop);
  RC_ASSERT(after->overlay_from == before.overlay_from && after->progressive == before.progressive);
  RC_ASSERT(after->background == before.background && after->exr_type == before.exr_type);
}

RC_GTEST_PROP(Json, BranchesComeBack, ()) {
  const BranchRequest before = branch_request();
  const auto after = decode_branch(encode(before));
  RC_ASSERT(after.ok());
  RC_ASSERT(after->name == before.name && after->revision == before.revision);
}

RC_GTEST_PROP(Json, AmendmentsComeBack, ()) {
  const AmendRequest before = amend_request();
  const auto after = decode_amend(encode(before));
  if (!after.ok()) RC_FAIL(after.status().message + " " + after.status().pointer);
  RC_ASSERT(after->revision == before.revision && after->commands.size() == before.commands.size());
  RC_ASSERT(encode(*after) == encode(before));
}

RC_GTEST_PROP(Json, AnyBytesGiveACommandOrARefusal, (const std::string& bytes)) {
  const auto decoded = decode_commands(bytes);
  const bool sound = decoded.ok() || !decoded.status().message.empty();  // RC_ASSERT would evaluate both sides of ||
  RC_ASSERT(sound);
}

RC_GTEST_PROP(Json, BrokenCommandsGiveACommandOrARefusal, ()) {
  std::string text = encode(command());
  const auto where = *rc::gen::inRange<std::size_t>(0, text.size());
  text[where] = *rc::gen::arbitrary<char>();
  const auto decoded = decode_commands(text);
  const bool sound = decoded.ok() || !decoded.status().message.empty();  // RC_ASSERT would evaluate both sides of ||
  RC_ASSERT(sound);
}

}  // namespace
}  // namespace pelage::testing
