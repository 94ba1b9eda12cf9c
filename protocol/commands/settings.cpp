#include "protocol/commands/settings.h"

namespace pelage {

SceneSettings::SceneSettings() = default;
SceneSettings::SceneSettings(const SceneSettings&) = default;
SceneSettings::SceneSettings(SceneSettings&&) noexcept = default;
SceneSettings& SceneSettings::operator=(const SceneSettings&) = default;
SceneSettings& SceneSettings::operator=(SceneSettings&&) noexcept = default;
SceneSettings::~SceneSettings() = default;

}  // namespace pelage
