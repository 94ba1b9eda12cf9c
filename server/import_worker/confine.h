// The only files that assimp sees: those of the upload.
#pragma once

#include <assimp/IOSystem.hpp>
#include <cstddef>
#include <string>

#include "base/status.h"
#include "server/import_worker/bundle.h"

namespace pelage {

/// Gives assimp the model under a name, and the files that are bundled with it. Every other open, and every write,
/// fails and is recorded.
class ClosedIo : public Assimp::IOSystem {
 public:
  ClosedIo(std::string name, const std::string& model, const Bundle& others)
      : name_(std::move(name)), model_(model), others_(others) {}

  bool Exists(const char* file) const override { return bytes_of(file) != nullptr; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

  /// The first other file that was asked for; empty when there was none.
  const std::string& refused() const { return refused_; }

 private:
  const std::string* bytes_of(const char* file) const { return name_ == file ? &model_ : others_.find(file); }

  std::string name_;
  const std::string& model_;
  const Bundle& others_;
  std::string refused_;
};

// Giving up every right that parsing does not need.

/// From here on this process may compute, read and write its three open streams, and end. Opening files, sockets, new
/// processes and threads fail with EPERM. It is ended (SIGXCPU) after `seconds` of processor time, and has at most
/// `memory_bytes` of address space (not under the sanitizers, which map terabytes). Refused (internal) when the
/// kernel does not take one of these.
Status confine(double seconds, std::size_t memory_bytes);

}  // namespace pelage
