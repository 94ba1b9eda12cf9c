// What a header like Accept or Accept-Encoding says (RFC 9110 12.4.2 and 12.5).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace pelage {

/// Names in small letters with their weights. Items that cannot be read, and those with parameters beside their weight,
/// are passed over; of one that comes twice the last counts.
class AcceptList {
 public:
  explicit AcceptList(std::string_view header);

  /// In [0, 1]; absent where the header does not name it. A wildcard is a name like others.
  std::optional<double> weight(std::string_view name) const;

 private:
  std::map<std::string, double, std::less<>> weights_;
};

}  // namespace pelage
