// Parses weighted lists such as Accept and Accept-Encoding (RFC 9110 12.4.2 and 12.5).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace pelage {

/// Lower-case names with their weights. Ignores malformed items and items with parameters before the weight. If a name
/// occurs twice, the last one counts.
class AcceptList {
 public:
  explicit AcceptList(std::string_view header);

  /// Returns a weight in [0, 1]; none if the header does not list the lower-case `name`. A wildcard is a name, too.
  std::optional<double> weight(std::string_view name) const;

 private:
  std::map<std::string, double, std::less<>> weights_;
};

}  // namespace pelage
