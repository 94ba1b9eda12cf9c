// Reads a journal file that anybody may have written. For the confined worker: it reads SQLite's format.
#pragma once

#include <string>

#include "base/status.h"

namespace pelage {

/// The rows (plain_rows.h) of the file's bytes, as the tables of this version have them. Refused (invalid), with the
/// reason: what is damaged or of a version that no exported file has; tables, columns, indexes, views and triggers that
/// are not word for word those of that version; cells of another kind than their column.
Result<std::string> foreign_rows(std::string bytes);

}  // namespace pelage
