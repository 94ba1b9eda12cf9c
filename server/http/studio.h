// The contract, the browser client and the reference, built into the program; in a build without node, a page that says
// how to get the client.
#pragma once

#include <span>
#include <string_view>

namespace pelage {

/// All views are of the program's own constants.
struct StudioFile {
  std::string_view path;  // of its address: "/" for the page, "/assets/..." for its files, "/docs/...", "/openapi.json"
  std::string_view type;  // for Content-Type
  std::string_view identity, gzip, brotli;  // its bytes; the compressed forms are empty where they would not be shorter
  std::string_view etag;                    // of what it holds, without quotes
  bool hashed;                              // the name has a hash of the content: what is at this address never changes
};

/// All of them; one is the studio's page.
std::span<const StudioFile> studio_files();

/// Null where there is none.
const StudioFile* find_studio_file(std::string_view path);

}  // namespace pelage
