// Reads the JSON of a row as the server does.
#pragma once

#include <memory>

#include "protocol/commands/frame.h"
#include "server/scene/scene_store.h"
#include "tests/extremes/row.h"

namespace pelage::testing {

/// Makes the scene of a row, or returns the first refusal on the way to it.
Result<std::shared_ptr<Scene>> scene_of(const Row& row, SceneStore& store);
/// Runs the commands of a text in a scene.
Status carry_out(const std::string& text, Scene& scene, const SceneStore& store);
Result<FrameRequest> request_of(const Row& row);

}  // namespace pelage::testing
