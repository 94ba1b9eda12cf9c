// The models of the shared folder, and the tables of what is expected of them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocol/commands/scene.h"
#include "server/import/import.h"
#include "server/surface/prepare.h"

namespace pelage::shared_models {

/// Returns shared/meshes, or "" if it does not exist.
std::string folder();

/// A row of a table: column name to cell. `table` returns those under the heading `## title` of the folder's README.md.
using Row = std::map<std::string, std::string>;
std::vector<Row> table(const std::string& title);

/// Returns the pairs that README.md names as equal: "a = b = c" gives (a, b) and (a, c).
std::vector<std::pair<std::string, std::string>> equal_pairs();

std::string read_file(const std::string& path);

/// Returns the format by the file's extension; nothing for files that are no models.
std::optional<ModelFormat> format_of(const std::string& file);

/// Imports a file with the confined worker.
Result<RawModel> import_file(const std::string& path);

/// Imports and prepares a file, with Y up and Z to the front.
Result<Mesh> load_file(const std::string& path);

}  // namespace pelage::shared_models
