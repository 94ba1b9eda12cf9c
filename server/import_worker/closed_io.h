// The only files that assimp sees: the bytes of the upload.
#pragma once

#include <assimp/IOSystem.hpp>
#include <string>

namespace pelage {

/// Knows one file by its name; every other open, and every write, fails and is remembered.
class ClosedIo : public Assimp::IOSystem {
 public:
  ClosedIo(std::string name, const std::string& bytes) : name_(std::move(name)), bytes_(bytes) {}

  bool Exists(const char* file) const override { return name_ == file; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

  /// The first other file that was asked for; empty when there was none.
  const std::string& refused() const { return refused_; }

 private:
  std::string name_;
  const std::string& bytes_;
  std::string refused_;
};

}  // namespace pelage
