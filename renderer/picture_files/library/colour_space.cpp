// Colour spaces of an OpenColorIO configuration, through OpenImageIO.
#include <OpenImageIO/color.h>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "renderer/picture_files/library/members.h"

namespace pelage {

namespace {

/// Every configuration that supports interchange names its ACES2065-1 space by this role (OpenColorIO 2).
constexpr const char* exchange_role = "aces_interchange";

/// The matrix from linear Rec. 709 to ACES2065-1, with Bradford adaptation from D65 to the ACES white (SMPTE ST
/// 2065-1). Columns.
constexpr glm::mat3 exchange_from_linear{0.4396329819f, 0.0897764431f, 0.0175411704f,  //
                                         0.3829886981f, 0.8134394286f, 0.1115465500f,  //
                                         0.1773783199f, 0.0967841284f, 0.8709122796f};

struct Configuration {
  std::shared_ptr<const OIIO::ColorConfig> read;  // null if there is none
  std::string names;                              // names of its spaces, for error messages
};

Configuration read_configuration() {
  const char* path = std::getenv("OCIO");
  if (!path || !*path) return {};
  Configuration configuration{std::make_shared<const OIIO::ColorConfig>(path), {}};
  for (int i = 0; i < configuration.read->getNumColorSpaces(); ++i)
    configuration.names += (i > 0 ? ", " : "") + std::string(configuration.read->getColorSpaceNameByIndex(i));
  return configuration;
}

const Configuration& configuration() {
  static const Configuration read = read_configuration();
  return read;
}

bool names_a_space(const OIIO::ColorConfig& config, const std::string& name) {
  if (config.getColorSpaceNameByRole(name)) return true;
  for (int i = 0; i < config.getNumColorSpaces(); ++i) {
    const std::string space = config.getColorSpaceNameByIndex(i);
    if (space == name) return true;
    for (const std::string& alias : config.getAliases(space))
      if (alias == name) return true;
  }
  return false;
}

enum class Conversion { to_space, from_space };

Result<OIIO::ColorProcessorHandle> processor_of(const std::string& space, Conversion conversion) {
  constexpr const char* pointer = "/colour_space";
  const OIIO::ColorConfig* config = configuration().read.get();
  if (!config) {
    return failure(Code::invalid, "The server has no OpenColorIO configuration.", pointer,
                   "none, or a server that was started with OCIO in its environment");
  }
  if (!config->getColorSpaceNameByRole(exchange_role)) {
    return failure(Code::invalid, "The server's OpenColorIO configuration names no ACES2065-1.", pointer,
                   std::string("a configuration with the role ") + exchange_role);
  }
  if (!names_a_space(*config, space)) {
    return failure(Code::invalid, "The server's OpenColorIO configuration has no such colour space.", pointer,
                   configuration().names);
  }
  OIIO::ColorProcessorHandle made = conversion == Conversion::to_space
                                        ? config->createColorProcessor(exchange_role, space)
                                        : config->createColorProcessor(space, exchange_role);
  if (!made) return failure(Code::invalid, "Light has no way to that colour space.", pointer, configuration().names);
  return made;
}

void apply(const OIIO::ColorProcessor& processor, glm::vec3& colour) {
  processor.apply(&colour.x, 1, 1, 3, sizeof(float), sizeof(colour), sizeof(colour));
}

}  // namespace

Status to_colour_space(const std::string& space, std::span<float> rgba) {
  const Result<OIIO::ColorProcessorHandle> made = processor_of(space, Conversion::to_space);
  if (!made) return made.status();
  assert(rgba.size() % 4 == 0);
  for (std::size_t at = 0; at < rgba.size(); at += 4) {
    const float alpha = rgba[at + 3] > 0 ? rgba[at + 3] : 1;
    glm::vec3 colour = exchange_from_linear * (glm::vec3(rgba[at], rgba[at + 1], rgba[at + 2]) / alpha);
    apply(**made, colour);
    if (rgba[at + 3] > 0)
      for (int k = 0; k < 3; ++k) rgba[at + static_cast<std::size_t>(k)] = colour[k] * alpha;
  }
  return {};
}

Result<glm::mat3> linear_from_space(const std::string& space) {
  const Result<OIIO::ColorProcessorHandle> made = processor_of(space, Conversion::from_space);
  if (!made) return made.status();
  const auto linear_of = [&](glm::vec3 colour) {
    apply(**made, colour);
    return glm::inverse(exchange_from_linear) * colour;
  };
  const glm::mat3 matrix(linear_of({1, 0, 0}), linear_of({0, 1, 0}), linear_of({0, 0, 1}));
  for (const glm::vec3 probe : {glm::vec3(0.02f), glm::vec3(0.18f, 0.5f, 0.9f), glm::vec3(8, 4, 0.5f)}) {
    const float off = glm::length(linear_of(probe) - matrix * probe);
    if (!(off <= 1e-3f * glm::length(probe))) {
      return failure(Code::invalid, "Light is only read from linear colour spaces.", "/colour_space",
                     "a linear colour space, such as ACEScg");
    }
  }
  return matrix;
}

}  // namespace pelage
