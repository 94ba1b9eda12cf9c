// Uploads with a progress line.
#pragma once

#include <string>

#include "clients/cli/session.h"

namespace pelage {

Result<HttpAnswer> put_with_progress(Session& session, const std::string& address, const std::string& bytes);
Result<HttpAnswer> post_with_progress(Session& session, const std::string& address, const std::string& bytes);

}  // namespace pelage
