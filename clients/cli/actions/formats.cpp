#include "clients/cli/actions/formats.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace pelage {

namespace {

Result<std::string> format_of(const std::string& path, const ExtensionFormats& formats) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  const auto known =
      std::find_if(formats.begin(), formats.end(), [&](const auto& each) { return each.first == extension; });
  if (known != formats.end()) return std::string(known->second);
  std::string all;
  for (std::size_t k = 1; k < formats.size(); ++k) all += (k > 1 ? " | " : "") + formats[k].first;
  return failure(Code::invalid, "No format has the ending of " + path + "; change it or give --format.", "", all);
}

}  // namespace

Result<Parameters> with_format(Parameters parameters, const std::string& output, const ExtensionFormats& formats) {
  const auto names_format = [](const auto& parameter) { return parameter.first == "format"; };
  if (std::any_of(parameters.begin(), parameters.end(), names_format)) return parameters;
  const Result<std::string> format = format_of(output, formats);
  if (!format) return format.status();
  parameters.emplace_back("format", *format);
  return parameters;
}

}  // namespace pelage
