// Reads an untrusted journal file. Runs in the sandboxed worker only, because it parses SQLite's file format.
#pragma once

#include <string>

#include "base/status.h"

namespace pelage {

/// Returns the rows (plain_rows.h) of a file, upgraded to the tables of this version. Refuses (invalid, with the
/// reason) a damaged file, a version that never exported files, a schema that is not word for word that of its version,
/// and cells of another kind than their column.
Result<std::string> foreign_rows(std::string bytes);

}  // namespace pelage
