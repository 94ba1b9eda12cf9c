#include "server/import_worker/read_saved_scene.h"

#include <zlib.h>

#include <utility>

#include "server/history/foreign_rows.h"
#include "server/import_worker/parse.h"

namespace pelage {

namespace {

/// Decompresses gzip in steps of 1 MiB, so that a small file cannot allocate much at once.
class Unpacker {
 public:
  explicit Unpacker(std::string& packed) {
    constexpr int only_gzip = 16;
    good_ = inflateInit2(&stream_, MAX_WBITS + only_gzip) == Z_OK;
    stream_.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream_.avail_in = static_cast<uInt>(packed.size());
  }
  ~Unpacker() { inflateEnd(&stream_); }
  Unpacker(const Unpacker&) = delete;
  Unpacker& operator=(const Unpacker&) = delete;

  /// Unpacks the file, and stops above `max` bytes. Returns false if the file is damaged or cut off.
  bool unpack(std::string& bytes, std::size_t max) {
    int code = Z_OK;
    while (good_ && code == Z_OK && bytes.size() <= max) {
      const std::size_t size = bytes.size();
      bytes.resize(size + piece_bytes);
      stream_.next_out = reinterpret_cast<Bytef*>(bytes.data() + size);
      stream_.avail_out = piece_bytes;
      code = inflate(&stream_, Z_NO_FLUSH);
      bytes.resize(bytes.size() - stream_.avail_out);
    }
    return good_ && (code == Z_STREAM_END ? stream_.avail_in == 0 : bytes.size() > max);
  }

 private:
  static constexpr uInt piece_bytes = 1u << 20;
  z_stream stream_ = {};
  bool good_ = false;
};

bool is_gzip(const std::string& file) { return file.starts_with("\x1f\x8b"); }

Result<std::string> unpacked(std::string&& file, std::size_t max) {
  if (!is_gzip(file)) return broken("it is not a gzip file.");
  std::string bytes;
  if (!Unpacker(file).unpack(bytes, max)) return broken("it is damaged or cut off.");
  if (bytes.size() > max) return broken("it is larger than " + std::to_string(max) + " bytes unpacked.");
  std::string().swap(file);
  return bytes;
}

}  // namespace

Result<std::string> read_saved_scene(std::string&& file, std::size_t max) {
  Result<std::string> bytes = unpacked(std::move(file), max);
  return bytes ? foreign_rows(std::move(*bytes)) : bytes;
}

}  // namespace pelage
