#include "server/export/gzip.h"

#include <zlib.h>

#include <fstream>
#include <memory>
#include <type_traits>

namespace pelage {

namespace {

constexpr std::size_t piece_bytes = std::size_t{1} << 18;

struct Close {
  void operator()(gzFile file) const { gzclose(file); }
};
using GzipFile = std::unique_ptr<std::remove_pointer_t<gzFile>, Close>;

Status cannot_be_written() {
  return failure(Code::internal, "a temporary file cannot be written; see that TMPDIR has room");
}

}  // namespace

Status compress_file(const std::string& from, const std::string& to, const std::function<void()>& between) {
  std::ifstream input(from, std::ios::binary);
  GzipFile output(gzopen(to.c_str(), "wb"));
  std::string piece(piece_bytes, '\0');
  if (!input || !output) return cannot_be_written();
  while (input.read(piece.data(), static_cast<std::streamsize>(piece.size())) || input.gcount() > 0) {
    if (between) between();
    const auto size = static_cast<unsigned>(input.gcount());
    if (gzwrite(output.get(), piece.data(), size) != static_cast<int>(size)) return cannot_be_written();
  }
  return gzclose(output.release()) == Z_OK ? Status{} : cannot_be_written();
}

}  // namespace pelage
