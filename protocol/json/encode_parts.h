// Blocks that several documents share, as JSON; decode_parts.h reads them.
#pragma once

#include <nlohmann/json.hpp>

#include "protocol/commands/command.h"
#include "protocol/commands/frame.h"

namespace pelage::json_parts {

/// Keeps members in the order in which they are written.
using Json = nlohmann::ordered_json;

Json list(glm::dvec2 v);
Json list(glm::dvec3 v);
Json list(const std::vector<FrameLayer>& layers);
Json colour(glm::vec3 linear);
Json json_of(const Camera& camera);
Json json_of(const View& view);
Json json_of(const Stroke& stroke);
Json json_of(const Brush& brush);
Json json_of(const Coat& coat);
Json json_of(const Look& look);
Json json_of(const Light& light);
Json json_of(const Environment& environment);
Json json_of(const Ground& ground);
Json json_of(const Eye& eye);
Json json_of(const CurveGroup& group);
Json json_of(const SkinRegion& region);

}  // namespace pelage::json_parts
