#include "clients/cli/actions/formats.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace pelage {

namespace {

Result<std::string> format_of(const std::string& path, const Endings& endings) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto known =
      std::find_if(endings.begin(), endings.end(), [&](const auto& each) { return each.first == ending; });
  if (known != endings.end()) return std::string(known->second);
  std::string all;
  for (std::size_t k = 1; k < endings.size(); ++k) all += (k > 1 ? " | " : "") + endings[k].first;
  return failure(Code::invalid, "No format has the ending of " + path + "; take another, or --format.", "", all);
}

}  // namespace

Result<Parameters> with_format(Parameters parameters, const std::string& output, const Endings& endings) {
  const auto names_format = [](const auto& parameter) { return parameter.first == "format"; };
  if (std::any_of(parameters.begin(), parameters.end(), names_format)) return parameters;
  const Result<std::string> format = format_of(output, endings);
  if (!format) return format.status();
  parameters.emplace_back("format", *format);
  return parameters;
}

}  // namespace pelage
