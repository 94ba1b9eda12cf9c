#include "server/import_worker/closed_io.h"

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <cstring>
#include <string_view>

namespace pelage {

namespace {

class BytesStream : public Assimp::IOStream {
 public:
  explicit BytesStream(std::string_view bytes) : bytes_(bytes) {}

  std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
    if (size == 0) return 0;
    const std::size_t whole = std::min(count, (bytes_.size() - place_) / size);
    if (whole > 0) std::memcpy(buffer, bytes_.data() + place_, whole * size);
    place_ += whole * size;
    return whole;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const std::size_t base = origin == aiOrigin_SET ? 0 : (origin == aiOrigin_CUR ? place_ : bytes_.size());
    const std::size_t wanted = base + offset;  // wraps for a negative offset, and comes out right
    if (wanted > bytes_.size()) return aiReturn_FAILURE;
    place_ = wanted;
    return aiReturn_SUCCESS;
  }
  std::size_t Tell() const override { return place_; }
  std::size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::string_view bytes_;
  std::size_t place_ = 0;
};

}  // namespace

Assimp::IOStream* ClosedIo::Open(const char* file, const char* mode) {
  if (name_ == file && std::string_view(mode).starts_with('r')) return new BytesStream(bytes_);
  if (refused_.empty()) refused_ = file;
  return nullptr;
}

void ClosedIo::Close(Assimp::IOStream* stream) { delete stream; }

}  // namespace pelage
