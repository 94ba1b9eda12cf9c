// Confines the worker: assimp sees only the files of the upload, and the process gives up all rights it does not need.
#pragma once

#include <assimp/IOSystem.hpp>
#include <cstddef>
#include <string>

#include "base/status.h"
#include "server/import_worker/bundle.h"

namespace pelage {

/// Gives assimp the model under a name, and the files that are bundled with it. Opening any other file, or a file for
/// writing, fails and is recorded.
class ClosedIo : public Assimp::IOSystem {
 public:
  ClosedIo(std::string name, const std::string& model, const Bundle& others)
      : name_(std::move(name)), model_(model), others_(others) {}

  bool Exists(const char* file) const override { return bytes_of(file) != nullptr; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

  /// Returns the first file that could not be opened; empty if there was none.
  const std::string& refused() const { return refused_; }

 private:
  const std::string* bytes_of(const char* file) const { return name_ == file ? &model_ : others_.find(file); }

  std::string name_;
  const std::string& model_;
  const Bundle& others_;
  std::string refused_;
};

// Gives up every right that parsing does not need.

/// From this call on the process may only compute, write its answer and its errors, and exit. Reading anything, opening
/// files and sockets, and starting processes and threads, fail with EPERM. The kernel ends it (SIGXCPU) after `seconds`
/// of processor time, and limits it to `memory_bytes` of address space (not under the sanitizers, which map terabytes).
/// Fails (internal) if the kernel rejects one of these limits.
Status confine(double seconds, std::size_t memory_bytes);

}  // namespace pelage
