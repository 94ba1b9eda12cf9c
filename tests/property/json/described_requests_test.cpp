// Requests have exactly the members of their schemas.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "tests/property/json/generators.h"
#include "tests/property/json/hand_over.h"

namespace pelage::testing {
namespace {

/// Returns whether the decoder refuses a member that the schema does not have.
template <class Decode>
bool refuses_more(Decode decode, const std::string& document) {
  nlohmann::json more = nlohmann::json::parse(document);
  more["undescribed"] = 1;
  return !decode(more.dump()).ok();
}

RC_GTEST_PROP(DescribedRequests, TakeTheMembersOfTheSchemaAndNoOthers, ()) {
  const std::string one = encode(command()), frame = encode(frame_request()), scene = encode(new_scene());
  const std::string branch = encode(branch_request()), amend = encode(amend_request());
  hand_over("Command", one), hand_over("FrameRequest", frame), hand_over("NewScene", scene);
  hand_over("BranchRequest", branch), hand_over("AmendRequest", amend);
  RC_ASSERT(refuses_more([](const std::string& text) { return decode_commands(text); }, one));
  RC_ASSERT(refuses_more([](const std::string& text) { return decode_frame_request(text); }, frame));
  RC_ASSERT(refuses_more([](const std::string& text) { return decode_new_scene(text); }, scene));
  RC_ASSERT(refuses_more([](const std::string& text) { return decode_branch(text); }, branch));
  RC_ASSERT(refuses_more([](const std::string& text) { return decode_amend(text); }, amend));
}

}  // namespace
}  // namespace pelage::testing
