// The contract, the browser client and the reference, built into the program; in a build without node, a page that says
// how to get the client.
#pragma once

#include <span>
#include <string_view>

namespace pelage {

/// A file built into the program; the views refer to constants.
struct EmbeddedFile {
  std::string_view path;  // its address: "/" for the page, "/assets/..." for its files, "/docs/..." or "/openapi.json"
  std::string_view type;  // for Content-Type
  std::string_view identity, gzip, brotli;  // the content; a compressed form is empty if it would not be shorter
  std::string_view etag;                    // hash of the content, without quotes
  bool hashed;                              // the name has a hash of the content, which therefore never changes
};

/// Returns all files; one is the studio's page.
std::span<const EmbeddedFile> embedded_files();

/// Returns the file at an address; null if there is none.
const EmbeddedFile* find_embedded_file(std::string_view path);

}  // namespace pelage
