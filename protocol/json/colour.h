// Colours on the wire: "#rrggbb" in sRGB, linear inside.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace pelage {

/// Converts "#rrggbb" to linear; returns nullopt for any other text.
std::optional<glm::vec3> colour_of_text(std::string_view text);

/// Returns the "#rrggbb" that decodes to exactly this colour, if there is one.
std::optional<std::string> text_of_colour(glm::vec3 linear);

}  // namespace pelage
