// The models of the shared folder and the tables that say what is expected of them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocol/commands/scene.h"
#include "server/import/import.h"
#include "server/surface/prepare.h"

namespace pelage::shared_models {

/// shared/meshes; empty when it is not there.
std::string folder();

/// Rows of the table under the heading `## title` of the folder's README.md: column name to cell.
using Row = std::map<std::string, std::string>;
std::vector<Row> table(const std::string& title);

/// The pairs that README.md names as equal: "a = b = c" gives (a, b) and (a, c).
std::vector<std::pair<std::string, std::string>> equal_pairs();

std::string read_file(const std::string& path);

/// By the file's ending; nothing for files that are no models.
std::optional<ModelFormat> format_of(const std::string& file);

/// Through the confined worker.
Result<RawModel> import_file(const std::string& path);

/// import_file and prepare, Y up and Z to the front.
Result<Mesh> load_file(const std::string& path);

}  // namespace pelage::shared_models
